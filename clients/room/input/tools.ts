import type { Force, Point } from "../../typescript/src/index";
import type { Engine } from "../engine/engine";
import type { Marker, Piece } from "../marker/marker";
import type { Box } from "../marker/outline";
import { say } from "../texts/texts";
import { Signal } from "../base/signal";

export type Tool = "select" | "ruler" | "gap" | "gravity";
export const tool = new Signal<Tool>("select");

/** Pushes the pieces on both sides of a line away from it; other pieces move only to make way. */
export function openGap(engine: Engine, marker: Marker, from: Point, to: Point): Promise<void> {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  const normal: Point = [-dy / length, dx / length];
  const forces = marker.pieces.flatMap(({ id, shape, pose, locked }): Force[] => {
    if (locked === true) return [];
    const [x, y] = pose.place([shape.spot.x, shape.spot.y]);
    const along = ((x - from[0]) * dx + (y - from[1]) * dy) / length;
    if (along < 0 || along > length) return [];
    const side = Math.sign((x - from[0]) * normal[0] + (y - from[1]) * normal[1]) || 1;
    return [{ piece: id, force: [normal[0] * side, normal[1] * side] }];
  });
  if (forces.length === 0) return Promise.resolve();
  return engine.start("motion.push", { forces }, say("toolGap").replace(/:.*/, ""));
}

/** The bounding box of the pieces or, if there are none, of the marker. */
export function extentOf(marker: Marker, pieces: readonly Piece[], length: number): Box {
  const boxes = pieces.length > 0 ? pieces.map(({ box }) => box) : [{ left: 0, right: length, bottom: 0, top: marker.width }];
  return {
    left: Math.min(...boxes.map(({ left }) => left)),
    right: Math.max(...boxes.map(({ right }) => right)),
    bottom: Math.min(...boxes.map(({ bottom }) => bottom)),
    top: Math.max(...boxes.map(({ top }) => top)),
  };
}

/** Opens a gap without a pointer: along the line through the middle of the selected pieces, or of the marker, perpendicular to `way`. */
export function openGapTowards(engine: Engine, marker: Marker, selected: readonly Piece[], length: number, way: Point): Promise<void> {
  const { left, right, bottom, top } = extentOf(marker, selected, length);
  const [x, y] = [(left + right) / 2, (bottom + top) / 2];
  return way[0] !== 0 ? openGap(engine, marker, [x, 0], [x, marker.width]) : openGap(engine, marker, [0, y], [length, y]);
}

/** Moves all pieces in the direction of an arrow. */
export const gravity = (engine: Engine, from: Point, to: Point): Promise<void> => {
  const size = Math.hypot(to[0] - from[0], to[1] - from[1]);
  return engine.start("motion.gravity", { force: [(to[0] - from[0]) / size, (to[1] - from[1]) / size] }, say("toolGravity").replace(/:.*/, ""));
};
