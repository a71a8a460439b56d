import type { Point } from "../../typescript/src/index";
import type { Marker, Piece } from "../marker/marker";
import type { Pose } from "../marker/pose";
import { lengthText } from "../texts/units";
import type { Brush } from "./piece_painter";
import type { Scene } from "./scene";

const FONT = '12px "Inter", system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif';
const SHADE = { above: 12, apart: 4 }; // pixels from the cloth to the first line, and from one line to the next

const CLOSEST = 4; // least distance in pixels between two lines of a pattern that is drawn
const BELOW = 12; // pixels from the cloth to a text below it
const LOWER = 38; // the same for a text that would otherwise overlap the marker's length
const WIDE = 90; // texts closer than this to the middle of the length, in pixels, are placed lower
const CROSS = 5; // pixels from the middle of a match point's cross to its ends

/** Draws the rules that restrict where pieces may lie: selvedges, the fold, the ends of bands, and the extent of each shade. */
export function paintRules(brush: Brush, scene: Scene, width: number): void {
  const { context, camera, ratio, colours } = brush;
  const marker = scene.marker!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const from = Math.max(camera.x, 0);
  const to = marker.longest === undefined ? width : Math.min(width, camera.toScreen([marker.longest, 0])[0]);
  if (to <= from) return;
  const across = (y: number) => camera.toScreen([0, y])[1];
  context.fillStyle = colours.selvedge;
  context.globalAlpha = 0.45;
  if (marker.below > 0) context.fillRect(from, across(marker.below), to - from, across(0) - across(marker.below));
  if (marker.above > 0) context.fillRect(from, across(marker.width), to - from, across(marker.width - marker.above) - across(marker.width));
  context.globalAlpha = 1;
  const { tube } = marker.document.strip;
  const folds = tube ? [0, marker.width] : marker.pieces.some(({ rules }) => rules.fold) ? [0] : [];
  for (const y of folds) line(brush, [from, across(y)], [to, across(y)], colours.ink, 2.4, [10, 3, 2, 3]);
  const ends = new Set(marker.pieces.flatMap(({ rules }) => [rules.from, rules.to]));
  for (const end of ends) {
    if (end === undefined) continue;
    const [x] = camera.toScreen([end, 0]);
    if (x < 0 || x > width) continue;
    line(brush, [x, across(marker.width)], [x, across(0)], colours.other, 1.2, [6, 3]);
    context.font = FONT;
    context.textAlign = "center";
    context.textBaseline = "top";
    context.fillStyle = colours.other;
    const beside = Math.abs(x - camera.toScreen([scene.length, 0])[0]) > WIDE;
    context.fillText(lengthText(end), x, across(0) + (beside ? BELOW : LOWER)); // not on the cloth, where pieces would cover it
  }
  if (marker.shade !== undefined) paintShades(brush, marker, width);
}

/** Draws the pattern of the cloth over the pieces: dotted lines where repeats begin. */
export function paintPattern({ context, camera, ratio, colours }: Brush, { repeat, width, longest }: Marker, viewWidth: number): void {
  if (!repeat) return;
  const [left, bottom] = camera.toScreen([0, 0]);
  const [, top] = camera.toScreen([0, width]);
  const right = longest === undefined ? viewWidth : Math.min(viewWidth, camera.toScreen([longest, 0])[0]);
  const from = Math.max(left, 0);
  const [x, y] = camera.toScreen(repeat.phase);
  const everyX = repeat.along * camera.scale;
  const everyY = repeat.across * camera.scale;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.strokeStyle = colours.accent;
  context.lineWidth = 1;
  context.setLineDash([1, 4]);
  context.beginPath();
  if (everyX >= CLOSEST) for (let k = Math.ceil((from - x) / everyX); x + k * everyX <= right; ++k) segment(context, x + k * everyX, top, x + k * everyX, bottom);
  if (everyY >= CLOSEST) for (let k = Math.ceil((top - y) / everyY); y + k * everyY <= bottom; ++k) segment(context, from, y + k * everyY, right, y + k * everyY);
  context.stroke();
  context.setLineDash([]);
}

function segment(context: CanvasRenderingContext2D, ax: number, ay: number, bx: number, by: number): void {
  context.moveTo(ax, ay);
  context.lineTo(bx, by);
}

/** Draws the match points of pieces, each of which lies where a repeat of the pattern begins. */
export function paintMatchPoints(brush: Brush, pieces: readonly Piece[], poseOf: (piece: Piece) => Pose): void {
  const { context, camera, ratio, colours } = brush;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  for (const piece of pieces) {
    const { match } = piece.rules;
    if (!match) continue;
    const [x, y] = camera.toScreen(poseOf(piece).place(match));
    line(brush, [x - CROSS, y], [x + CROSS, y], colours.ink, 1.6, []);
    line(brush, [x, y - CROSS], [x, y + CROSS], colours.ink, 1.6, []);
  }
}

// Draws a line above the cloth from the left end of a shade's first piece to the right end of its last.
function paintShades(brush: Brush, marker: Marker, width: number): void {
  const { context, camera, colours } = brush;
  const reaches = new Map<string, { left: number; right: number }>();
  for (const { rules, box } of marker.pieces) {
    if (!rules.shade) continue;
    const known = reaches.get(rules.shade) ?? box;
    reaches.set(rules.shade, { left: Math.min(known.left, box.left), right: Math.max(known.right, box.right) });
  }
  const [, top] = camera.toScreen([0, marker.width]);
  let y = top - SHADE.above;
  for (const [name, { left, right }] of reaches) {
    const [from] = camera.toScreen([left, 0]);
    const [to] = camera.toScreen([right, 0]);
    if (to < 0 || from > width) continue;
    // The tolerance covers the rounding of the document's decimals.
    const tooLong = right - left > marker.shade! * (1 + 1e-9);
    line(brush, [from, y], [to, y], tooLong ? colours.fault : colours.chain, 2, []);
    context.font = FONT;
    context.textAlign = "left";
    context.textBaseline = "bottom";
    context.fillStyle = tooLong ? colours.fault : colours.chain;
    context.fillText(name, Math.max(from, 2), y - 1);
    y -= SHADE.apart;
  }
}

/** Draws the area to which their rules restrict the selected pieces. */
export function paintRooms(brush: Brush, scene: Scene): void {
  const { context, camera, ratio, colours } = brush;
  const marker = scene.marker!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  for (const { rules } of scene.selected().slice(0, 8)) {
    const { from, to, below = marker.below, above = marker.above, fold } = rules;
    if (from === undefined && to === undefined && rules.below === undefined && rules.above === undefined && !fold) continue;
    const [left, bottom] = camera.toScreen([from ?? marker.margin, fold ? 0 : below]);
    const [right, top] = camera.toScreen([to ?? marker.longest ?? scene.length, marker.width - above]);
    context.strokeStyle = colours.accent;
    context.lineWidth = 1.6;
    context.setLineDash([8, 4]);
    context.strokeRect(left, top, right - left, bottom - top);
    context.setLineDash([]);
  }
}

function line({ context }: Brush, [ax, ay]: Point, [bx, by]: Point, colour: string, width: number, dash: number[]): void {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.beginPath();
  segment(context, ax, ay, bx, by);
  context.stroke();
  context.setLineDash([]);
}
