import { fill, h, setText } from "../../base/dom";
import { follow } from "../../base/signal";
import type { Engine } from "../../engine/engine";
import type { Insight } from "../../engine/insight";
import type { Commands } from "../../input/commands";
import { isLocked, type Piece } from "../../marker/marker";
import type { Desk } from "../../session/desk";
import { say, wording, type TextName } from "../../texts/texts";
import { areaText, lengthText, numberText } from "../../texts/units";
import type { Scene } from "../../view/scene";
import { heading, lengthField, row, showLength, textButton, worded } from "../controls";
import { buildClothRules } from "./cloth_rules";
import { buildPieceRules } from "./piece_rules";

const CORNERS = [["↖", [-1, 1]], ["↗", [1, 1]], ["↙", [-1, -1]], ["↘", [1, -1]]] as const;
const ALIGN = { left: "alignLeft", right: "alignRight", bottom: "alignBottom", top: "alignTop" } as const;
const SIDES = [["↑", [0, 1]], ["←", [-1, 0]], ["→", [1, 0]], ["↓", [0, -1]]] as const;

/** The panel of the selected pieces, with what can be done to them. */
export function buildPiecePanel(host: HTMLElement, desk: Desk, scene: Scene, insight: Insight, engine: Engine, commands: Commands): void {
  const title = h("h2", { id: "piece-title" });
  const facts = h("dl", { class: "facts" });
  const lockButtons = (["all", "x", "y", "tilt"] as const).map((part) => {
    const names: Record<typeof part, TextName> = { all: "lockPiece", x: "lockX", y: "lockY", tilt: "lockTilt" };
    const button = textButton(names[part], () => void commands.lock(part));
    button.dataset["part"] = part;
    return button;
  });
  const buffer = lengthField((length) => void commands.buffer(length!));
  const overlap = lengthField((length) => void commands.overlap(length), { id: "piece-overlap", mayBeEmpty: true });
  const arrows = h("div", { class: "pad" });
  for (const [sign, way] of SIDES) arrows.append(h("button", { type: "button", class: "button", "data-way": sign, "aria-label": sign, onclick: () => void commands.bump([way[0], way[1]]) }, sign));
  for (const [sign, way] of CORNERS) arrows.append(h("button", { type: "button", class: "button", "data-way": sign, "aria-label": sign, onclick: () => void commands.shoot([way[0], way[1]]) }, sign));
  const turns = h(
    "div",
    { class: "pair" },
    textButton("rotate", () => void commands.rotate(1)),
    textButton("flip", () => void commands.flip()),
    textButton("group", () => void commands.group()),
    textButton("ungroup", () => void commands.ungroup()),
    textButton("takeOff", () => void commands.takeOff()),
  );
  const align = h("div", { class: "segments", id: "align" }, ...(["left", "right", "bottom", "top"] as const).map((side) => textButton(ALIGN[side], () => {
    const pieces = scene.selected().map(({ id }) => id);
    void engine.start("motion.align", { pieces, side }, say(ALIGN[side]));
  })));
  const tools = h("div", { class: "piece-tools" }, h("div", { class: "side-by-side" }, arrows, turns), h("div", { class: "segments locks" }, ...lockButtons), align, row("buffer", buffer), row("overlap", overlap), buildPieceRules(desk, scene, commands));
  const empty = h("p", { class: "note" });
  worded(empty, "noSelection");
  fill(host, title, empty, facts, tools);

  follow([scene.selection, desk.figures, insight.chain, wording], () => {
    const pieces = scene.selected();
    const [first] = pieces;
    empty.hidden = pieces.length > 0;
    title.hidden = facts.hidden = tools.hidden = pieces.length === 0;
    if (!first) return;
    align.hidden = pieces.length < 2;
    setText(title, pieces.length === 1 ? first.shape.name : say("selectedCount", { count: pieces.length }));
    fill(facts, ...(pieces.length === 1 ? factsOf(first, insight) : sums(pieces)).flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
    showLength(buffer, first.buffer);
    showLength(overlap, first.overlap);
    overlap.placeholder = lengthText(desk.marker.value?.overlap ?? 0, { unit: false });
    for (const button of lockButtons) {
      const part = button.dataset["part"] as "all" | "x" | "y" | "tilt";
      const on = pieces.every((piece) => (part === "all" ? piece.locked === true : isLocked(piece, part)));
      button.setAttribute("aria-pressed", String(on));
    }
  });
}

function factsOf(piece: Piece, insight: Insight): Array<[string, string]> {
  const { shape, pose, group } = piece;
  const facts: Array<[string, string]> = [];
  if (shape.size) facts.push([say("size"), shape.size]);
  if (piece.bundle) facts.push([say("bundle"), piece.bundle]);
  facts.push([say("position"), `${lengthText(pose.x, { unit: false })}, ${lengthText(pose.y)}`]);
  facts.push([say("rotation"), `${numberText(pose.rotation, 2, 0)}°${pose.flip ? ` · ${say("flip")}` : ""}`]);
  if (shape.tiltLimit > 0) facts.push([say("tiltAngle"), `${numberText(pose.tilt, 2)}° (± ${numberText(shape.tiltLimit, 1, 0)}°)`]);
  facts.push([say("area"), areaText(shape.area)]);
  if (group) facts.push([say("group"), group]);
  const worth = insight.worth.value.get(piece.id);
  if (worth !== undefined) facts.push([say("worth"), numberText(worth, 2)]);
  const degree = insight.chain.value?.tilts.find((tilt) => tilt.piece === piece.id)?.perDegree;
  if (degree !== undefined && shape.tiltLimit > 0) facts.push([say("degreeWorth"), `${degree > 0 ? "" : "+"}${lengthText(-degree)}`]);
  return facts;
}

const sums = (pieces: readonly Piece[]): Array<[string, string]> => [
  [say("area"), areaText(pieces.reduce((sum, { shape }) => sum + shape.area, 0))],
];

/** The settings of all pieces: their spacing, the overlap allowance, and the cloth. The heading of the piece list follows. */
export function buildSpacing(host: HTMLElement, desk: Desk, commands: Commands): void {
  const spacing = lengthField((length) => void commands.spacing(length!), { id: "spacing" });
  const overlap = lengthField((length) => void commands.allowance(length!), { id: "overlap" });
  host.append(heading("pieces"), row("spacing", spacing), row("overlap", overlap), buildClothRules(desk, commands));
  follow([desk.marker, desk.figures, wording], () => {
    showLength(spacing, desk.marker.value?.spacing ?? 0);
    showLength(overlap, desk.marker.value?.overlap ?? 0);
  });
}
