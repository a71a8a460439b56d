import type { Locks, Point } from "../../typescript/src/index";

/** A marker as a native document holds it; protocol/README.md explains every field. */
export interface MarkerDocument {
  format: "selvage-marker";
  version: 1;
  name?: string;
  unit?: string;
  resolution?: number;
  strip: { width: number; longest?: number; margin?: number };
  spacing?: number;
  overlap?: number;
  shapes: ShapeDocument[];
  pieces: PieceDocument[];
  /** Pieces that do not lie on the cloth: without `at`. */
  unplaced?: PieceDocument[];
  attributes?: Record<string, unknown>;
}

export interface ShapeDocument {
  id: string;
  outline: Point[];
  rotations?: number[] | "any";
  flip?: boolean;
  tilt_limit?: number;
  attributes?: Record<string, unknown>;
}

export interface PieceDocument {
  id: string;
  shape: string;
  at?: Point | null;
  rotation?: number;
  flip?: boolean;
  tilt?: number;
  locked?: Locks;
  group?: string;
  buffer?: number;
  overlap?: number;
  attributes?: Record<string, unknown>;
}
