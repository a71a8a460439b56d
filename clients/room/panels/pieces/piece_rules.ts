import type { PieceRules } from "../../../typescript/src/index";
import { h } from "../../base/dom";
import { follow } from "../../base/signal";
import type { Commands } from "../../input/commands";
import { matchAsItLies, type Piece } from "../../marker/marker";
import type { Desk } from "../../session/desk";
import { say, wording, type TextName } from "../../texts/texts";
import { lengthText } from "../../texts/units";
import type { Scene } from "../../view/scene";
import { lengthField, row, showLength } from "../controls";
import { disclosure } from "./disclosure";
import { pointRow } from "./point_row";

const LENGTHS = { below: "ruleBelow", above: "ruleAbove", from: "ruleFrom", to: "ruleTo" } as const;
const NAPS = { up: "ruleNapUp", down: "ruleNapDown" } as const;
type LengthRule = keyof typeof LENGTHS;

/** Fields for the rules of the selected pieces, which restrict where they may lie; they show the rules of the first piece. */
export function buildPieceRules(desk: Desk, scene: Scene, commands: Commands): HTMLElement {
  const set = (change: PieceRules) => void commands.rules(() => change);
  const lengths = (Object.keys(LENGTHS) as LengthRule[]).map((name) => ({ name, field: lengthField((length) => set({ [name]: length }), { id: `rule-${name}`, mayBeEmpty: true }) }));
  const box = (id: string, act: (on: boolean) => void) => {
    const check: HTMLInputElement = h("input", { type: "checkbox", id, onchange: () => act(check.checked) });
    return check;
  };
  const fold = box("rule-fold", (on) => set({ fold: on || undefined }));
  const shade: HTMLInputElement = h("input", { type: "text", size: 10, maxlength: 60, id: "rule-shade", onchange: () => set({ shade: shade.value.trim() || undefined }) });
  const matchSet: HTMLInputElement = h("input", { type: "text", size: 10, maxlength: 60, id: "rule-match-set", onchange: () => set({ matchSet: matchSet.value.trim() || undefined }) });
  const naps = (["up", "down"] as const).map((way) => ({ way, check: box(`rule-nap-${way}`, (on) => set({ nap: on ? way : undefined })) }));
  const zone = box("rule-zone", (on) => set({ zone: on || undefined }));
  const quality: HTMLInputElement = h("input", { type: "number", min: 0, max: 99, step: 1, id: "rule-quality", onchange: () => set({ quality: quality.value === "" ? undefined : Math.round(Number(quality.value)) }) });
  // A piece is matched as it lies: its match point is the point that currently lies at the beginning of a repeat.
  const matched = box("rule-match", (on) => void commands.rules((piece) => (on ? { match: matchAsItLies(desk.marker.value!, piece) } : { match: undefined, matchSet: undefined })));
  const point = pointRow("rule-point", "matchPoint", (change) => void commands.rules(({ rules: { match = [0, 0] } }) => ({ match: change(match) })));
  const { box: element, tell } = disclosure(
    "piece-rules",
    "rules",
    ...lengths.map(({ name, field }) => row(LENGTHS[name], field)),
    row("ruleFold", fold),
    row("ruleShade", shade),
    row("ruleMatch", matched),
    point.row,
    row("ruleMatchSet", matchSet),
    ...naps.map(({ way, check }) => row(NAPS[way], check)),
    row("ruleZone", zone),
    row("ruleQuality", quality),
  );
  follow([scene.selection, desk.marker, desk.figures, wording], () => {
    const [first] = scene.selected();
    if (!first) return;
    const { rules } = first;
    tell(rulesOf(first) || say("rulesNone"));
    for (const { name, field } of lengths) showLength(field, rules[name]);
    const { below = 0, above = 0, repeat } = desk.marker.value ?? {};
    lengths[0]!.field.placeholder = lengthText(below, { unit: false });
    lengths[1]!.field.placeholder = lengthText(above, { unit: false });
    fold.checked = rules.fold ?? false;
    if (document.activeElement !== shade) shade.value = rules.shade ?? "";
    matched.checked = rules.match !== undefined;
    matched.disabled = !repeat && !rules.match;
    point.show(rules.match);
    matchSet.disabled = !rules.match;
    if (document.activeElement !== matchSet) matchSet.value = rules.matchSet ?? "";
    for (const { way, check } of naps) check.checked = rules.nap === way;
    zone.checked = rules.zone ?? false;
    if (document.activeElement !== quality) quality.value = rules.quality === undefined ? "" : String(rules.quality);
  });
  return element;
}

/** A short description of where the piece may lie. */
function rulesOf({ rules: { below, above, from, to, fold, shade, match, matchSet, nap, zone, quality, part } }: Piece): string {
  const lengths = { ruleBelow: below, ruleAbove: above, ruleFrom: from, ruleTo: to };
  const words = Object.entries(lengths).flatMap(([name, length]) => (length === undefined ? [] : [`${say(name as TextName)} ${lengthText(length)}`]));
  if (fold) words.push(say("ruleFold"));
  if (shade) words.push(`${say("ruleShade")} ${shade}`);
  if (match) words.push(matchSet ? `${say("ruleMatchSet")} ${matchSet}` : say("ruleMatch"));
  if (nap) words.push(say(NAPS[nap]));
  if (zone) words.push(say("ruleZone"));
  if (quality !== undefined) words.push(`${say("ruleQuality")} ${quality}`);
  if (part) words.push(`${say("rulePart")} ${part.quality ?? 0}`);
  return words.join(" · ");
}
