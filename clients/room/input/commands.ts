import type { Edit, PieceRules, Point } from "../../typescript/src/index";
import type { Engine } from "../engine/engine";
import { nextRotation } from "../marker/edits";
import type { Piece, Repeat } from "../marker/marker";
import { Pose } from "../marker/pose";
import type { Desk } from "../session/desk";
import { errorText } from "../session/messages";
import { say } from "../texts/texts";
import { lengthText, millimetre } from "../texts/units";
import type { Scene } from "../view/scene";
import { after, type Settling } from "./settling";

const TILT_STEP = 0.25; // degrees

/** The commands of keys and buttons on the selected pieces, which are carried out one after another. */
export class Commands {
  private line: Promise<unknown> = Promise.resolve();
  private tilting = 0;

  constructor(
    private readonly desk: Desk,
    private readonly scene: Scene,
    private readonly engine: Engine,
    private readonly settling: Settling,
    private readonly showMessage: (text: string) => void,
  ) {}

  /** Carries out actions one after another, and shows the message of an action that fails. */
  queue(act: () => Promise<unknown>): Promise<void> {
    const done = this.line.then(() => this.engine.takeOrDrop(true)).then(act);
    const settled = done.then(() => {}, (error) => this.showMessage(errorText(error)));
    this.line = settled;
    return settled;
  }

  /** Resolves when all commands that were queued before are done. */
  idle(): Promise<unknown> {
    return this.line;
  }

  undo = (): Promise<void> => (this.engine.preview.value ? Promise.resolve(this.engine.drop()) : this.queue(this.desk.undo));
  redo = (): Promise<void> => this.queue(this.desk.redo);

  /** Slides each selected piece as far as it goes. */
  bump(direction: Point): Promise<void> {
    return this.queue(async () => {
      const pieces = [...this.scene.selected()].sort((a, b) => b.box.right * direction[0] + b.box.top * direction[1] - a.box.right * direction[0] - a.box.top * direction[1]);
      await this.desk.gesture(async () => {
        for (const piece of pieces) {
          const moved = await this.bumpOne(piece, direction);
          this.showMessage(moved > 0 ? say("bumped", { name: piece.shape.label, by: lengthText(moved) }) : say("stays", { name: piece.shape.label }));
        }
      });
    });
  }

  private bumpOne(piece: Piece, direction: Point): Promise<number> {
    return this.desk.change(async (client) => {
      const answer = await client.call("motion.bump", { markerId: this.desk.markerId, piece: piece.id, direction });
      this.desk.absorb({ ...answer, ...after(answer) }, "");
      return answer.moved ? answer.gain : 0;
    });
  }

  /** Bumps along and across alternately until the piece lies in the corner. */
  shoot([along, across]: Point): Promise<void> {
    return this.queue(() =>
      this.desk.gesture(async () => {
        for (const piece of this.scene.selected()) {
          for (let k = 0; k < 12; ++k) {
            const gain = (await this.bumpOne(piece, [along, 0])) + (await this.bumpOne(piece, [0, across]));
            if (gain === 0) break;
          }
        }
      }),
    );
  }

  nudge([dx, dy]: Point): Promise<void> {
    const by = millimetre();
    return this.queue(async () => {
      const [first] = this.scene.selected();
      if (!first) return;
      await this.settling.apply(this.ownMoves([dx * by, dy * by]));
      const { x, y } = first.pose;
      this.showMessage(say("nudged", { name: first.shape.label, x: lengthText(x), y: lengthText(y) }));
    });
  }

  private ownMoves(by: Point): Edit[] {
    const all = new Set(this.scene.selected().flatMap((piece) => this.desk.marker.value!.together(piece)));
    return [...all].map((piece) => ({ op: "move", piece: piece.id, by }));
  }

  rotate(steps: 1 | -1): Promise<void> {
    return this.turn((piece) => {
      const rotation = nextRotation(piece, steps);
      if (rotation === piece.pose.rotation) this.showMessage(say("notTurned", { name: piece.shape.label }));
      return new Pose(0, 0, rotation, piece.pose.flip, piece.pose.tilt);
    });
  }

  flip(): Promise<void> {
    return this.turn((piece) => {
      if (!piece.shape.mayFlip) this.showMessage(say("notFlipped", { name: piece.shape.label }));
      return new Pose(0, 0, piece.pose.rotation, piece.pose.flip !== piece.shape.mayFlip, piece.pose.tilt);
    });
  }

  /** Tilts by steps of a quarter of a degree, counter-clockwise. Steps that are requested while another is carried out are added up. */
  tilt(steps: number): Promise<void> {
    this.tilting += steps;
    return this.turn((piece) => {
      const { tiltLimit, label } = piece.shape;
      if (tiltLimit === 0) this.showMessage(say("notTilted", { name: label }));
      const wanted = Math.round((piece.pose.tilt + this.tilting * TILT_STEP) * 100) / 100;
      return new Pose(0, 0, piece.pose.rotation, piece.pose.flip, Math.min(tiltLimit, Math.max(-tiltLimit, wanted)));
    }, () => (this.tilting = 0));
  }

  // Turns the selected pieces in place: the middle of each stays where it is.
  private turn(turned: (piece: Piece) => Pose, after: () => void = () => {}): Promise<void> {
    return this.queue(async () => {
      const pieces = this.scene.selected();
      const poses = new Map(pieces.map((piece) => [piece.id, aboutItsMiddle(piece, turned(piece))]));
      after();
      await this.settling.dropped(pieces, poses);
    });
  }

  lock(part: "x" | "y" | "tilt" | "all"): Promise<void> {
    const pieces = this.scene.selected();
    const parts = (piece: Piece): Array<"x" | "y" | "tilt"> =>
      piece.locked === true ? ["x", "y", "tilt"] : Array.isArray(piece.locked) ? piece.locked : [];
    const all = pieces.every((piece) => (part === "all" ? piece.locked === true : parts(piece).includes(part)));
    const ops = pieces.map((piece): Edit => {
      if (part === "all") return { op: "lock", piece: piece.id, locked: !all };
      const left = all ? parts(piece).filter((one) => one !== part) : [...new Set([...parts(piece), part])];
      return { op: "lock", piece: piece.id, locked: left.length === 3 ? true : left.length > 0 ? left : false };
    });
    return this.edit(ops);
  }

  group(): Promise<void> {
    const pieces = this.scene.selected();
    if (pieces.length < 2) return Promise.resolve(this.showMessage(say("noGroup")));
    const taken = new Set(this.desk.marker.value!.pieces.map((piece) => piece.group));
    let number = 1;
    while (taken.has(`g${number}`)) ++number;
    return this.edit(pieces.map((piece) => ({ op: "group", piece: piece.id, group: `g${number}` })));
  }
  ungroup(): Promise<void> {
    return this.edit(this.scene.selected().filter((piece) => piece.group).map((piece) => ({ op: "group", piece: piece.id })));
  }

  /** Lays an unplaced piece on the cloth, at the free position nearest to the point. */
  layDown(id: string, to: Point): Promise<void> {
    return this.queue(async () => {
      const marker = this.desk.marker.value;
      const piece = marker?.unplaced.find((one) => one.id === id);
      if (!marker || !piece) return;
      const pose = new Pose(0, 0, piece.rotation, piece.flip, 0);
      const box = pose.boxOf(piece.shape);
      // The piece is first placed beyond the end of the marker, where nothing is in its way, and moved from there.
      const beyond: Point = [this.desk.figures.value.length + marker.width - box.left, marker.margin - box.bottom];
      const wanted: Point = [to[0] - (box.left + box.right) / 2, to[1] - (box.bottom + box.top) / 2];
      const { rotation, flip } = piece;
      await this.desk.gesture(async () => {
        const answer = await this.desk.apply([{ op: "place", piece: id, at: marker.longest === undefined ? beyond : wanted, rotation, flip }]);
        if (await this.settling.place(id, wanted)) this.showMessage(say("laidDown", { name: piece.shape.label }));
        else await this.desk.takeBack(answer.revision, () => [{ op: "takeOff", piece: id }]);
      });
      this.scene.select([id]);
    });
  }
  /** Lays an unplaced piece at a place where it fits. */
  layAt(id: string, { x, y, rotation, flip }: Pose): Promise<void> {
    return this.queue(async () => {
      const name = this.desk.marker.value?.unplaced.find((one) => one.id === id)?.shape.label;
      if (name === undefined) return;
      if (await this.settling.apply([{ op: "place", piece: id, at: [x, y], rotation, flip }])) this.showMessage(say("laidDown", { name }));
    });
  }
  /** Takes the selected pieces off the cloth. */
  takeOff(): Promise<void> {
    return this.edit(this.scene.selected().map((piece): Edit => ({ op: "takeOff", piece: piece.id })));
  }

  buffer(length: number): Promise<void> {
    const ops = this.scene.selected().map((piece): Edit => ({ op: "buffer", piece: piece.id, buffer: length }));
    return this.queue(() => this.settling.apply(ops));
  }
  /** Sets how far the selected pieces may overlap others; with undefined, the marker's allowance applies. */
  overlap(length: number | undefined): Promise<void> {
    const ops = this.scene.selected().map((piece): Edit => ({ op: "overlap", piece: piece.id, ...(length === undefined ? {} : { overlap: length }) }));
    return this.queue(() => this.settling.apply(ops));
  }
  allowance(length: number): Promise<void> {
    return this.queue(() => this.settling.apply([{ op: "setOverlap", overlap: length }]));
  }
  spacing(length: number): Promise<void> {
    return this.queue(() => this.settling.apply([{ op: "setSpacing", spacing: length }]));
  }

  /** Changes rules of the selected pieces; a rule that is undefined is removed. */
  rules(change: (piece: Piece) => PieceRules): Promise<void> {
    return this.queue(() => this.settling.apply(this.scene.selected().map((piece): Edit => ({ op: "rules", piece: piece.id, rules: { ...piece.rules, ...change(piece) } }))));
  }
  /** Changes the widths of the selvedges; with null, the margin applies. */
  strip(change: { below?: number | null; above?: number | null }): Promise<void> {
    return this.queue(() => this.settling.apply([{ op: "setStrip", ...change }]));
  }
  /** Changes the pattern of the cloth; a pattern without a repeat is removed. */
  repeat(change: (known: Repeat) => Partial<Repeat>): Promise<void> {
    return this.queue(() => {
      const known = this.desk.marker.value?.repeat ?? { along: 0, across: 0, phase: [0, 0] as Point };
      const changed = { ...known, ...change(known) };
      return this.settling.apply([{ op: "setStrip", repeat: changed.along > 0 || changed.across > 0 ? changed : {} }]);
    });
  }
  /** Sets the length within which the pieces of a shade must lie; with null, shades have no effect. */
  shade(length: number | null): Promise<void> {
    return this.queue(() => this.settling.apply([{ op: "setShade", shade: length }]));
  }

  private edit(ops: Edit[]): Promise<void> {
    return ops.length === 0 ? Promise.resolve() : this.queue(() => this.desk.apply(ops));
  }

  selectAll(): void {
    this.scene.select(this.desk.marker.value?.byId.keys() ?? []);
  }
  /** Goes to the next or the previous piece, from left to right. */
  step(by: 1 | -1): void {
    const marker = this.desk.marker.value;
    if (!marker || marker.pieces.length === 0) return;
    const order = [...marker.pieces].sort((a, b) => a.box.left - b.box.left || a.box.bottom - b.box.bottom || a.index - b.index);
    const now = order.findIndex(({ id }) => this.scene.selection.value.has(id));
    const next = now < 0 ? (by > 0 ? 0 : order.length - 1) : (now + by + order.length) % order.length;
    this.scene.select([order[next]!.id]);
  }
}

/** Moves the new pose so that the middle of the piece's box stays where it is. */
function aboutItsMiddle({ shape, pose }: Piece, turned: Pose): Pose {
  const { left, right, bottom, top } = shape.box;
  const middle: Point = [(left + right) / 2, (bottom + top) / 2];
  const [x, y] = pose.place(middle);
  const [u, v] = turned.place(middle);
  const same = turned.rotation === pose.rotation && turned.flip === pose.flip && turned.tilt === pose.tilt;
  return same ? pose : turned.moved(x - u, y - v);
}
