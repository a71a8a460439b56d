import type { Placement, Point } from "../../typescript/src/index";
import type { Box } from "./outline";
import type { Shape } from "./shape";

/** The position and orientation of a piece: it is flipped, rotated and tilted about its shape's origin, then moved to (x, y). */
export class Pose {
  readonly cos: number;
  readonly sin: number;
  readonly mirror: 1 | -1;

  constructor(
    readonly x: number,
    readonly y: number,
    readonly rotation: number,
    readonly flip: boolean,
    readonly tilt: number,
  ) {
    const angle = ((rotation + tilt) * Math.PI) / 180;
    const turn = (rotation + tilt) % 90 === 0 ? Math.round : (value: number) => value;
    this.cos = turn(Math.cos(angle));
    this.sin = turn(Math.sin(angle));
    this.mirror = flip ? -1 : 1;
  }

  static of(placement: Omit<Placement, "id">): Pose {
    return new Pose(placement.at[0], placement.at[1], placement.rotation, placement.flip, placement.tilt);
  }

  moved(x: number, y: number): Pose {
    return new Pose(x, y, this.rotation, this.flip, this.tilt);
  }

  equals(other: Pose): boolean {
    const { x, y, rotation, flip, tilt } = this;
    return x === other.x && y === other.y && rotation === other.rotation && flip === other.flip && tilt === other.tilt;
  }

  /** Transforms a point from the shape's coordinates to the cloth's. */
  place([x, y]: Point): Point {
    const v = y * this.mirror;
    return [this.cos * x - this.sin * v + this.x, this.sin * x + this.cos * v + this.y];
  }

  /** Transforms a point from the cloth's coordinates to the shape's. */
  unplace(x: number, y: number): Point {
    const dx = x - this.x;
    const dy = y - this.y;
    return [this.cos * dx + this.sin * dy, this.mirror * (this.cos * dy - this.sin * dx)];
  }

  boxOf(shape: Shape): Box {
    const box = { left: Infinity, bottom: Infinity, right: -Infinity, top: -Infinity };
    for (const point of shape.outline) {
      const [x, y] = this.place(point);
      if (x < box.left) box.left = x;
      if (x > box.right) box.right = x;
      if (y < box.bottom) box.bottom = y;
      if (y > box.top) box.top = y;
    }
    return box;
  }

  /** Interpolates between this pose (part 0) and another one (part 1). It rotates the shorter way, and flips half-way. */
  towards(other: Pose, part: number): Pose {
    const mix = (a: number, b: number) => a + (b - a) * part;
    const turn = ((other.rotation + other.tilt - this.rotation - this.tilt + 540) % 360) - 180;
    const flip = part < 0.5 ? this.flip : other.flip;
    return new Pose(mix(this.x, other.x), mix(this.y, other.y), this.rotation + this.tilt + turn * part, flip, 0);
  }
}
