import { Code, ConnectionLost, type Answer, type Client, type DragMode, type Point } from "../../typescript/src/index";
import type { Piece } from "../marker/marker";
import { Pose } from "../marker/pose";
import type { Desk } from "../session/desk";
import { hasCode } from "../session/messages";
import { times } from "../view/frame_times";
import type { Scene } from "../view/scene";

const MOST_UNANSWERED = 16;
const APART = 8; // least time in milliseconds between two positions that are sent

/**
 * A drag with a drag session of the daemon: the wanted position of the piece is sent for every frame, and the answers say where
 * the piece and its neighbours are. The outline follows the pointer at once. The piece itself follows it, too, as long as the
 * last answer says that the wanted position was reached.
 */
export class LiveDrag {
  private dragId: string | undefined;
  private begun: Promise<void>;
  private wanted: Point;
  private wantedSince = performance.now();
  private sent: Point | undefined;
  private sentAt = 0;
  private unanswered = 0;
  private waiting = 0;
  private order = 0;
  private shownOrder = 0;
  private over = false;
  private answer: Answer<"drag.move"> | undefined;
  private readonly start: Pose;
  private readonly together: Piece[];
  private readonly from: ReadonlyMap<string, Pose>;
  private readonly dragged: Set<string>;
  private lost = false;

  constructor(
    private readonly desk: Desk,
    private readonly scene: Scene,
    private readonly piece: Piece,
    mode: DragMode,
    private readonly rescue: (to: Point) => Promise<void>,
    before: Promise<unknown>, // earlier commands, which may not be committed yet
  ) {
    const shown = (one: Piece) => scene.shown.get(one.id) ?? one.pose;
    this.start = shown(piece);
    this.wanted = [this.start.x, this.start.y];
    this.together = scene.marker!.together(piece);
    this.from = new Map(this.together.map((one) => [one.id, shown(one)]));
    this.dragged = scene.dragged = new Set(this.from.keys());
    scene.showPoses(new Map([...scene.shown, ...this.from]), false);
    this.begun = before.then(() => this.begin(mode));
  }

  private async begin(mode: DragMode): Promise<void> {
    try {
      const client = await this.desk.link.ready();
      const begun = await client.call("drag.begin", { markerId: this.desk.markerId, piece: this.piece.id, mode });
      this.dragId = begun.dragId;
      this.pump();
    } catch (error) {
      this.fail(error);
    }
  }

  move([dx, dy]: Point): void {
    this.wanted = [this.start.x + dx, this.start.y + dy];
    this.wantedSince = performance.now();
    this.show();
    this.pump();
  }

  // Sends the latest position, at once or as soon as the least time since the previous one has passed.
  private pump(): void {
    if (this.waiting || this.dragId === undefined || this.sent === this.wanted || this.over || this.unanswered >= MOST_UNANSWERED) return;
    const pause = this.sentAt + APART - performance.now();
    if (pause <= 0) return void this.send();
    this.waiting = window.setTimeout(() => {
      this.waiting = 0;
      this.pump();
    }, pause);
  }

  private async send(): Promise<void> {
    const to = (this.sent = this.wanted);
    const order = ++this.order;
    const since = this.wantedSince;
    this.sentAt = performance.now();
    this.unanswered += 1;
    try {
      const client: Client = await this.desk.link.ready();
      const answer = await client.call("drag.move", { dragId: this.dragId!, to });
      if (order > this.shownOrder && !this.over) {
        this.shownOrder = order;
        this.answer = answer;
        this.show();
      }
      times.answer.add(performance.now() - since);
    } catch (error) {
      if (!hasCode(error, Code.Superseded) && !hasCode(error, Code.Busy)) this.fail(error);
    } finally {
      this.unanswered -= 1;
      this.pump();
    }
  }

  private fail(error: unknown): void {
    this.lost = error instanceof ConnectionLost || hasCode(error, Code.UnknownMarker) || this.lost;
    this.dragId = undefined;
  }

  private show(): void {
    if (this.over) return;
    const { answer, scene, together } = this;
    const poses = new Map((answer?.placements ?? []).map((placement) => [placement.id, Pose.of(placement)]));
    const follows = !answer || answer.reached || this.lost;
    const [x, y] = follows ? this.wanted : answer.at;
    const settle = ({ id }: Piece, to: Point) => {
      const pose = this.from.get(id)!;
      return pose.moved(pose.x + to[0] - this.start.x, pose.y + to[1] - this.start.y);
    };
    for (const piece of together) poses.set(piece.id, settle(piece, [x, y]));
    const apart = Math.hypot(this.wanted[0] - x, this.wanted[1] - y) > 1e-6;
    scene.wanted = apart ? new Map(together.map((piece) => [piece.id, settle(piece, this.wanted)])) : new Map();
    if (answer) scene.length = answer.length;
    // A neighbour that returned to its place stays on the upper layer, so that the lower one need not be redrawn.
    for (const id of scene.shown.keys()) {
      const piece = scene.marker?.byId.get(id);
      if (piece && !poses.has(id)) poses.set(id, piece.pose);
    }
    scene.showPoses(poses, false);
  }

  async end(commit: boolean): Promise<void> {
    await this.begun;
    clearTimeout(this.waiting);
    if (commit && this.dragId !== undefined && this.sent !== this.wanted) await this.send();
    this.over = true;
    this.scene.wanted = new Map();
    if (this.scene.dragged === this.dragged) this.scene.dragged = new Set();
    const { dragId } = this;
    try {
      if (dragId === undefined) {
        if (commit) await this.rescue(this.wanted);
        return;
      }
      await this.desk.change(async (client) => {
        const answer = await client.call("drag.end", { dragId, markerId: this.desk.markerId, commit });
        this.desk.absorb(answer, "");
      });
    } catch (error) {
      if (!(error instanceof ConnectionLost) || !commit) throw error;
      await this.rescue(this.wanted);
    } finally {
      this.scene.length = this.desk.figures.value.length;
      if (this.scene.dragged.size === 0) this.scene.showPoses(new Map(), true);
    }
  }
}
