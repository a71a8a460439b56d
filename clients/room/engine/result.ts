import type { Placement } from "../../typescript/src/index";
import type { Marker } from "../marker/marker";
import { Pose } from "../marker/pose";
import type { Ghost } from "../view/scene";

/** A marker that the engine offers, or that was kept: where every piece would lie, and how long the marker would be. */
export interface Result {
  readonly id: number;
  readonly title: string;
  readonly markerId: string;
  readonly base: number; // the revision that it was computed from
  readonly before: number; // the length of that revision
  readonly length: number;
  readonly utilisation: number;
  readonly seconds: number | undefined; // that it took; undefined: it is a revision of the marker
  readonly poses: ReadonlyMap<string, Pose>;
}

/** The poses of all pieces after the placements. */
export function posesAfter(start: ReadonlyMap<string, Pose>, placements: readonly Placement[]): Map<string, Pose> {
  const poses = new Map(start);
  for (const placement of placements) poses.set(placement.id, Pose.of(placement));
  return poses;
}

/** The unplaced pieces that lie on the cloth in the result. */
export const newcomers = (marker: Marker, poses: ReadonlyMap<string, Pose>): Ghost[] =>
  marker.unplaced.flatMap((piece) => {
    const pose = poses.get(piece.id);
    return pose ? [{ piece: marker.asPlaced(piece, pose), pose }] : [];
  });

/** The poses that differ from the marker's own. */
export function differences(marker: Marker, poses: ReadonlyMap<string, Pose>): Map<string, Pose> {
  const differing = new Map<string, Pose>();
  for (const piece of marker.pieces) {
    const pose = poses.get(piece.id);
    if (pose && !pose.equals(piece.pose)) differing.set(piece.id, pose);
  }
  return differing;
}
