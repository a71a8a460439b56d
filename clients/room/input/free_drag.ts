import type { Point } from "../../typescript/src/index";
import type { Piece } from "../marker/marker";
import type { Pose } from "../marker/pose";
import type { Scene } from "../view/scene";

/** A free drag, during which pieces may overlap others. Overlaps are drawn, and removed when the drag ends. */
export class FreeDrag {
  private readonly from: Map<string, Pose>;
  private to: Map<string, Pose>;
  private readonly dragged: Set<string>;

  constructor(
    private readonly scene: Scene,
    pieces: readonly Piece[],
    private readonly endAnnouncement: () => Promise<void>, // see announceDrag
    private readonly drop: (moved: Map<string, Pose>) => Promise<void>,
  ) {
    this.from = new Map(pieces.map((piece) => [piece.id, piece.pose]));
    this.to = this.from;
    this.dragged = scene.dragged = new Set(this.from.keys());
    scene.free = true;
    scene.showPoses(new Map(this.from), false);
  }

  move([dx, dy]: Point): void {
    this.to = new Map([...this.from].map(([id, pose]) => [id, pose.moved(pose.x + dx, pose.y + dy)]));
    this.scene.showPoses(this.to, false);
  }

  async end(commit: boolean): Promise<void> {
    this.scene.free = false;
    if (this.scene.dragged === this.dragged) this.scene.dragged = new Set();
    const announcementEnded = this.endAnnouncement();
    if (commit) {
      await announcementEnded; // other users must see the end of the drag before the change
      await this.drop(this.to);
    }
    if (this.scene.dragged.size === 0) this.scene.showPoses(new Map(), true);
  }
}
