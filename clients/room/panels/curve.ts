import { fill, h } from "../base/dom";
import type { CurvePoint } from "../engine/engine";
import { say } from "../texts/texts";
import { lengthText, numberText } from "../texts/units";

const SVG = "http://www.w3.org/2000/svg";
const WIDTH = 276;
const HEIGHT = 84;

function shape(name: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  return element;
}

/** A chart of the best length over time, in steps. */
export function drawCurve(host: HTMLElement, points: readonly CurvePoint[]): void {
  if (points.length === 0) return fill(host);
  const longest = Math.max(...points.map(({ length }) => length));
  const shortest = Math.min(...points.map(({ length }) => length));
  const end = Math.max(points[points.length - 1]!.seconds, 0.05);
  const x = (seconds: number) => (seconds / end) * (WIDTH - 2) + 1;
  const y = (length: number) => 6 + ((longest - length) / (longest - shortest || 1)) * (HEIGHT - 12);
  const steps = points.map(({ seconds, length }, k) => (k === 0 ? `M${x(seconds)} ${y(length)}` : `H${x(seconds)}V${y(length)}`)).join("") + `H${WIDTH - 1}`;
  const svg = shape("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "curve", role: "img", "aria-label": say("lengthOverTime") });
  svg.append(shape("path", { d: `${steps}V${HEIGHT}H${x(points[0]!.seconds)}Z`, class: "curve-ground" }), shape("path", { d: steps, class: "curve-line" }));
  const scale = h("div", { class: "curve-scale" }, h("span", {}, lengthText(longest)), h("span", {}, `${numberText(end, 1)} s`), h("strong", {}, lengthText(shortest)));
  fill(host, svg as unknown as HTMLElement, scale);
}
