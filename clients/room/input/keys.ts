import type { Point } from "../../typescript/src/index";
import { prefer, preferences } from "../base/preferences";
import type { Engine } from "../engine/engine";
import type { Insight } from "../engine/insight";
import type { Places } from "../engine/places";
import { say } from "../texts/texts";
import { lengthText } from "../texts/units";
import type { Scene } from "../view/scene";
import type { Stage } from "../view/stage";
import type { Commands } from "./commands";
import type { Pointer } from "./pointer";
import { extentOf, gravity, openGapTowards, tool, type Tool } from "./tools";

const ARROWS: Record<string, Point> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
// These keys form a rectangle on a keyboard: upper left, lower left, upper right, lower right.
const CORNERS: Record<string, Point> = { Home: [-1, 1], End: [-1, -1], PageUp: [1, 1], PageDown: [1, -1] };
const TOOLS: Record<string, Tool> = { v: "select", m: "ruler", g: "gap", a: "gravity" };

export interface Parts {
  stage: Stage;
  scene: Scene;
  engine: Engine;
  insight: Insight;
  places: Places;
  commands: Commands;
  pointer: Pointer;
  save(): void;
  help(): void;
  showMessage(text: string): void;
}

/** Handles all keys, except in fields and open dialogues. */
export function listenForKeys(canvas: HTMLElement, parts: Parts): void {
  addEventListener("pointerdown", () => (document.body.dataset["keys"] = ""), true);
  addEventListener("keydown", (event) => {
    if (event.key === "Tab") document.body.dataset["keys"] = "yes";
    const target = event.target as HTMLElement;
    if (event.defaultPrevented || target.closest("input, select, textarea, dialog")) return;
    const onControl = target.closest("button, a, summary, [role=option], [role=tab], [role=menuitem]") !== null;
    if (onControl && ["Enter", " ", "Tab", ...Object.keys(ARROWS), ...Object.keys(CORNERS)].includes(event.key)) return;
    const act = event.ctrlKey || event.metaKey ? withControl(event, parts) : plain(event, canvas, parts);
    if (!act) return;
    event.preventDefault();
    act();
  });
  addEventListener("keyup", (event) => {
    if (event.key === " ") parts.pointer.panning = false;
  });
}

function withControl(event: KeyboardEvent, { commands, save }: Parts): (() => void) | undefined {
  switch (event.key.toLowerCase()) {
    case "z": return () => void (event.shiftKey ? commands.redo() : commands.undo());
    case "y": return () => void commands.redo();
    case "a": return () => commands.selectAll();
    case "s": return save;
    default: return undefined;
  }
}

function plain(event: KeyboardEvent, canvas: HTMLElement, parts: Parts): (() => void) | undefined {
  const { stage, scene, engine, insight, commands, pointer } = parts;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const place = amongPlaces(key, parts);
  if (place) return place;
  const arrow = ARROWS[key];
  if (arrow) {
    const drawn = byArrow(arrow, parts);
    if (drawn) return drawn;
    if (scene.selection.value.size === 0) return () => stage.look(scene.camera.value!.panned(-arrow[0] * 60, arrow[1] * 60));
    return () => void (event.shiftKey ? commands.nudge(arrow) : commands.bump(arrow));
  }
  const corner = CORNERS[key];
  if (corner) return () => void commands.shoot(corner);
  const chosen = TOOLS[key];
  if (chosen) return () => (tool.value = chosen);
  switch (key) {
    case "Tab": {
      // At the first and the last piece, Tab leaves the marker, so that the canvas is not a keyboard trap.
      if (event.target !== canvas || atTheEnd(scene, event.shiftKey)) return undefined;
      return () => commands.step(event.shiftKey ? -1 : 1);
    }
    case "Escape": return () => void (pointer.cancel() || dropOrDeselect(parts));
    case "Enter": return engine.preview.value ? () => void engine.take() : undefined;
    case "k": return () => engine.keepBeside();
    case "c": return () => void engine.start("motion.compact", { accuracy: "standard" }, say("compact"));
    case "r": return () => void commands.rotate(event.shiftKey ? -1 : 1);
    case "f": return () => void commands.flip();
    case "l": return () => void commands.lock("all");
    case "u": return () => void (event.shiftKey ? commands.ungroup() : commands.group());
    case "Delete": case "Backspace": return () => void commands.takeOff();
    case "[": return () => void commands.tilt(1);
    case "]": return () => void commands.tilt(-1);
    case "h": return () => (insight.chainShown.value = !insight.chainShown.value);
    case "e": return () => (insight.regionsShown.value = !insight.regionsShown.value);
    case "p": return () => prefer({ dragMode: preferences.value.dragMode === "push" ? "place" : "push" });
    case "0": return () => stage.fit();
    case "+": case "=": return () => stage.zoom(1.25);
    case "-": return () => stage.zoom(0.8);
    case "?": return parts.help;
    case " ": return () => (pointer.panning = true);
    default: return undefined;
  }
}

// Applies the current tool in the direction of an arrow key.
function byArrow(way: Point, { engine, scene, showMessage }: Parts): (() => void) | undefined {
  const { marker } = scene;
  const chosen = tool.value;
  if (!marker || chosen === "select") return undefined;
  if (chosen === "ruler") return () => measureTowards(scene, way, showMessage);
  return () => {
    tool.value = "select";
    void (chosen === "gap" ? openGapTowards(engine, marker, scene.selected(), scene.length, way) : gravity(engine, [0, 0], way));
  };
}

// Measures the selected pieces, or the marker, in the direction of an arrow key, and shows the length.
function measureTowards(scene: Scene, way: Point, showMessage: (text: string) => void): void {
  const { left, right, bottom, top } = extentOf(scene.marker!, scene.selected(), scene.length);
  const middle: Point = [(left + right) / 2, (bottom + top) / 2];
  const half: Point = [(way[0] * (right - left)) / 2, (way[1] * (top - bottom)) / 2];
  scene.stroke = { kind: "ruler", from: [middle[0] - half[0], middle[1] - half[1]], to: [middle[0] + half[0], middle[1] + half[1]] };
  scene.onChange("moving");
  showMessage(say("measured", { length: lengthText(2 * Math.hypot(...half)) }));
}

// While places of an unplaced piece are shown, keys choose among them.
function amongPlaces(key: string, { places, scene, stage, commands }: Parts): (() => void) | undefined {
  const piece = places.piece.value;
  if (!piece) return undefined;
  const chosen = scene.places[scene.placeAt];
  const step = (by: 1 | -1) => () => {
    places.step(by);
    const next = scene.places[scene.placeAt];
    if (next) stage.reveal(next.piece.box);
  };
  switch (key) {
    case "ArrowLeft": case "ArrowUp": return step(-1);
    case "ArrowRight": case "ArrowDown": return step(1);
    case "Enter": return chosen && (() => void commands.layAt(piece.id, chosen.pose));
    case "Escape": return () => places.end();
    default: return undefined;
  }
}

function dropOrDeselect({ engine, scene }: Parts): void {
  if (engine.run.value) engine.run.value.stop();
  else if (engine.preview.value) engine.drop();
  else if (tool.value !== "select") tool.value = "select";
  else scene.select([]);
}

function atTheEnd(scene: Scene, backwards: boolean): boolean {
  const [selected] = scene.selected();
  const pieces = scene.marker?.pieces ?? [];
  if (!selected || pieces.length === 0) return pieces.length === 0;
  const before = (a: typeof selected, b: typeof selected) => a.box.left - b.box.left || a.box.bottom - b.box.bottom || a.index - b.index;
  return backwards ? pieces.every((piece) => before(selected, piece) <= 0) : pieces.every((piece) => before(selected, piece) >= 0);
}
