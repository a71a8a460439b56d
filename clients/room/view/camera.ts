import type { Point } from "../../typescript/src/index";
import type { Box } from "../marker/outline";

/** Transforms between the cloth (y up, in the marker's unit) and the screen (y down, in CSS pixels). */
export class Camera {
  constructor(
    readonly scale: number,
    readonly x: number,
    readonly y: number,
  ) {}

  toScreen([x, y]: Point): Point {
    return [x * this.scale + this.x, this.y - y * this.scale];
  }
  toCloth([x, y]: Point): Point {
    return [(x - this.x) / this.scale, (this.y - y) / this.scale];
  }

  panned(dx: number, dy: number): Camera {
    return new Camera(this.scale, this.x + dx, this.y + dy);
  }

  /** Zooms about a point of the screen, usually the pointer. */
  zoomed(factor: number, [x, y]: Point, limits: { least: number; most: number }): Camera {
    const scale = Math.min(limits.most, Math.max(limits.least, this.scale * factor));
    const ratio = scale / this.scale;
    return new Camera(scale, x - (x - this.x) * ratio, y - (y - this.y) * ratio);
  }

  /** Shows the whole box, with a margin in pixels on each side. */
  static fitting(box: Box, width: number, height: number, margin: { left: number; right: number; top: number; bottom: number }): Camera {
    const wide = Math.max(1, width - margin.left - margin.right);
    const high = Math.max(1, height - margin.top - margin.bottom);
    const scale = Math.min(wide / (box.right - box.left), high / (box.top - box.bottom));
    const x = margin.left + (wide - scale * (box.right - box.left)) / 2 - box.left * scale;
    const y = margin.top + (high + scale * (box.top - box.bottom)) / 2 + box.bottom * scale;
    return new Camera(scale, x, y);
  }

  /** The part of the cloth that a view of this size shows. */
  window(width: number, height: number): Box {
    const [left, top] = this.toCloth([0, 0]);
    const [right, bottom] = this.toCloth([width, height]);
    return { left, right, top, bottom };
  }
}
