import type { Point } from "../../typescript/src/index";
import { isLocked, type Piece } from "../marker/marker";
import type { Pose } from "../marker/pose";
import type { Camera } from "./camera";
import type { Colouring, Palette } from "./palette";

const LABEL = '500 12px "Inter", system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif';
const TINY = 3; // a piece smaller than this many pixels is drawn as a rectangle
const WIDEST = 2.4; // largest width of a label, in radii of the largest circle about its position
const NARROW = 4; // least width of a letter in pixels
const SMALL = 200; // below this size in pixels, an outline with fewer points looks the same

export interface Brush {
  context: CanvasRenderingContext2D;
  camera: Camera;
  ratio: number; // device pixels per CSS pixel
  colours: Palette;
}

/** Sets the canvas transform to the shape's coordinates. */
export function enter({ context, camera, ratio }: Brush, pose: Pose): void {
  const k = camera.scale * ratio;
  const { cos, sin, mirror, x, y } = pose;
  context.setTransform(k * cos, -k * sin, -k * sin * mirror, -k * cos * mirror, ratio * camera.x + k * x, ratio * camera.y - k * y);
}

export const pathAt = (piece: Piece, camera: Camera): Path2D =>
  piece.shape.extent * camera.scale < SMALL ? piece.shape.coarse : piece.shape.path;

/** Draws the outline of a piece in a colour and a width in CSS pixels. */
export function outline(brush: Brush, piece: Piece, pose: Pose, colour: string, width: number, dash: number[] = []): void {
  const { context, camera } = brush;
  enter(brush, pose);
  context.strokeStyle = colour;
  context.lineWidth = width / camera.scale;
  context.setLineDash(dash.map((length) => length / camera.scale));
  context.stroke(pathAt(piece, camera));
  if (dash.length > 0) context.setLineDash([]);
}

export function paintPiece(brush: Brush, piece: Piece, pose: Pose, colouring: Colouring): void {
  const { context, camera, colours } = brush;
  const pixels = piece.shape.extent * camera.scale;
  enter(brush, pose);
  context.fillStyle = piece.rules.zone ? colours.selvedge : colouring.fillOf(piece, colours);
  if (pixels < TINY) {
    const { left, bottom, right, top } = piece.shape.box;
    context.fillRect(left, bottom, right - left, top - bottom);
    return;
  }
  const path = pathAt(piece, camera);
  // Zones that some pieces may use are only tinted, so that pieces in them are visible.
  context.globalAlpha = piece.rules.zone && piece.rules.quality !== undefined ? 0.4 : 1;
  context.fill(path);
  context.globalAlpha = 1;
  if (pixels < 8) return;
  if (piece.rules.zone) {
    outline(brush, piece, pose, colours.fault, 1.4, [5, 3]);
    return;
  }
  context.strokeStyle = colours.line;
  context.lineWidth = (colours.contrast ? 1.6 : 0.9) / camera.scale;
  context.stroke(path);
  if (piece.rules.part) paintPart(brush, piece.rules.part.outline);
}

/** The part of a piece that accepts less of the cloth's quality; the canvas has its coordinates. */
function paintPart({ context, camera, colours }: Brush, corners: readonly Point[]): void {
  context.beginPath();
  for (const [x, y] of corners) context.lineTo(x, y);
  context.closePath();
  context.strokeStyle = colours.chain;
  context.lineWidth = 1.2 / camera.scale;
  context.setLineDash([4 / camera.scale, 2 / camera.scale]);
  context.stroke();
  context.setLineDash([]);
}

/** Draws the grain line, the name and the marks of locks, where there is room for them. */
export function paintLabel(brush: Brush, piece: Piece, pose: Pose, labels: boolean): void {
  const { context, camera, ratio, colours } = brush;
  const { spot } = piece.shape;
  const room = spot.radius * camera.scale;
  if (room < 7) return;
  const [x, y] = camera.toScreen(pose.place([spot.x, spot.y]));
  if (labels && room > 26 && piece.shape.extent * camera.scale > 110) paintGrain(brush, piece, pose);
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  // A zone never moves, which its outline shows already.
  if (piece.locked !== false && !piece.rules.zone) paintLock(context, x, room > 24 && labels ? y - 13 : y, colours, isLocked(piece, "x") && isLocked(piece, "y"));
  if (!labels) return;
  const { text } = labelOf(brush, piece);
  if (text === "") return;
  context.fillStyle = colours.ink;
  context.fillText(text, x, y);
}

/** The name of a piece or, if there is no room for that, its size; "" if there is room for neither. Sets the context up to write it centred at a point. */
export function labelOf({ context, camera }: Brush, { shape: { spot, label, size } }: Piece): { text: string; wide: number } {
  const room = WIDEST * spot.radius * camera.scale;
  context.font = LABEL;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const text of room < 21 ? [] : [label, size || label.slice(0, 8)]) {
    const wide = text.length * NARROW < room ? context.measureText(text).width : room;
    if (wide < room) return { text, wide };
  }
  return { text: "", wide: 0 };
}

function paintGrain(brush: Brush, piece: Piece, pose: Pose): void {
  const { context, camera, colours } = brush;
  const { spot } = piece.shape;
  const half = Math.min(spot.radius * 0.85, 70 / camera.scale);
  const tip = 4 / camera.scale;
  const y = spot.y - 13 / camera.scale;
  enter(brush, pose);
  context.strokeStyle = colours.faint;
  context.lineWidth = 1 / camera.scale;
  context.beginPath();
  context.moveTo(spot.x - half + tip, y + tip * 0.7);
  context.lineTo(spot.x - half, y);
  context.lineTo(spot.x - half + tip, y - tip * 0.7);
  context.moveTo(spot.x - half, y);
  context.lineTo(spot.x + half, y);
  context.moveTo(spot.x + half - tip, y + tip * 0.7);
  context.lineTo(spot.x + half, y);
  context.lineTo(spot.x + half - tip, y - tip * 0.7);
  context.stroke();
}

function paintLock(context: CanvasRenderingContext2D, x: number, y: number, colours: Palette, whole: boolean): void {
  context.fillStyle = colours.ink;
  context.strokeStyle = colours.ink;
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(x, y - 2, 3, Math.PI, 0);
  context.stroke();
  context.beginPath();
  context.rect(x - 5, y - 2, 10, 7);
  if (whole) context.fill();
  else context.stroke();
}
