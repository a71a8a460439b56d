// The marker room, a page that shows one marker at a time, built on the TypeScript client.
import type { Point } from "../typescript/src/index";
import { h } from "./base/dom";
import { follow, Signal } from "./base/signal";
import { Engine } from "./engine/engine";
import { Insight } from "./engine/insight";
import { Places } from "./engine/places";
import { Commands } from "./input/commands";
import { listenForKeys } from "./input/keys";
import { Pointer } from "./input/pointer";
import { Settling } from "./input/settling";
import type { Piece } from "./marker/marker";
import type { Pose } from "./marker/pose";
import { worded } from "./panels/controls";
import { askForToken, openHelp, openSettings } from "./panels/dialogs";
import { buildEnginePanel, buildOffer } from "./panels/engine_panel";
import { buildHeader } from "./panels/header";
import { buildLengthPanel } from "./panels/length_panel";
import { openMenu } from "./panels/menu";
import { buildPieceList } from "./panels/pieces/piece_list";
import { buildPiecePanel, buildSpacing } from "./panels/pieces/piece_panel";
import { announceFigures, buildStatus, messageDisplay } from "./panels/status";
import { buildTabs } from "./panels/tabs";
import { buildLegend, buildToolbar } from "./panels/toolbar";
import { buildTray } from "./panels/tray";
import { markerInAddress, putInAddress } from "./session/address";
import { Desk } from "./session/desk";
import { Library } from "./session/library";
import { Link } from "./session/link";
import { MarkerFiles } from "./session/marker_files";
import { methodText } from "./session/messages";
import { say } from "./texts/texts";
import { lengthText, measureIn } from "./texts/units";
import { times } from "./view/frame_times";
import { Overview } from "./view/overview";
import { Scene } from "./view/scene";
import { Stage } from "./view/stage";
import "./styles/room.css";

const element = <T extends HTMLElement>(id: string) => document.getElementById(id) as T;

const link = new Link();
const desk = new Desk(link);
const scene = new Scene();
const showMessage = messageDisplay(element("toast"));
const stage = new Stage(element("stage"), element<HTMLCanvasElement>("base"), element<HTMLCanvasElement>("top"), scene);
const overview = new Overview(element<HTMLCanvasElement>("overview"), scene, stage);
const engine = new Engine(desk, scene, showMessage);
const insight = new Insight(desk, scene);
const places = new Places(desk, scene);
const settling = new Settling(desk, showMessage);
const commands = new Commands(desk, scene, engine, settling, showMessage);
const pointer = new Pointer(stage.top, stage, scene, desk, engine, places, commands, settling, showMessage);
const library = new Library(desk, showMessage);
const files = new MarkerFiles(desk, showMessage, element("dropzone"));
const keepsNothing = new Signal(false);

function buildPage(): void {
  worded(stage.top, "canvas", "aria-label");
  worded(element("overview"), "overview", "aria-label");
  element("overview").setAttribute("role", "img");
  const menu = (from: HTMLElement) => void openMenu(from, desk, library, files);
  buildHeader(element("header"), desk, engine, commands, { menu, settings: openSettings, help: openHelp });
  buildToolbar(element("toolbar"), stage, insight);
  buildOffer(element("offer"), desk, engine);
  buildTray(element("panel"), desk, scene, stage, commands, places);
  const { open, panels } = buildTabs(element("panel"), ["engine", "pieces", "length"]);
  buildEnginePanel(panels.engine, desk, engine, library, scene, stage);
  buildPiecePanel(panels.pieces, desk, scene, insight, engine, commands);
  buildSpacing(panels.pieces, desk, commands);
  buildPieceList(panels.pieces, desk, scene, stage, insight);
  buildLengthPanel(panels.length, desk, scene, insight);
  open.follow((name) => (insight.wanted = name !== "engine"));
  const legend = h("span", { id: "legend" });
  buildLegend(legend, scene);
  buildStatus(element("status"), desk, keepsNothing, legend);
  announceFigures(element("live"), desk);
  askForToken(link);
  listenForKeys(stage.top, { stage, scene, engine, insight, places, commands, pointer, save: () => files.save(), help: openHelp, showMessage });
}

// Shows the current marker, and every change of it, on the canvas.
function connectScene(): void {
  desk.marker.follow((marker) => {
    if (!marker) return;
    measureIn(marker.unit);
    const isNew = scene.marker?.document !== marker.document && location.hash !== `#${desk.markerId}`;
    scene.opening = desk.opening?.figures.length;
    scene.length = desk.figures.value.length;
    scene.show(marker);
    // A long marker gets an overview, which shows all of it.
    document.querySelector<HTMLElement>("main")!.dataset["strip"] = stage.isLong ? "yes" : "";
    if (isNew || !scene.camera.value) stage.fit(!stage.isLong);
    putInAddress(desk.markerId);
    overview.renew();
  });
  desk.figures.follow(({ length, valid, revision }) => {
    if (!engine.preview.value && scene.dragged.size === 0) scene.length = length;
    scene.opening = desk.opening?.figures.length;
    scene.overlaps = [];
    scene.outside = [];
    if (!valid) void showFaults(revision);
    overview.renew();
  });
  desk.changed.follow((change) => {
    if (!change) return;
    const from = new Map([...change.before].map(([id, pose]) => [id, scene.shown.get(id) ?? pose]));
    scene.fly(from);
    if (change.by === "reopened" || change.by === "refreshed") showMessage(say(change.by === "reopened" ? "reopened" : "reconnected"));
    else if (change.by === "closed") showMessage(say("closedElsewhere"));
    else if (!change.mine) showMessage(say("changedBy", { what: methodText(change.by), length: lengthText(desk.figures.value.length) }));
  });
  follow([desk.draggedByOthers, desk.marker, desk.figures], () => {
    scene.draggedByOthers = desk.draggedByOthers.value.flatMap(({ piece, at }) => scene.marker?.draggedTo(piece, at) ?? []);
    scene.onChange("moving");
  });
  // While pieces are nested, the view is fitted to the growing marker.
  engine.preview.follow(() => scene.newcomers.length > 0 && stage.fit(!stage.isLong));
  scene.colouring.follow(() => overview.renew());
}

async function showFaults(revision: number): Promise<void> {
  const client = await link.ready();
  const check = await client.call("marker.check", { markerId: desk.markerId, deadlineMs: 10_000 }).catch(() => undefined);
  if (!check || check.revision !== revision || desk.figures.value.revision !== revision) return;
  scene.overlaps = check.overlaps;
  scene.outside = [...check.protrusions.map(({ piece }) => piece), ...(check.shades ?? []).flatMap(({ leftmost, rightmost }) => [leftmost, rightmost])];
  scene.onChange("moving");
}

async function start(): Promise<void> {
  buildPage();
  connectScene();
  await files.openFirst(markerInAddress());
  addEventListener("hashchange", () => void files.openNamed(markerInAddress()));
  const { durable } = await (await link.ready()).call("engine.info", {});
  keepsNothing.value = !durable;
}

// The position of a piece's label on the screen when the piece is at the pose.
function onScreen({ shape }: Piece, pose: Pose): Point | undefined {
  if (!scene.camera.value) return undefined;
  const { left, top } = stage.top.getBoundingClientRect();
  const [x, y] = scene.camera.value.toScreen(pose.place([shape.spot.x, shape.spot.y]));
  return [x + left, y + top];
}

// For tests and measurements: the state of the page, the position of a piece on the screen, and the times of frames and answers.
Object.assign(globalThis, {
  selvageRoom: {
    times,
    revision: () => desk.figures.value.revision,
    view: () => {
      const camera = scene.camera.value;
      return camera && { markerId: desk.markerId, shown: scene.shown.size, selected: [...scene.selection.value], outlined: scene.ghosts.length, length: scene.length, scale: camera.scale, origin: [camera.x, camera.y] };
    },
    spotOf(id: string) {
      const piece = scene.marker?.byId.get(id);
      return piece && onScreen(piece, scene.poseOf(piece, performance.now()));
    },
    places: () =>
      scene.places.map(({ piece, pose }, k) => {
        const [x, y] = onScreen(piece, pose)!;
        return { x, y, at: [pose.x, pose.y], chosen: k === scene.placeAt };
      }),
    draggedByOthers: () => scene.draggedByOthers.map(({ piece }) => piece.id),
  },
});
void start();
