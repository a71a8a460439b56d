import type { Answer, Point } from "../../typescript/src/index";
import { Signal } from "../base/signal";
import { preferences } from "../base/preferences";
import type { Marker, Piece } from "../marker/marker";
import { Pose } from "../marker/pose";
import type { Camera } from "./camera";
import { Colouring } from "./palette";

export interface Ghost {
  piece: Piece;
  pose: Pose;
}
/** A line or a rectangle that the user is drawing. */
export interface Stroke {
  kind: "ruler" | "gap" | "gravity" | "band";
  from: Point;
  to: Point;
}

const FLIGHT = 220; // milliseconds of an animated change

/** What the canvas shows: the committed marker, and everything that is drawn on top of it. */
export class Scene {
  readonly camera = new Signal<Camera | undefined>(undefined);
  readonly selection = new Signal<ReadonlySet<string>>(new Set());
  readonly colouring = new Signal(new Colouring("none", []));
  marker: Marker | undefined;
  /** Poses that are shown instead of the committed ones, during a drag or for a previewed result. */
  shown = new Map<string, Pose>();
  /** The dragged pieces, and the poses that the pointer requests for them. */
  dragged = new Set<string>();
  wanted = new Map<string, Pose>();
  free = false; // whether the dragged pieces may overlap others; overlaps are then drawn
  hovered: string | undefined;
  ghosts: Ghost[] = [];
  newcomers: Ghost[] = []; // unplaced pieces where a result places them
  carried: Ghost | undefined; // an unplaced piece that is being dragged out of the tray
  places: Ghost[] = []; // the places where an unplaced piece fits
  placeAt = 0; // the index of the chosen place
  draggedByOthers: Ghost[] = []; // pieces that other users are dragging, at their current poses
  stroke: Stroke | undefined;
  chain: Answer<"marker.hold"> | undefined;
  tilts: Answer<"marker.hold">["tilts"] = []; // the worth of a degree of tilt of each piece
  regions: Answer<"marker.regions"> | undefined;
  fits: ReadonlySet<number> = new Set(); // the indices of the regions into which the smallest piece fits
  overlaps: Answer<"marker.check">["overlaps"] = [];
  outside: string[] = []; // pieces that protrude from the strip or violate a rule
  opening: number | undefined; // the marker's length when it was opened
  length = 0;
  focus: string | undefined; // the piece that has the keyboard focus
  private flights = new Map<string, { from: Pose; start: number }>();
  private readonly calm = matchMedia("(prefers-reduced-motion: reduce)");

  /** Called when the settled or the moving pieces must be redrawn. */
  onChange: (what: "settled" | "moving") => void = () => {};

  constructor() {
    preferences.follow(({ colourBy }) => this.colour(colourBy));
  }

  private colour(by: typeof preferences.value.colourBy): void {
    const { marker } = this;
    const unplaced = marker?.unplaced.map((piece) => marker.asPlaced(piece, new Pose(0, 0, 0, false, 0))) ?? [];
    const pieces = [...(marker?.pieces ?? []), ...unplaced];
    const known = by !== "size" || pieces.some((piece) => piece.shape.size);
    this.colouring.value = new Colouring(known ? by : "shape", pieces);
    this.onChange("settled");
  }

  show(marker: Marker): void {
    const known = this.marker;
    this.marker = marker;
    const kept = [...this.selection.value].filter((id) => marker.byId.has(id));
    if (kept.length !== this.selection.value.size) this.selection.value = new Set(kept);
    this.shown.clear();
    this.flights.clear();
    this.ghosts = [];
    this.newcomers = [];
    this.places = [];
    this.draggedByOthers = [];
    this.overlaps = [];
    this.outside = [];
    if (known !== marker) this.colour(preferences.value.colourBy);
    this.onChange("settled");
  }

  /** The pose at which a piece is currently shown. */
  poseOf(piece: Piece, now: number): Pose {
    const pose = this.shown.get(piece.id) ?? piece.pose;
    const flight = this.flights.get(piece.id);
    if (!flight) return pose;
    const part = (now - flight.start) / FLIGHT;
    if (part < 1) return flight.from.towards(pose, 1 - (1 - part) ** 3);
    this.flights.delete(piece.id);
    return pose;
  }

  get flying(): boolean {
    return this.flights.size > 0;
  }
  /** Whether a piece is drawn on the upper layer. */
  moves(id: string): boolean {
    return this.shown.has(id) || this.flights.has(id) || this.dragged.has(id);
  }
  movingIds(): Set<string> {
    return new Set([...this.shown.keys(), ...this.flights.keys(), ...this.dragged]);
  }

  /** Animates pieces from their earlier poses to their current ones. Large changes are shown at once. */
  fly(before: ReadonlyMap<string, Pose>): void {
    if (this.calm.matches || before.size > 3000 || document.hidden) return this.onChange("settled");
    const start = performance.now();
    for (const [id, from] of before) {
      const piece = this.marker?.byId.get(id);
      if (piece && !this.dragged.has(id) && !from.equals(this.shown.get(id) ?? piece.pose)) this.flights.set(id, { from, start });
    }
    this.onChange("settled");
  }

  /** Shows these poses instead of the committed ones; all other pieces return to their committed poses. */
  showPoses(poses: Map<string, Pose>, gliding: boolean): void {
    const before = new Map<string, Pose>();
    if (gliding) {
      const now = performance.now();
      for (const id of new Set([...this.shown.keys(), ...poses.keys()])) {
        const piece = this.marker?.byId.get(id);
        if (piece) before.set(id, this.poseOf(piece, now));
      }
    }
    const same = poses.size === this.shown.size && [...poses.keys()].every((id) => this.shown.has(id));
    this.shown = poses;
    if (gliding) this.fly(before);
    else this.onChange(same ? "moving" : "settled");
  }

  select(ids: Iterable<string>): void {
    this.selection.value = new Set(ids);
    this.onChange("moving");
  }
  selected(): Piece[] {
    return [...this.selection.value].flatMap((id) => this.marker?.byId.get(id) ?? []);
  }
}
