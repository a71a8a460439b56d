import type { Point } from "../../typescript/src/index";
import { numberText } from "../texts/units";
import type { Brush } from "./piece_painter";
import type { Scene } from "./scene";

/** The critical path: from piece to piece through the points where they touch, as thick as its worth. */
export function paintChain(brush: Brush, scene: Scene, now: number): void {
  const { context, camera, ratio, colours } = brush;
  const { chain, marker } = scene;
  if (!chain || !marker) return;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const middleOf = (id: string): Point | undefined => {
    const piece = marker.byId.get(id);
    if (!piece) return undefined;
    const { x, y } = piece.shape.spot;
    return camera.toScreen(scene.poseOf(piece, now).place([x, y]));
  };
  context.strokeStyle = colours.chain;
  context.lineCap = "round";
  context.lineJoin = "round";
  for (const contact of chain.contacts) {
    if (contact.worth < 0.004) continue;
    const at = camera.toScreen(contact.at);
    const from = middleOf(contact.piece);
    const to = contact.other === undefined ? undefined : middleOf(contact.other);
    context.globalAlpha = 0.35 + 0.6 * Math.min(1, contact.worth);
    context.lineWidth = 1 + 5 * Math.min(1, contact.worth);
    context.beginPath();
    if (from) context.moveTo(...from);
    else context.moveTo(...at);
    context.lineTo(...at);
    if (to) context.lineTo(...to);
    context.stroke();
  }
  context.globalAlpha = 1;
  context.lineCap = "butt";
  context.lineJoin = "miter";
  for (const { at, worth } of chain.contacts) if (worth >= 0.004) paintWorth(brush, camera.toScreen(at), worth);
}

function paintWorth({ context, camera, colours }: Brush, [x, y]: Point, worth: number): void {
  context.fillStyle = colours.chain;
  context.beginPath();
  context.arc(x, y, 2.5 + 2.5 * Math.min(1, worth), 0, 2 * Math.PI);
  context.fill();
  if (camera.scale < 0.25 || worth < 0.02) return;
  const text = numberText(worth, 2);
  context.font = '600 12px "Inter", system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif';
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.strokeStyle = colours.halo;
  context.lineWidth = 3.5;
  context.strokeText(text, x + 8, y);
  context.fillText(text, x + 8, y);
}

/** Cloth that no piece covers; darker where the smallest piece would have the area. */
export function paintRegions(brush: Brush, scene: Scene): void {
  const { context, camera, ratio, colours } = brush;
  const { regions, marker } = scene;
  if (!regions || !marker) return;
  const k = camera.scale * ratio;
  context.setTransform(k, 0, 0, -k, ratio * camera.x, ratio * camera.y);
  const least = Math.min(...marker.pieces.slice(0, 5000).map((piece) => piece.shape.area));
  context.fillStyle = colours.region;
  for (const region of regions.regions) {
    context.globalAlpha = region.area >= least ? 0.34 : 0.15;
    context.beginPath();
    for (const ring of [region.outline, ...region.holes]) {
      ring.forEach(([x, y], index) => (index === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
      context.closePath();
    }
    context.fill("evenodd");
  }
  context.globalAlpha = 1;
}
