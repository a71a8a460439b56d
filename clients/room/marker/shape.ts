import type { Point } from "../../typescript/src/index";
import type { ShapeDocument } from "./document";
import { boxOf, labelSpot, signedArea, simplified, type Box } from "./outline";

const pathOf = (points: readonly Point[]): Path2D => {
  const path = new Path2D();
  points.forEach(([x, y], k) => (k === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
  path.closePath();
  return path;
};

/** "charlie.front_38_L" is long for a label: "front 38 L". */
const shortName = (name: string) => name.replace(/^[^.]*\.(?=.)/, "").replace(/_/g, " ").slice(0, 60);

/** A shape, with values that are computed from it once. */
export class Shape {
  readonly id: string;
  readonly outline: readonly Point[];
  readonly name: string;
  readonly label: string;
  readonly size: string;
  readonly bundle: string;
  readonly rotations: number[] | "any";
  readonly mayFlip: boolean;
  readonly tiltLimit: number;
  readonly area: number;
  readonly box: Box;
  /** The longer side of the box. */
  readonly extent: number;
  private kept: { path?: Path2D; coarse?: Path2D; spot?: { x: number; y: number; radius: number } } = {};

  constructor(document: ShapeDocument) {
    const attribute = (name: string) => {
      const value = document.attributes?.[name];
      return typeof value === "string" || typeof value === "number" ? String(value) : "";
    };
    this.id = String(document.id);
    this.outline = document.outline;
    this.name = attribute("name") || this.id;
    this.label = shortName(this.name);
    this.size = attribute("size");
    this.bundle = attribute("bundle");
    this.rotations = document.rotations ?? [0];
    this.mayFlip = document.flip ?? false;
    this.tiltLimit = document.tilt_limit ?? 0;
    this.area = Math.abs(signedArea(document.outline));
    this.box = boxOf(document.outline);
    this.extent = Math.max(this.box.right - this.box.left, this.box.top - this.box.bottom);
  }

  get path(): Path2D {
    return (this.kept.path ??= pathOf(this.outline));
  }
  /** For drawings in which the shape is at most about 200 pixels large. */
  get coarse(): Path2D {
    return (this.kept.coarse ??= this.outline.length < 24 ? this.path : pathOf(simplified(this.outline, this.extent / 500)));
  }
  get spot(): { x: number; y: number; radius: number } {
    return (this.kept.spot ??= labelSpot(this.outline));
  }
}
