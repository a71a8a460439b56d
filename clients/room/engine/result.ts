import type { Placement } from "../../typescript/src/index";
import type { Marker } from "../marker/marker";
import { Pose } from "../marker/pose";
import type { Ghost } from "../view/scene";

/** A result of the engine, or a revision that was kept: the poses of all pieces, and the length of the marker. */
export interface Result {
  readonly id: number;
  readonly title: string;
  readonly markerKey: string; // of the marker that it was made of
  readonly base: number; // the revision that it was computed from
  readonly before: number; // the length of that revision
  readonly length: number;
  readonly utilisation: number;
  readonly seconds: number | undefined; // how long it took; undefined for a revision of the marker
  readonly poses: ReadonlyMap<string, Pose>;
}

/** The poses of all pieces after the placements. */
export function posesAfter(start: ReadonlyMap<string, Pose>, placements: readonly Placement[]): Map<string, Pose> {
  const poses = new Map(start);
  for (const placement of placements) poses.set(placement.id, Pose.of(placement));
  return poses;
}

/** The unplaced pieces that the result places on the cloth. */
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
