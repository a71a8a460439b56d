import type { Locks, PieceRules, PieceState, Placement, Point } from "../../typescript/src/index";
import type { MarkerDocument, PieceDocument, UnplacedPieceDocument } from "./document";
import { contains, type Box } from "./outline";
import { Pose } from "./pose";
import { Shape } from "./shape";

/** A piece of the marker, at its committed pose. */
export interface Piece {
  readonly id: string;
  readonly shape: Shape;
  readonly bundle: string;
  /** The index in the list of pieces. */
  index: number;
  pose: Pose;
  box: Box;
  locked: Locks;
  group: string;
  buffer: number;
  overlap: number | undefined; // its own overlap allowance; if undefined, the marker's applies
  rules: PieceRules; // where on the strip it may lie
}

/** The pattern of the cloth: the lengths of its repeats, 0 for a direction without one, and a point at which a repeat begins. */
export interface Repeat {
  along: number;
  across: number;
  phase: Point;
}

/** A piece that does not lie on the cloth, in the orientation that it would have there. */
export interface Unplaced {
  readonly id: string;
  readonly shape: Shape;
  readonly bundle: string;
  readonly rotation: number;
  readonly flip: boolean;
}

const FINEST = 1e6; // match points are rounded to millionths of the unit

/** The point of a piece that lies at the beginning of a repeat at the piece's current pose; the one nearest to its label. */
export function matchAsItLies({ repeat }: Marker, { shape, pose }: Piece): Point {
  const at = pose.place([shape.spot.x, shape.spot.y]);
  const { along, across, phase } = repeat!;
  const nearest = (value: number, every: number, from: number) => (every > 0 ? from + Math.round((value - from) / every) * every : value);
  const [x, y] = pose.unplace(nearest(at[0], along, phase[0]), nearest(at[1], across, phase[1]));
  return [Math.round(x * FINEST) / FINEST, Math.round(y * FINEST) / FINEST];
}

export const isLocked = (piece: Piece, part: "x" | "y" | "tilt"): boolean =>
  piece.locked === true || (Array.isArray(piece.locked) && piece.locked.includes(part));

const bundleOf = (document: PieceDocument | UnplacedPieceDocument): string => {
  const bundle = document.attributes?.["bundle"];
  return typeof bundle === "string" || typeof bundle === "number" ? String(bundle) : "";
};

/** The marker as this page knows it, which is always a revision that the daemon has acknowledged. */
export class Marker {
  readonly pieces: Piece[] = [];
  readonly unplaced: Unplaced[] = [];
  readonly byId = new Map<string, Piece>();
  readonly shapes = new Map<string, Shape>();
  readonly name: string;
  readonly unit: string;
  readonly width: number;
  readonly longest: number | undefined;
  readonly margin: number;
  /** The selvedges, and the length within which the pieces of a shade lie. */
  readonly below: number;
  readonly above: number;
  readonly shade: number | undefined;
  readonly repeat: Repeat | undefined;
  readonly spacing: number;
  readonly overlap: number;

  constructor(readonly document: MarkerDocument) {
    this.name = document.name ?? "";
    this.unit = document.unit ?? "mm";
    this.width = document.strip.width;
    this.longest = document.strip.longest;
    this.margin = document.strip.margin ?? 0;
    this.below = document.strip.below ?? this.margin;
    this.above = document.strip.above ?? this.margin;
    this.shade = document.shade;
    const { repeat } = document.strip;
    this.repeat = repeat && { along: 0, across: 0, phase: [0, 0], ...repeat };
    this.spacing = document.spacing ?? 0;
    this.overlap = document.overlap ?? 0;
    for (const shape of document.shapes) this.shapes.set(String(shape.id), new Shape(shape));
    for (const piece of document.pieces) this.add(piece);
    for (const piece of document.unplaced ?? []) this.addUnplaced(piece);
  }

  private addUnplaced(document: UnplacedPieceDocument): void {
    const shape = this.shapes.get(String(document.shape));
    if (!shape) return;
    const { id, rotation = 0, flip = false } = document;
    this.unplaced.push({ id: String(id), shape, bundle: bundleOf(document) || shape.bundle, rotation, flip });
  }

  /** An unplaced piece as if it were placed at this pose; for drawing. */
  asPlaced({ id, shape, bundle }: Unplaced, pose: Pose): Piece {
    return { id, shape, bundle, index: this.pieces.length, pose, box: pose.boxOf(shape), locked: false, group: "", buffer: 0, overlap: undefined, rules: {} };
  }

  private add(document: PieceDocument): void {
    const shape = this.shapes.get(String(document.shape));
    if (!shape) return;
    const { at, rotation = 0, flip = false, tilt = 0, locked = false, group = "", buffer = 0, overlap, rules = {} } = document;
    const pose = new Pose(at[0], at[1], rotation, flip, tilt);
    const id = String(document.id);
    const bundle = bundleOf(document) || shape.bundle;
    const piece: Piece = { id, shape, bundle, index: this.pieces.length, pose, box: pose.boxOf(shape), locked, group: String(group), buffer, overlap, rules };
    this.pieces.push(piece);
    this.byId.set(piece.id, piece);
  }

  /** Applies the placements of a change. Returns false if one of them is of a piece that is not known here. */
  absorb(placements: ReadonlyArray<Placement | PieceState>): boolean {
    for (const placement of placements) {
      const piece = this.byId.get(placement.id);
      if (!piece) return false;
      const pose = Pose.of(placement);
      if (!pose.equals(piece.pose)) {
        piece.pose = pose;
        piece.box = pose.boxOf(piece.shape);
      }
      if ("locked" in placement) {
        piece.locked = placement.locked;
        piece.group = placement.group ?? "";
        piece.buffer = placement.buffer ?? 0;
        piece.overlap = placement.overlap;
        piece.rules = placement.rules ?? {};
      }
    }
    return true;
  }

  remove(ids: readonly string[]): void {
    if (ids.length === 0) return;
    const gone = new Set(ids);
    const left = this.pieces.filter((piece) => !gone.has(piece.id));
    this.pieces.splice(0, this.pieces.length, ...left);
    this.pieces.forEach((piece, index) => (piece.index = index));
    for (const id of ids) this.byId.delete(id);
  }

  /** The topmost piece at a point of the cloth. `shown` has the poses of pieces that are shown elsewhere than at their own. */
  pieceAt([x, y]: Point, slack: number, shown: ReadonlyMap<string, Pose>): Piece | undefined {
    for (let k = this.pieces.length - 1; k >= 0; --k) {
      const piece = this.pieces[k]!;
      const pose = shown.get(piece.id);
      const box = pose ? pose.boxOf(piece.shape) : piece.box;
      if (x < box.left - slack || x > box.right + slack || y < box.bottom - slack || y > box.top + slack) continue;
      const [u, v] = (pose ?? piece.pose).unplace(x, y);
      if (contains(piece.shape.outline, u, v)) return piece;
    }
    return undefined;
  }

  /** The pieces that move together with this one: itself, or its group. */
  together(piece: Piece): Piece[] {
    return piece.group ? this.pieces.filter((other) => other.group === piece.group) : [piece];
  }

  /** The piece and those that move together with it, at the poses that they have when the piece's origin is at the point. */
  draggedTo(id: string, [x, y]: Point): Array<{ piece: Piece; pose: Pose }> {
    const dragged = this.byId.get(id);
    if (!dragged) return [];
    const [dx, dy] = [x - dragged.pose.x, y - dragged.pose.y];
    return this.together(dragged).map((piece) => ({ piece, pose: piece.pose.moved(piece.pose.x + dx, piece.pose.y + dy) }));
  }

  poses(): Map<string, Pose> {
    return new Map(this.pieces.map((piece) => [piece.id, piece.pose]));
  }

  /** The document with the current poses, for files and for opening the marker again. */
  toDocument(): MarkerDocument {
    const pieces = this.document.pieces.flatMap((piece): PieceDocument[] => {
      const known = this.byId.get(String(piece.id));
      if (!known) return [];
      const { pose, locked, group, buffer, overlap, rules } = known;
      const { group: _group, buffer: _buffer, locked: _locked, overlap: _overlap, rules: _rules, ...rest } = piece;
      return [
        {
          ...rest,
          at: [pose.x, pose.y],
          rotation: pose.rotation,
          flip: pose.flip,
          tilt: pose.tilt,
          locked,
          ...(group ? { group } : {}),
          ...(buffer ? { buffer } : {}),
          ...(overlap === undefined ? {} : { overlap }),
          ...(Object.keys(rules).length > 0 ? { rules } : {}),
        },
      ];
    });
    return { ...this.document, pieces };
  }
}
