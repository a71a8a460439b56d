import { Code, type Answer, type Client, type Edit, type Notifications, type PieceState, type Placement } from "../../typescript/src/index";
import { Signal } from "../base/signal";
import type { MarkerDocument } from "../marker/document";
import { Marker } from "../marker/marker";
import type { Pose } from "../marker/pose";
import type { Link } from "./link";
import { hasCode } from "./messages";

const MOST_READINGS = 10; // of a marker that changes faster than it can be read

/** The figures of the marker's current revision. */
export interface Figures {
  revision: number;
  length: number;
  utilisation: number;
  valid: boolean;
}

/** A change to a new revision, from a notification or from the answer to a call. */
export interface Change extends Pick<Notifications["marker.changed"], "revision" | "removed" | "length" | "utilisation" | "valid" | "whole"> {
  placements: ReadonlyArray<Placement | PieceState>;
}
/** The poses that pieces had before a change. */
export type Before = ReadonlyMap<string, Pose>;

/** The marker that this page shows. It is open in the daemon and watched, and changes only as the daemon reports. */
export class Desk {
  readonly marker = new Signal<Marker | undefined>(undefined);
  readonly figures = new Signal<Figures>({ revision: 0, length: 0, utilisation: 0, valid: true });
  /** Set after each change, with the poses before it; `by` is the method, or "" for a change made by this page. */
  readonly changed = new Signal<{ before: Before; by: string; mine: boolean } | undefined>(undefined);
  /** The pieces of this marker that others drag now. */
  readonly draggedByOthers = new Signal<Notifications["marker.dragged"]["pieces"]>([]);
  markerId = "";
  /**
   * Names the shown marker for as long as this page is open: unlike its id, it names no other marker in another instance of the
   * daemon, and it stays when this page opens a lost marker again.
   */
  markerKey = "";
  /** The figures and the poses when the marker was opened here. */
  opening: { figures: Figures; poses: Map<string, Pose> } | undefined;
  private instance: string | undefined; // of the daemon when the marker was shown: in another one the id is not this marker's
  private readonly keys = new Map<string, string>(); // of markers that this page opened again, by instance and id
  private listening: Client | undefined;
  private documentOf = ""; // the marker whose document has been read
  private latestReported = 0; // the latest revision that an answer or a notification reported for this marker
  private refreshing: Promise<void> = Promise.resolve(); // a change that requires reading the whole document again
  private changesInProgress = 0; // number of calls of this page that change the marker
  private ownRevisions = new Set<number>(); // made by calls of this page in the present gesture
  // The number of revisions that a gesture made, by the last of them: one undo takes back all of them.
  private readonly undoSteps = new Map<number, number>();
  private readonly redoSteps = new Map<number, number>();

  constructor(readonly link: Link) {
    let first = true;
    link.joined.follow(() => {
      if (!first && (this.markerId || this.marker.value)) void this.resume();
      first = false;
    });
  }

  /** Opens a document, or the text of a trade file with its rule table and order, as a new marker, and shows it. */
  async open(document: MarkerDocument | Record<string, unknown> | string, besides: { rules?: string; order?: string } = {}): Promise<Answer<"marker.open">> {
    const client = await this.link.ready();
    const opened = await client.call("marker.open", { marker: document as Record<string, unknown>, ...besides });
    await this.show(opened.markerId);
    return opened;
  }

  /** Shows a marker that is open in the daemon. */
  async show(markerId: string): Promise<void> {
    const client = await this.link.ready();
    this.listen(client);
    if (this.markerId && this.markerId !== markerId) void client.call("marker.unwatch", { markerId: this.markerId }).catch(() => {});
    this.markerId = markerId;
    this.instance = client.instance;
    this.markerKey = this.keyOf(client, markerId);
    this.documentOf = "";
    this.latestReported = 0;
    this.draggedByOthers.value = [];
    this.undoSteps.clear();
    this.redoSteps.clear();
    await client.call("marker.watch", { markerId });
    await this.load(client);
    this.opening = { figures: this.figures.value, poses: this.marker.value!.poses() };
    this.marker.announce();
  }

  // Reads the document and its figures. Both are read again if the two answers are of different revisions, or if a newer revision
  // was reported in the meantime.
  private async load(client: Client): Promise<void> {
    const { markerId } = this;
    for (let readings = 1; ; ++readings) {
      const [listed, got] = await Promise.all([client.call("marker.list", {}), client.call("marker.get", { markerId })]);
      if (markerId !== this.markerId) return;
      const { revision } = got;
      const entry = listed.markers.find((marker) => marker.markerId === markerId);
      const outdated = revision < this.latestReported || (entry && entry.revision !== revision);
      if (outdated && readings < MOST_READINGS) continue;
      const { valid } = this.figures.value;
      this.figures.value = { revision, length: entry?.length ?? 0, utilisation: entry?.utilisation ?? 0, valid };
      this.documentOf = markerId;
      this.marker.value = new Marker(got.marker as unknown as MarkerDocument);
      break;
    }
    void client
      .call("marker.check", { markerId })
      .then((check) => {
        if (check.revision === this.figures.value.revision) this.figures.value = { ...this.figures.value, valid: check.valid };
      })
      .catch(() => {});
  }

  // After a lost connection, watches the marker again and reads it anew, or reopens it if the daemon has lost it.
  private async resume(): Promise<void> {
    const client = await this.link.ready();
    this.listen(client);
    const kept = this.marker.value;
    this.latestReported = 0; // after a restart, the daemon may have an older revision
    this.draggedByOthers.value = [];
    if (client.instance !== this.instance) this.markerId = ""; // until it is open again, no call may name it
    try {
      if (this.markerId) {
        await client.call("marker.watch", { markerId: this.markerId });
        return await this.refresh(client);
      }
    } catch (error) {
      if (!hasCode(error, Code.UnknownMarker)) return;
    }
    if (kept) await this.reopen(client, kept);
  }

  private async reopen(client: Client, kept: Marker): Promise<void> {
    const opened = await client.call("marker.open", { marker: kept.toDocument() as unknown as Record<string, unknown> });
    const { opening, markerKey } = this;
    this.keys.set(`${client.instance} ${opened.markerId}`, markerKey);
    await this.show(opened.markerId);
    this.opening = opening;
    this.changed.value = { before: new Map(), by: "reopened", mine: true };
  }

  private keyOf(client: Client, markerId: string): string {
    const place = `${client.instance} ${markerId}`;
    return this.keys.get(place) ?? place;
  }

  private async refresh(client: Client, by = "refreshed", mine = true): Promise<void> {
    const before = this.marker.value?.poses() ?? new Map();
    await this.load(client);
    this.changed.value = { before, by, mine };
  }

  // Reads the marker anew, unless this revision has been read by then, because an answer and a notification report the same
  // change. Readings run one after another, so that an older document never replaces a newer one.
  private refreshAfter(revision: number, by: string): void {
    const mine = this.changesInProgress > 0;
    this.refreshing = this.refreshing
      .catch(() => {})
      .then(async () => {
        if (this.figures.value.revision < revision) await this.refresh(await this.link.ready(), by, mine);
      });
  }

  private listen(client: Client): void {
    if (this.listening === client) return;
    this.listening = client;
    client.on("marker.changed", (change) => {
      if (change.markerId === this.markerId) this.absorb(change, change.by);
    });
    client.on("marker.dragged", ({ markerId, pieces }) => {
      if (markerId === this.markerId) this.draggedByOthers.value = pieces;
    });
    client.on("marker.closed", ({ markerId }) => {
      if (markerId === this.markerId) this.changed.value = { before: new Map(), by: "closed", mine: false };
    });
  }

  /** Applies a change, unless it is older than the current revision and so has been applied already. */
  absorb(change: Change, by: string): void {
    const marker = this.marker.value;
    const { revision } = this.figures.value;
    this.latestReported = Math.max(this.latestReported, change.revision);
    if (by === "") this.ownRevisions.add(change.revision);
    if (!marker || this.documentOf !== this.markerId || change.revision <= revision) return;
    const before = new Map<string, Pose>();
    for (const { id } of change.placements) {
      const piece = marker.byId.get(id);
      if (piece) before.set(id, piece.pose);
    }
    const follows = change.revision === revision + 1 && !change.whole;
    if (!follows || !marker.absorb(change.placements)) {
      this.refreshAfter(change.revision, by);
      return;
    }
    marker.remove(change.removed);
    const { length, utilisation, valid } = change;
    this.figures.value = { revision: change.revision, length, utilisation, valid };
    this.changed.value = { before, by, mine: this.changesInProgress > 0 };
  }

  /** Carries out an action that changes the marker; until it ends, changes count as made by this page. */
  async change<T>(act: (client: Client) => Promise<T>): Promise<T> {
    const client = await this.link.ready();
    this.changesInProgress += 1;
    try {
      return await act(client);
    } finally {
      this.changesInProgress -= 1;
    }
  }

  /** Carries out several changes, which one undo takes back, unless others have changed the marker in the meantime. */
  async gesture<T>(act: () => Promise<T>): Promise<T> {
    const from = this.figures.value.revision;
    this.ownRevisions.clear();
    try {
      return await act();
    } finally {
      await this.refreshing;
      const to = this.figures.value.revision;
      const own = [...this.ownRevisions].filter((revision) => revision > from).length;
      if (to > from + 1 && own === to - from) this.undoSteps.set(to, to - from);
    }
  }

  /** Applies operations; fails if the marker has changed in the meantime. */
  apply(ops: Edit[]): Promise<Answer<"marker.apply">> {
    return this.change(async (client) => {
      const { markerId } = this;
      const answer = await client.call("marker.apply", { markerId, ops, baseRev: this.figures.value.revision });
      this.absorb(answer, "");
      return answer;
    });
  }

  /** Takes back the change that made a revision: by undo or, if others have changed the marker since, by edits that move its pieces back. */
  async takeBack(revision: number, back: () => Edit[]): Promise<void> {
    try {
      await this.change(async (client) => this.absorb(await client.call("marker.undo", { markerId: this.markerId, baseRev: revision }), "marker.undo"));
    } catch (error) {
      if (!hasCode(error, Code.RevisionMismatch)) throw error;
      await this.refreshing;
      await this.apply(back());
    }
  }

  /** Takes back the latest change; fails if the daemon has a newer one. */
  undo = (): Promise<void> => this.step("marker.undo", this.undoSteps, this.redoSteps);
  redo = (): Promise<void> => this.step("marker.redo", this.redoSteps, this.undoSteps);

  private step(method: "marker.undo" | "marker.redo", here: Map<number, number>, there: Map<number, number>): Promise<void> {
    return this.change(async (client) => {
      const steps = here.get(this.figures.value.revision) ?? 1;
      let baseRev = this.figures.value.revision;
      for (let k = 0; k < steps; ++k) {
        const change = await client.call(method, { markerId: this.markerId, baseRev });
        this.absorb(change, method);
        baseRev = change.revision;
      }
      if (steps > 1) there.set(this.figures.value.revision, steps);
    });
  }
}
