import type { Preferences } from "../base/preferences";
import { lengthText, unitOf } from "../texts/units";
import type { Brush } from "./piece_painter";
import type { Scene } from "./scene";

const FONT = '12px "Inter", system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif';
const RULER = 26; // height of the ruler at the upper edge, in pixels
const BAND = 7; // height of the selvedge, in pixels

/** A step of 1, 2 or 5 times a power of ten that is at least this many pixels long. */
export function niceStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5, 10].find((factor) => factor * power >= least) ?? 10);
}

/** Draws the cloth: its selvedges, its grid, its end, and the line in its middle. */
export function paintCloth(brush: Brush, scene: Scene, width: number, height: number, chosen: Preferences): void {
  const { context, camera, ratio, colours } = brush;
  const marker = scene.marker!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const [left, bottom] = camera.toScreen([0, 0]);
  const [, top] = camera.toScreen([0, marker.width]);
  const end = marker.longest === undefined ? width : camera.toScreen([marker.longest, 0])[0];
  const from = Math.max(left, 0);
  const to = Math.min(end, width);
  if (to <= from) return;
  context.fillStyle = colours.cloth;
  context.fillRect(from, top, to - from, bottom - top);
  paintGrid(brush, scene, from, to, top, bottom);
  if (chosen.middle) paintMiddle(brush, scene, from, to);
  paintSelvedge(brush, from, to, top - BAND);
  paintSelvedge(brush, from, to, bottom);
  context.strokeStyle = colours.faint;
  context.lineWidth = 1;
  context.beginPath();
  if (left >= 0) {
    context.moveTo(left, top - BAND);
    context.lineTo(left, bottom + BAND);
  }
  if (marker.longest !== undefined && end <= width) {
    context.moveTo(end, top - BAND);
    context.lineTo(end, bottom + BAND);
  }
  context.stroke();
}

function paintGrid({ context, camera, colours }: Brush, scene: Scene, from: number, to: number, top: number, bottom: number): void {
  const step = niceStep(80 / camera.scale / unitOf(scene.marker!)) * unitOf(scene.marker!);
  context.strokeStyle = colours.grid;
  context.lineWidth = 1;
  context.beginPath();
  for (let k = Math.ceil((from - camera.x) / camera.scale / step); camera.x + k * step * camera.scale <= to; ++k) {
    const x = Math.round(camera.x + k * step * camera.scale) + 0.5;
    context.moveTo(x, top);
    context.lineTo(x, bottom);
  }
  context.stroke();
}

function paintMiddle({ context, camera, colours }: Brush, scene: Scene, from: number, to: number): void {
  const [, y] = camera.toScreen([0, scene.marker!.width / 2]);
  context.strokeStyle = colours.accent;
  context.setLineDash([12, 4, 2, 4]);
  context.beginPath();
  context.moveTo(from, y);
  context.lineTo(to, y);
  context.stroke();
  context.setLineDash([]);
}

// Draws the finished edge of woven cloth, with a stitch every 12 pixels.
function paintSelvedge({ context, camera, colours }: Brush, from: number, to: number, y: number): void {
  context.fillStyle = colours.selvedge;
  context.fillRect(from, y, to - from, BAND);
  context.strokeStyle = colours.cloth;
  context.lineWidth = 1;
  context.beginPath();
  const phase = ((camera.x % 12) + 12) % 12;
  for (let x = from - ((from - phase) % 12); x < to; x += 12) {
    if (x < from) continue;
    context.moveTo(x, y + BAND - 1.5);
    context.lineTo(Math.min(to, x + 4), y + 1.5);
  }
  context.stroke();
}

/** Draws the ruler along the upper edge, in the unit that the user chose. */
export function paintRuler({ context, camera, ratio, colours }: Brush, scene: Scene, width: number, paper: string): void {
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.fillStyle = paper;
  context.fillRect(0, 0, width, RULER);
  const unit = unitOf(scene.marker!);
  const step = niceStep(90 / camera.scale / unit) * unit;
  context.strokeStyle = colours.faint;
  context.fillStyle = colours.faint;
  context.font = FONT;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.lineWidth = 1;
  context.beginPath();
  const first = Math.max(0, Math.floor(-camera.x / camera.scale / step));
  for (let k = first * 5; ; ++k) {
    const x = Math.round(camera.x + (k * step * camera.scale) / 5) + 0.5;
    if (x > width) break;
    if (x < 0) continue;
    context.moveTo(x, k % 5 === 0 ? 6 : RULER - 5);
    context.lineTo(x, RULER);
    if (k % 5 === 0) context.fillText(lengthText((k / 5) * step, { unit: false, digits: 0, significant: step / unit < 1 }), x + 4, 12);
  }
  context.stroke();
}
