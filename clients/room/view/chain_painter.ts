import type { Point } from "../../typescript/src/index";
import { numberText } from "../texts/units";
import type { Box } from "../marker/outline";
import { labelOf, type Brush } from "./piece_painter";
import type { Scene } from "./scene";

const LEAST = 0.004; // least worth of a contact that is drawn
const FONT = '600 12px "Inter", system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif';
const HALF = 8; // half of the height of a text, in pixels
// Positions where a contact's worth may be written: on its right or, if that is not free, on its left, above or below.
const SIDES = [
  { dx: 8, dy: 0, part: 0 },
  { dx: -8, dy: 0, part: -1 },
  { dx: 0, dy: -15, part: -0.5 },
  { dx: 0, dy: 15, part: -0.5 },
];

/** Draws the critical path: lines from piece to piece through the points where they touch, as thick as the contact's worth. */
export function paintChain(brush: Brush, scene: Scene, now: number, labels: boolean): void {
  const { context, camera, ratio, colours } = brush;
  const { chain, marker } = scene;
  if (!chain || !marker) return;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const middles = new Map<string, Point>();
  const middleOf = (id: string): Point | undefined => {
    const piece = marker.byId.get(id);
    if (piece && !middles.has(id)) middles.set(id, camera.toScreen(scene.poseOf(piece, now).place([piece.shape.spot.x, piece.shape.spot.y])));
    return middles.get(id);
  };
  const contacts = chain.contacts.filter(({ worth }) => worth >= LEAST);
  context.strokeStyle = colours.chain;
  context.lineCap = "round";
  context.lineJoin = "round";
  for (const contact of contacts) {
    const at = camera.toScreen(contact.at);
    const ends = [middleOf(contact.piece), at, contact.other === undefined ? undefined : middleOf(contact.other)];
    context.globalAlpha = 0.35 + 0.6 * Math.min(1, contact.worth);
    context.lineWidth = 1 + 5 * Math.min(1, contact.worth);
    context.beginPath();
    for (const end of ends) if (end) context.lineTo(...end);
    context.stroke();
  }
  context.globalAlpha = 1;
  context.lineCap = "butt";
  const names = labels ? paintNames(brush, scene, middles) : [];
  paintWorths(brush, contacts.map(({ at, worth }) => ({ at: camera.toScreen(at), worth })), names);
  context.lineJoin = "miter";
}

// Writes the names that the lines have crossed again on top of them. Returns their positions.
function paintNames(brush: Brush, scene: Scene, middles: ReadonlyMap<string, Point>): Box[] {
  const { context, colours } = brush;
  return [...middles].flatMap(([id, [x, y]]) => {
    const { text, wide } = labelOf(brush, scene.marker!.byId.get(id)!);
    if (text === "") return [];
    context.strokeStyle = colours.halo;
    context.lineWidth = 3.5;
    context.strokeText(text, x, y);
    context.fillStyle = colours.ink;
    context.fillText(text, x, y);
    return [{ left: x - wide / 2, right: x + wide / 2, bottom: y - HALF, top: y + HALF }];
  });
}

function paintWorths({ context, camera, colours }: Brush, contacts: ReadonlyArray<{ at: Point; worth: number }>, names: Box[]): void {
  const taken = [...names];
  context.font = FONT;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillStyle = colours.chain;
  context.strokeStyle = colours.halo;
  context.lineWidth = 3.5;
  for (const { at: [x, y], worth } of contacts) {
    context.beginPath();
    context.arc(x, y, 2.5 + 2.5 * Math.min(1, worth), 0, 2 * Math.PI);
    context.fill();
    if (camera.scale < 0.25 || worth < 0.02) continue;
    const text = numberText(worth, 2);
    const wide = context.measureText(text).width;
    const boxes = SIDES.map(({ dx, dy, part }): Box => ({ left: x + dx + part * wide, right: x + dx + (part + 1) * wide, bottom: y + dy - HALF, top: y + dy + HALF }));
    const box = boxes.find((one) => !taken.some((other) => meet(one, other))) ?? boxes[0]!;
    taken.push(box);
    context.strokeText(text, box.left, (box.bottom + box.top) / 2);
    context.fillText(text, box.left, (box.bottom + box.top) / 2);
  }
}

const meet = (a: Box, b: Box): boolean => a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;

/** Draws the cloth that no piece covers; darker where the smallest piece fits. */
export function paintRegions({ context, camera, ratio, colours }: Brush, { regions, fits }: Scene): void {
  if (!regions) return;
  const k = camera.scale * ratio;
  context.setTransform(k, 0, 0, -k, ratio * camera.x, ratio * camera.y);
  context.fillStyle = colours.region;
  regions.regions.forEach(({ outline, holes }, index) => {
    context.globalAlpha = fits.has(index) ? 0.42 : 0.14;
    context.beginPath();
    for (const ring of [outline, ...holes]) {
      ring.forEach(([x, y], corner) => (corner === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
      context.closePath();
    }
    context.fill("evenodd");
  });
  context.globalAlpha = 1;
}
