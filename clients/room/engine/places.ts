import type { Client, Point } from "../../typescript/src/index";
import { Signal } from "../base/signal";
import type { Unplaced } from "../marker/marker";
import { boxOf, contains, type Box } from "../marker/outline";
import { Pose } from "../marker/pose";
import type { Desk } from "../session/desk";
import type { Ghost, Scene } from "../view/scene";

const MOST_CALLS = 48;
const NODES = 2000; // limit of the exact search in one part of a region
const ALONG = 6; // number of parts of a large region along the strip
const ACROSS = 2;

/**
 * Finds the places where an unplaced piece fits while the other pieces stay. The daemon returns the regions that no piece covers,
 * and an exact search says for each region, and for each part of a large region, whether the piece fits into it. Places appear as
 * they are found.
 */
export class Places {
  readonly piece = new Signal<Unplaced | undefined>(undefined);
  readonly searching = new Signal(false);
  /** Counts changes of the places and of the chosen place, which are in the scene. */
  readonly changed = new Signal(0);
  private searched = 0; // the revision that was searched
  private searches = 0; // a newer search makes the answers of older ones void

  constructor(
    private readonly desk: Desk,
    private readonly scene: Scene,
  ) {
    desk.figures.follow(({ revision }) => revision !== this.searched && this.goOn());
    desk.marker.follow(() => this.goOn());
  }

  show(piece: Unplaced): void {
    this.piece.value = piece;
    void this.find(piece);
  }

  end(): void {
    this.searches += 1;
    this.piece.value = undefined;
    this.searching.value = false;
    this.publish([], 0);
  }

  // When the marker has changed, searches again for the same piece or, if it was placed, for another one of its shape.
  private goOn(): void {
    const { value } = this.piece;
    if (!value) return;
    const unplaced = this.desk.marker.value?.unplaced ?? [];
    const next = unplaced.find(({ id }) => id === value.id) ?? unplaced.find(({ shape }) => shape.id === value.shape.id);
    if (next) this.show(next);
    else this.end();
  }

  private publish(places: Ghost[], at: number): void {
    this.scene.places = places;
    this.scene.placeAt = at;
    this.changed.value += 1;
    this.scene.onChange("moving");
  }

  private async find(piece: Unplaced): Promise<void> {
    const search = ++this.searches;
    this.searched = this.desk.figures.value.revision;
    this.publish([], 0);
    this.searching.value = true;
    try {
      const client = await this.desk.link.ready();
      const { markerId } = this.desk;
      const { regions } = await client.call("marker.regions", { markerId, leastArea: 0.9 * piece.shape.area, clearance: 0 });
      let left = MOST_CALLS;
      for (const { outline } of regions) {
        const whole = boxOf(outline);
        let parts = [whole];
        for (let k = 0; k < parts.length && left > 0; ++k, --left) {
          const pose = await placeIn(client, markerId, piece.id, parts[k]!);
          if (search !== this.searches) return;
          if (pose) this.add(piece, pose);
          if (pose && k === 0) parts = [whole, ...partsOf(whole, new Pose(0, 0, pose.rotation, pose.flip, 0).boxOf(piece.shape))];
        }
      }
    } catch {
      // The marker has changed in the meantime, or is not valid: the search is repeated for the next revision.
    } finally {
      if (search === this.searches) this.searching.value = false;
    }
  }

  private add(piece: Unplaced, pose: Pose): void {
    const { marker, places, placeAt } = this.scene;
    const near = piece.shape.extent / 50;
    const known = places.some(({ pose: { x, y, rotation, flip } }) => Math.hypot(x - pose.x, y - pose.y) < near && rotation === pose.rotation && flip === pose.flip);
    if (marker && !known) this.publish([...places, { piece: marker.asPlaced(piece, pose), pose }], placeAt);
  }

  /** The index of the place at a point of the cloth; -1 if there is none. */
  at([x, y]: Point): number {
    return this.scene.places.findIndex(({ piece, pose }) => contains(piece.shape.outline, ...pose.unplace(x, y)));
  }

  choose(place: number): void {
    const { places, placeAt } = this.scene;
    const next = places.length === 0 ? 0 : (place + places.length) % places.length;
    if (next !== placeAt) this.publish(places, next);
  }
  step(by: 1 | -1): void {
    this.choose(this.scene.placeAt + by);
  }
}

// The first place that an exact search finds within the box.
async function placeIn(client: Client, markerId: string, piece: string, { left, bottom, right, top }: Box): Promise<Pose | undefined> {
  const room: Point[] = [[left, bottom], [right, top]];
  const { verdict, placements } = await client.call("motion.contain", { markerId, pieces: [piece], room, nodes: NODES, commit: false });
  const placement = verdict === "found" ? placements.find(({ id }) => id === piece) : undefined;
  return placement && Pose.of(placement);
}

// Parts of a region that are at least as large as the piece.
function partsOf(region: Box, piece: Box): Box[] {
  const [wide, high] = [region.right - region.left, region.top - region.bottom];
  const along = Math.max(1, Math.min(ALONG, Math.floor(wide / (piece.right - piece.left))));
  const across = Math.max(1, Math.min(ACROSS, Math.floor(high / (piece.top - piece.bottom))));
  if (along * across === 1) return [];
  return Array.from({ length: along * across }, (_, k) => {
    const [column, row] = [k % along, Math.floor(k / along)];
    const left = region.left + (wide * column) / along;
    const bottom = region.bottom + (high * row) / across;
    return { left, bottom, right: left + wide / along, top: bottom + high / across };
  });
}
