import { CallError, type Edit, type Point } from "../../typescript/src/index";
import { editsBetween, editsTo } from "../marker/edits";
import type { Piece } from "../marker/marker";
import type { Pose } from "../marker/pose";
import type { Desk } from "../session/desk";
import { errorText } from "../session/messages";
import { say } from "../texts/texts";

const MAY_GROW = 0.1; // fraction of its length by which the marker may grow when dropped pieces are separated

/** Applies edits that may make pieces overlap, and makes the marker valid again. One undo takes back both. */
export class Settling {
  constructor(
    private readonly desk: Desk,
    private readonly showMessage: (text: string) => void,
  ) {}

  /** Applies operations and separates the pieces that then overlap; if that fails, the marker does not change. */
  async apply(ops: Edit[], settled = say("separated")): Promise<boolean> {
    if (ops.length === 0) return true;
    try {
      const before = this.posesOf(ops);
      return await this.desk.gesture(async () => {
        const answer = await this.desk.apply(ops);
        if (answer.valid || (await this.separate())) {
          if (!answer.valid) this.showMessage(settled);
          return true;
        }
        await this.desk.takeBack(answer.revision, () => editsTo(this.desk.marker.value!, before));
        this.showMessage(say("noPlace"));
        return false;
      });
    } catch (error) {
      this.showMessage(say("refusedDrop", { why: errorText(error) }));
      return false;
    }
  }

  private posesOf(ops: Edit[]): Map<string, Pose> {
    const edited = new Set(ops.flatMap((op) => ("piece" in op ? [op.piece] : [])));
    return new Map([...(this.desk.marker.value?.poses() ?? [])].filter(([id]) => edited.has(id)));
  }

  private async separate(): Promise<boolean> {
    try {
      return await this.desk.change(async (client) => {
        const answer = await client.call("motion.separate", { markerId: this.desk.markerId, grow: MAY_GROW });
        this.desk.absorb({ ...answer, ...after(answer), removed: answer.popped }, "");
        return answer.apart;
      });
    } catch (error) {
      if (error instanceof CallError) return false;
      throw error;
    }
  }

  dropped(pieces: readonly Piece[], to: ReadonlyMap<string, Pose>): Promise<boolean> {
    return this.apply(pieces.flatMap((piece) => editsBetween(piece.id, piece.pose, to.get(piece.id) ?? piece.pose)));
  }

  /** Moves a piece to the free position nearest to a point. Returns whether there is one. */
  async place(piece: string, to: Point): Promise<boolean> {
    return this.desk.change(async (client) => {
      const answer = await client.call("motion.place", { markerId: this.desk.markerId, piece, to, mayGrow: true });
      if (answer.found) this.desk.absorb({ ...answer, ...after(answer) }, "");
      this.showMessage(say(answer.found ? "placed" : "noPlace"));
      return answer.found;
    });
  }
}

/** The figures of the marker after a motion, with the field names of a change. */
export const after = (answer: { lengthAfter: number; utilisationAfter: number }) => ({
  length: answer.lengthAfter,
  utilisation: answer.utilisationAfter,
  removed: [] as string[],
});
