import type { Piece } from "../marker/marker";
import { say } from "../texts/texts";
import { lengthText, numberText } from "../texts/units";
import { enter, outline, paintLabel, paintPiece, pathAt, type Brush } from "./piece_painter";
import type { Scene, Stroke } from "./scene";

const BOLD = '600 12px "Inter", system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif';

/** Draws a small text on a coloured ground, centred at (x, y). */
function flag(context: CanvasRenderingContext2D, text: string, x: number, y: number, ground: string, ink: string): void {
  context.font = BOLD;
  const half = context.measureText(text).width / 2 + 7;
  context.fillStyle = ground;
  context.beginPath();
  context.rect(x - half, y - 10, 2 * half, 20);
  context.fill();
  context.fillStyle = ink;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(text, x, y + 0.5);
}

/** Draws the end of the marker, its end when the marker was opened, and the cloth saved between them. */
export function paintLength({ context, camera, ratio, colours }: Brush, scene: Scene): void {
  const { marker, opening, length } = scene;
  if (!marker || length <= 0) return;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const [x, bottom] = camera.toScreen([length, 0]);
  const [, top] = camera.toScreen([0, marker.width]);
  const was = opening === undefined ? x : camera.toScreen([opening, 0])[0];
  if (was - x > 0.5) {
    context.fillStyle = colours.gain;
    context.globalAlpha = 0.16;
    context.fillRect(x, top, was - x, bottom - top);
    context.globalAlpha = 1;
    context.strokeStyle = colours.gain;
    context.lineWidth = 1;
    context.setLineDash([3, 4]);
    context.beginPath();
    context.moveTo(was, top);
    context.lineTo(was, bottom);
    context.stroke();
  }
  context.strokeStyle = colours.accent;
  context.lineWidth = 1.5;
  context.setLineDash([7, 4]);
  context.beginPath();
  context.moveTo(x, top - 8);
  context.lineTo(x, bottom + 14);
  context.stroke();
  context.setLineDash([]);
  flag(context, lengthText(length), x, bottom + 24, colours.accent, colours.onAccent);
}

export function paintSelection(brush: Brush, scene: Scene, now: number): void {
  const { colours } = brush;
  const marker = scene.marker!;
  const drawn = (id: string | undefined, draw: (piece: Piece) => void) => {
    const piece = id === undefined ? undefined : marker.byId.get(id);
    if (piece) draw(piece);
  };
  drawn(scene.hovered, (piece) => {
    if (!scene.selection.value.has(piece.id)) outline(brush, piece, scene.poseOf(piece, now), colours.accent, 1.5);
  });
  for (const id of scene.selection.value) {
    drawn(id, (piece) => {
      outline(brush, piece, scene.poseOf(piece, now), colours.halo, 4.5);
      outline(brush, piece, scene.poseOf(piece, now), colours.accent, 2.4);
    });
  }
  drawn(scene.focus, (piece) => outline(brush, piece, scene.poseOf(piece, now), colours.ink, 1.2, [3, 3]));
}

/** Draws unplaced pieces where a result places them, and the one that is being dragged out of the tray. */
export function paintNewcomers(brush: Brush, scene: Scene, labels: boolean): void {
  for (const { piece, pose } of scene.newcomers) paintPiece(brush, piece, pose, scene.colouring.value);
  for (const { piece, pose } of scene.newcomers) paintLabel(brush, piece, pose, labels);
  if (!scene.carried) return;
  const { piece, pose } = scene.carried;
  paintPiece(brush, piece, pose, scene.colouring.value);
  outline(brush, piece, pose, brush.colours.halo, 4.5);
  outline(brush, piece, pose, brush.colours.accent, 2.4);
}

/** Draws the places where an unplaced piece fits; the chosen one is highlighted. */
export function paintPlaces(brush: Brush, scene: Scene): void {
  const { context, camera, colours } = brush;
  scene.places.forEach(({ piece, pose }, k) => {
    const chosen = k === scene.placeAt;
    enter(brush, pose);
    context.fillStyle = colours.accent;
    context.globalAlpha = chosen ? 0.3 : 0.1;
    context.fill(pathAt(piece, camera));
    context.globalAlpha = 1;
    outline(brush, piece, pose, colours.accent, chosen ? 2.4 : 1.4, chosen ? [] : [5, 4]);
  });
}

/** Draws the pieces that other users are dragging, at their current positions. */
export function paintOthersDrags(brush: Brush, scene: Scene): void {
  const { context, camera, ratio, colours } = brush;
  for (const { piece, pose } of scene.draggedByOthers) {
    enter(brush, pose);
    context.fillStyle = colours.other;
    context.globalAlpha = 0.22;
    context.fill(pathAt(piece, camera));
    context.globalAlpha = 1;
    outline(brush, piece, pose, colours.halo, 5);
    outline(brush, piece, pose, colours.other, 2.6);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const { spot } = piece.shape;
    const [x, y] = camera.toScreen(pose.place([spot.x, spot.y]));
    flag(context, say("inOtherHand"), x, y - 24, colours.other, colours.halo);
  }
}

/** Draws the outlines of pieces at the poses of another revision or of a result. */
export function paintGhosts(brush: Brush, scene: Scene): void {
  for (const { piece, pose } of scene.ghosts) outline(brush, piece, pose, brush.colours.ink, 1, [4, 3]);
  for (const [id, pose] of scene.wanted) {
    const piece = scene.marker!.byId.get(id);
    if (piece) outline(brush, piece, pose, brush.colours.accent, 1.4, [5, 4]);
  }
}

/** Draws the overlaps of dragged pieces with others, which are clipped to the exact intersections. */
export function paintOverlaps(brush: Brush, scene: Scene, now: number): void {
  const { context, camera, colours } = brush;
  const marker = scene.marker!;
  const dragged = [...scene.dragged].flatMap((id) => marker.byId.get(id) ?? []);
  for (const piece of scene.free ? dragged : []) {
    const pose = scene.poseOf(piece, now);
    const box = pose.boxOf(piece.shape);
    for (const other of marker.pieces) {
      if (scene.dragged.has(other.id)) continue;
      const { left, right, bottom, top } = other.box;
      if (right <= box.left || left >= box.right || top <= box.bottom || bottom >= box.top) continue;
      context.save();
      enter(brush, pose);
      context.clip(piece.shape.path);
      enter(brush, scene.poseOf(other, now));
      context.fillStyle = colours.fault;
      context.globalAlpha = 0.75;
      context.fill(pathAt(other, camera));
      context.restore();
    }
  }
}

/** Marks the overlaps and the protruding pieces that the daemon has reported. */
export function paintFaults(brush: Brush, scene: Scene): void {
  const { context, camera, ratio, colours } = brush;
  for (const id of scene.outside.slice(0, 500)) {
    const piece = scene.marker!.byId.get(id);
    if (piece) outline(brush, piece, piece.pose, colours.fault, 2.4, [6, 3]);
  }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  for (const { witness, depth } of scene.overlaps.slice(0, 500)) {
    const [x, y] = camera.toScreen(witness);
    context.strokeStyle = colours.fault;
    context.lineWidth = 2;
    context.beginPath();
    context.arc(x, y, 9, 0, 2 * Math.PI);
    context.moveTo(x - 4, y - 4);
    context.lineTo(x + 4, y + 4);
    context.moveTo(x + 4, y - 4);
    context.lineTo(x - 4, y + 4);
    context.stroke();
    if (scene.overlaps.length <= 20 && depth > 0) flag(context, lengthText(depth), x, y + 22, colours.fault, colours.onAccent);
  }
}

/** Writes the worth of a degree of tilt on the selected piece. */
export function paintTiltWorth({ context, camera, ratio, colours }: Brush, scene: Scene, now: number): void {
  const [only, ...others] = scene.selected();
  if (!only || others.length > 0 || only.shape.tiltLimit === 0) return;
  const worth = scene.tilts.find((tilt) => tilt.piece === only.id)?.perDegree;
  if (worth === undefined || scene.dragged.size > 0) return;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const { spot } = only.shape;
  const [x, y] = camera.toScreen(scene.poseOf(only, now).place([spot.x, spot.y]));
  const turn = worth > 0 ? "↺" : "↻";
  flag(context, `${turn} 1° = −${lengthText(Math.abs(worth))}`, x, y + 24, colours.ink, colours.halo);
}

export function paintStroke({ context, camera, ratio, colours }: Brush, { kind, from, to }: Stroke): void {
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const [ax, ay] = camera.toScreen(from);
  const [bx, by] = camera.toScreen(to);
  context.strokeStyle = colours.accent;
  context.lineWidth = 1.5;
  if (kind === "band") {
    context.fillStyle = colours.accent;
    context.globalAlpha = 0.12;
    context.fillRect(ax, ay, bx - ax, by - ay);
    context.globalAlpha = 1;
    context.strokeRect(ax, ay, bx - ax, by - ay);
    return;
  }
  context.beginPath();
  context.moveTo(ax, ay);
  context.lineTo(bx, by);
  if (kind === "gravity") arrowHead(context, ax, ay, bx, by);
  context.stroke();
  if (kind !== "ruler") return;
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const across = `${lengthText(Math.hypot(dx, dy))}   Δx ${lengthText(dx, { unit: false })}  Δy ${lengthText(dy, { unit: false })}`;
  flag(context, `${across}   ${numberText((Math.atan2(dy, dx) * 180) / Math.PI, 1)}°`, (ax + bx) / 2, (ay + by) / 2 - 16, colours.ink, colours.halo);
}

function arrowHead(context: CanvasRenderingContext2D, ax: number, ay: number, bx: number, by: number): void {
  const angle = Math.atan2(by - ay, bx - ax);
  for (const side of [-0.5, 0.5]) {
    context.moveTo(bx, by);
    context.lineTo(bx - 12 * Math.cos(angle + side), by - 12 * Math.sin(angle + side));
  }
}
