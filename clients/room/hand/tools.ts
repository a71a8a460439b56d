import type { Force, Point } from "../../typescript/src/index";
import type { Engine } from "../engine/engine";
import type { Marker } from "../marker/marker";
import { say } from "../texts/texts";
import { Signal } from "../base/signal";

export type Tool = "select" | "ruler" | "gap" | "gravity";
export const tool = new Signal<Tool>("select");

/** The pieces beside a line are pushed away from it; the others only make way. */
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

/** All pieces fall the way of an arrow. */
export const gravity = (engine: Engine, from: Point, to: Point): Promise<void> => {
  const size = Math.hypot(to[0] - from[0], to[1] - from[1]);
  return engine.start("motion.gravity", { force: [(to[0] - from[0]) / size, (to[1] - from[1]) / size] }, say("toolGravity").replace(/:.*/, ""));
};
