import type { Point } from "../../typescript/src/index";
import { fill, h, setText } from "../base/dom";
import { follow } from "../base/signal";
import type { Places } from "../engine/places";
import type { Commands } from "../input/commands";
import type { Unplaced } from "../marker/marker";
import { Pose } from "../marker/pose";
import type { Shape } from "../marker/shape";
import type { Desk } from "../session/desk";
import { say, wording } from "../texts/texts";
import type { Scene } from "../view/scene";
import type { Stage } from "../view/stage";
import { heading, note } from "./controls";
import { drawn } from "./icons";

const SLACK = 4; // pixels that a pointer may move in a press
const SVG = "http://www.w3.org/2000/svg";

/**
 * The tray of unplaced pieces, by shape. A piece can be dragged onto the cloth, or pressed to lay it at a free place, or shown in
 * all places where it fits.
 */
export function buildTray(host: HTMLElement, desk: Desk, scene: Scene, stage: Stage, commands: Commands, places: Places): void {
  const rows = h("div", { class: "tray-rows" });
  const found = h("p", { class: "note", id: "places", role: "status" });
  const tray = h("section", { id: "tray", hidden: true }, heading("tray"), note("trayHelp"), rows, found);
  host.prepend(tray);
  follow([places.piece, places.searching, places.changed, wording], () => setText(found, foundText()));
  follow([desk.marker, places.piece, wording], () => {
    const unplaced = desk.marker.value?.unplaced ?? [];
    const byShape = new Map<Shape, Unplaced[]>();
    for (const piece of unplaced) byShape.set(piece.shape, [...(byShape.get(piece.shape) ?? []), piece]);
    tray.hidden = unplaced.length === 0;
    fill(rows, ...[...byShape].map(([shape, pieces]) => rowOf(shape, pieces)));
  });

  function rowOf(shape: Shape, pieces: readonly Unplaced[]): HTMLElement {
    const label = say("trayRow", { name: shape.name, size: shape.size || "–", count: pieces.length });
    const count = h("span", { class: "option-detail" }, `× ${pieces.length}`);
    const button = h("button", { type: "button", class: "tray-row", "aria-label": label, title: label }, thumbnail(shape), h("span", { class: "option-name" }, shape.label), count);
    const [first] = pieces;
    if (first) dragged(button, first);
    const shown = places.piece.value?.shape === shape;
    const where = say("whereItFits", { name: shape.name });
    const act = () => {
      if (shown || !first) return places.end();
      places.show(first);
      stage.top.focus(); // the keys that choose among the places work on the canvas
    };
    const fits = h("button", { type: "button", class: "icon-button", "aria-pressed": String(shown), "aria-label": where, title: where, onclick: act }, drawn("fits"));
    return h("div", { class: "tray-line" }, button, fits);
  }

  function foundText(): string {
    if (!places.piece.value) return "";
    const count = scene.places.length;
    if (places.searching.value) return say("placesSearching", { count });
    return count > 0 ? say("placesFound", { count }) : say("placesNone");
  }

  // During a drag the piece is shown under the pointer; the keyboard and a press lay it in the middle of the view.
  function dragged(button: HTMLElement, piece: Unplaced): void {
    let from: Point | undefined;
    let over: Point | undefined;
    const end = () => {
      from = over = undefined;
      scene.carried = undefined;
      scene.onChange("moving");
    };
    button.addEventListener("pointerdown", (event) => {
      from = [event.clientX, event.clientY];
      button.setPointerCapture(event.pointerId);
    });
    button.addEventListener("pointermove", (event) => {
      if (!from || Math.hypot(event.clientX - from[0], event.clientY - from[1]) < SLACK) return;
      over = clothAt(event);
      scene.carried = over && ghostOf(piece, over);
      scene.onChange("moving");
    });
    button.addEventListener("pointerup", () => {
      const to = over;
      end();
      if (to) void commands.layDown(piece.id, to);
    });
    button.addEventListener("pointercancel", end);
    button.addEventListener("click", (event) => {
      const moved = clothAt(event);
      const middle = scene.camera.value?.toCloth([stage.top.clientWidth / 2, stage.top.clientHeight / 2]);
      if (!moved && middle) void commands.layDown(piece.id, middle);
    });
  }

  function clothAt({ clientX, clientY }: MouseEvent): Point | undefined {
    const { left, top, right, bottom } = stage.top.getBoundingClientRect();
    const inside = clientX > left && clientX < right && clientY > top && clientY < bottom;
    return inside ? scene.camera.value?.toCloth([clientX - left, clientY - top]) : undefined;
  }

  function ghostOf(piece: Unplaced, [x, y]: Point) {
    const box = new Pose(0, 0, piece.rotation, piece.flip, 0).boxOf(piece.shape);
    const pose = new Pose(x - (box.left + box.right) / 2, y - (box.bottom + box.top) / 2, piece.rotation, piece.flip, 0);
    return { piece: scene.marker!.asPlaced(piece, pose), pose };
  }
}

/** A picture of the shape, as large as its row allows. */
function thumbnail({ outline, box }: Shape): SVGSVGElement {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", `${box.left} ${-box.top} ${box.right - box.left} ${box.top - box.bottom}`);
  svg.setAttribute("class", "thumbnail");
  svg.setAttribute("aria-hidden", "true");
  const polygon = document.createElementNS(SVG, "polygon");
  polygon.setAttribute("points", outline.map(([x, y]) => `${x},${-y}`).join(" "));
  svg.append(polygon);
  return svg;
}
