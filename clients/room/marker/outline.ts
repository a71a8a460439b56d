// Geometry of outlines, for drawing and picking only: the daemon alone decides whether a position is allowed.
import type { Point } from "../../typescript/src/index";

export interface Box {
  left: number;
  bottom: number;
  right: number;
  top: number;
}

export function boxOf(points: readonly Point[]): Box {
  const box = { left: Infinity, bottom: Infinity, right: -Infinity, top: -Infinity };
  for (const [x, y] of points) {
    if (x < box.left) box.left = x;
    if (x > box.right) box.right = x;
    if (y < box.bottom) box.bottom = y;
    if (y > box.top) box.top = y;
  }
  return box;
}

export function signedArea(points: readonly Point[]): number {
  let twice = 0;
  let [x, y] = points[points.length - 1]!;
  for (const [nextX, nextY] of points) {
    twice += x * nextY - nextX * y;
    [x, y] = [nextX, nextY];
  }
  return twice / 2;
}

export function contains(points: readonly Point[], x: number, y: number): boolean {
  let inside = false;
  let [ax, ay] = points[points.length - 1]!;
  for (const [bx, by] of points) {
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
    [ax, ay] = [bx, by];
  }
  return inside;
}

function squaredDistanceToEdge(x: number, y: number, [ax, ay]: Point, [bx, by]: Point): number {
  const dx = bx - ax;
  const dy = by - ay;
  const length2 = dx * dx + dy * dy;
  const t = length2 > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / length2)) : 0;
  return (x - ax - t * dx) ** 2 + (y - ay - t * dy) ** 2;
}

function clearanceAt(points: readonly Point[], x: number, y: number): number {
  let nearest = Infinity;
  for (let k = 0; k < points.length; ++k) {
    nearest = Math.min(nearest, squaredDistanceToEdge(x, y, points[k]!, points[(k + 1) % points.length]!));
  }
  return Math.sqrt(nearest);
}

/** The position of a label: a point inside and its distance to the outline. Of points with enough room, it is the one nearest to the middle. */
export function labelSpot(all: readonly Point[]): { x: number; y: number; radius: number } {
  const box = boxOf(all);
  const [wide, high] = [box.right - box.left, box.top - box.bottom];
  const points = all.length > 120 ? simplified(all, Math.max(wide, high) / 200) : all;
  const middle = { x: (box.left + box.right) / 2, y: (box.bottom + box.top) / 2, radius: 0 };
  const across = wide > high ? [18, 10] : [10, 18];
  const spots = [];
  for (let i = 1; i < across[0]!; ++i) {
    for (let j = 1; j < across[1]!; ++j) {
      const [x, y] = [box.left + (wide * i) / across[0]!, box.bottom + (high * j) / across[1]!];
      if (contains(points, x, y)) spots.push({ x, y, radius: clearanceAt(points, x, y) });
    }
  }
  const enough = 0.8 * Math.max(0, ...spots.map(({ radius }) => radius));
  const off = ({ x, y }: { x: number; y: number }) => Math.hypot(x - middle.x, y - middle.y);
  return spots.filter(({ radius }) => radius >= enough).reduce((best, spot) => (off(spot) < off(best) ? spot : best), spots.find(({ radius }) => radius >= enough) ?? middle);
}

/** The outline with fewer points, where no removed point is farther from it than the tolerance (Douglas and Peucker, 1973). */
export function simplified(points: readonly Point[], tolerance: number): Point[] {
  if (points.length < 12) return [...points];
  const kept = new Uint8Array(points.length);
  const half = points.length >> 1;
  kept[0] = kept[half] = 1;
  const spans: Array<[number, number]> = [
    [0, half],
    [half, points.length],
  ];
  for (let span = spans.pop(); span; span = spans.pop()) {
    const [from, to] = span;
    let farthest = tolerance * tolerance;
    let at = -1;
    for (let k = from + 1; k < to; ++k) {
      const [x, y] = points[k]!;
      const distance = squaredDistanceToEdge(x, y, points[from]!, points[to % points.length]!);
      if (distance > farthest) [farthest, at] = [distance, k];
    }
    if (at < 0) continue;
    kept[at] = 1;
    spans.push([from, at], [at, to]);
  }
  const result = points.filter((_, k) => kept[k]);
  return result.length < 3 ? [...points] : result;
}
