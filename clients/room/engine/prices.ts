// The prices of rules, from the dual values that the daemon reports with the critical path.
import type { Answer } from "../../typescript/src/index";
import type { Marker, Piece } from "../marker/marker";
import type { TextName } from "../texts/texts";

/** A rule, and how much shorter the marker would be for each unit by which the rule were relaxed. */
export interface Price {
  readonly text: TextName;
  readonly name: string; // of the piece or shade that has the rule; "" for rules of the marker
  readonly way: string; // an arrow, if the piece would have to move in a certain direction
  readonly piece: string | undefined; // the piece to show for this rule
  readonly worth: number;
}

/** A price of a cloth rule as the daemon reports it: the rule, the piece or shade that has it, and its worth. */
interface RulePrice {
  rule: string;
  piece?: string;
  shade?: string;
  worth: number;
}

const LEAST = 0.0005;
const RULES: Record<string, TextName> = { below: "ruleBelow", above: "ruleAbove", from: "ruleFrom", to: "ruleTo", fold: "ruleFold", shade: "ruleShade", matchX: "ruleMatch", matchY: "ruleMatch" };

/** Everything that costs length, the most expensive first. */
export function pricesOf(chain: Answer<"marker.hold">, marker: Marker): Price[] {
  const nameOf = (id: string) => marker.byId.get(id)?.shape.label ?? id;
  const whole = (text: TextName, worth: number): Price => ({ text, name: "", way: "", piece: undefined, worth });
  const prices = [whole("spacing", chain.perSpacing), whole("priceWidth", loadOnTop(chain))];
  for (const piece of marker.pieces) {
    if (piece.buffer > 0) prices.push({ ...whole("buffer", bufferWorth(chain, piece)), name: piece.shape.label, piece: piece.id });
  }
  for (const { piece, perX, perY } of chain.locks ?? []) {
    const lock = (worth: number, way: string): Price => ({ text: "lockPiece", name: nameOf(piece), way, piece, worth });
    if (perX !== undefined) prices.push(lock(Math.abs(perX), perX < 0 ? "←" : "→"));
    if (perY !== undefined) prices.push(lock(Math.abs(perY), perY < 0 ? "↓" : "↑"));
  }
  const { rules = [] } = chain as { rules?: RulePrice[] };
  for (const { rule, piece, shade, worth } of rules) {
    const name = shade ?? (piece === undefined ? "" : nameOf(piece));
    prices.push({ text: RULES[rule] ?? "ruleOther", name, way: "", piece, worth });
  }
  return prices.filter(({ worth }) => worth >= LEAST).sort((a, b) => b.worth - a.worth);
}

// Increasing the width by a unit moves the upper edge by a unit.
const loadOnTop = ({ contacts }: Answer<"marker.hold">) => contacts.reduce((sum, { edge, worth }) => sum + (edge === "top" ? worth : 0), 0);

const bufferWorth = ({ contacts }: Answer<"marker.hold">, { id }: Piece) =>
  contacts.reduce((sum, { piece, other, worth }) => sum + (other !== undefined && (piece === id || other === id) ? worth : 0), 0);
