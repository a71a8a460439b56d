import type { Edit } from "../../typescript/src/index";
import type { Marker, Piece } from "./marker";
import type { Pose } from "./pose";

/** The operations that move a piece from one pose to another. */
export function editsBetween(piece: string, from: Pose, to: Pose): Edit[] {
  const edits: Edit[] = [];
  if (from.flip !== to.flip) edits.push({ op: "flip", piece, flip: to.flip });
  // The tilt is measured from the rotation, so a new rotation comes first.
  if (from.rotation !== to.rotation) edits.push({ op: "rotate", piece, to: to.rotation });
  if (from.tilt !== to.tilt) edits.push({ op: "tilt", piece, to: to.tilt });
  if (from.x !== to.x || from.y !== to.y) edits.push({ op: "move", piece, at: [to.x, to.y] });
  return edits;
}

/** The operations that move all pieces of the marker, also unplaced ones, to the given poses; pieces without a pose stay. */
export function editsTo(marker: Marker, poses: ReadonlyMap<string, Pose>): Edit[] {
  const moves = marker.pieces.flatMap((piece) => {
    const pose = poses.get(piece.id);
    return pose ? editsBetween(piece.id, piece.pose, pose) : [];
  });
  const placings = marker.unplaced.flatMap(({ id }): Edit[] => {
    const pose = poses.get(id);
    return pose ? [{ op: "place", piece: id, at: [pose.x, pose.y], rotation: pose.rotation, flip: pose.flip }] : [];
  });
  return [...moves, ...placings];
}

/** The allowed rotation of the shape that follows the piece's current one; if any is allowed, the next step of 15 degrees. */
export function nextRotation({ shape, pose }: Piece, steps: 1 | -1): number {
  if (shape.rotations === "any") return (((pose.rotation + 15 * steps) % 360) + 360) % 360;
  const allowed = [...shape.rotations].sort((a, b) => a - b);
  const now = allowed.findIndex((rotation) => Math.abs((((rotation - pose.rotation) % 360) + 360) % 360) < 1e-9);
  return allowed[(now + steps + allowed.length) % allowed.length] ?? pose.rotation;
}
