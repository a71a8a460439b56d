import type { Answer, Client } from "../../typescript/src/index";
import type { MarkerDocument } from "../marker/document";

const FIRST = 1500; // milliseconds of the first turn
const LONGEST = 30_000;

/** A fine compaction, or nesting. */
export type SearchKind = "fine" | "nest";
type Answered = Pick<Answer<"motion.compact">, "revision" | "lengthBefore" | "lengthAfter" | "utilisationAfter" | "stop">;
type Placements = Answer<"motion.compact">["placements"];

/** What a search reports while it runs, and whether it should begin another turn. */
export interface SearchListener {
  goesOn(): boolean;
  round(round: number, length: number): void;
  better(answer: Answered, all: Placements): void;
}

/**
 * A search that shows its best marker on the way and can be stopped at any time with the best so far. It works on a copy of the
 * marker, in turns with a time limit: after each turn the copy holds the best found. A turn that gains nothing is followed by one
 * twice as long. `best` is the length that a result has to beat.
 */
export async function search(kind: SearchKind, client: Client, document: MarkerDocument, best: number, signal: AbortSignal, listener: SearchListener): Promise<void> {
  const copy = { ...document, name: `${document.name ?? ""} (search)` } as unknown as Record<string, unknown>;
  const { markerId } = await client.call("marker.open", { marker: copy });
  try {
    let rounds = 0;
    let number = 0;
    for (let turn = FIRST; turn <= LONGEST && !signal.aborted && listener.goesOn(); ) {
      const run = kind === "fine"
        ? client.start("motion.compact", { markerId, accuracy: "fine", deadlineMs: Math.round(turn) }, { signal })
        : client.start("marker.nest", { markerId, seconds: turn / 1000, seed: ++number }, { signal });
      let last = 0;
      for await (const { round, length } of run.progress) listener.round(rounds + (last = round), length);
      rounds += last;
      const answer: Answered = await run.result;
      const gained = best - answer.lengthAfter > 1e-6 * answer.lengthAfter;
      if (gained) {
        best = answer.lengthAfter;
        listener.better(answer, await placementsOf(client, markerId));
      }
      if (answer.stop === "converged" || (kind === "fine" && answer.stop !== "deadline")) return;
      turn = gained ? turn : turn * 2;
    }
  } catch (error) {
    if (!signal.aborted) throw error;
  } finally {
    void client.call("marker.close", { markerId }).catch(() => {});
  }
}

// All that has moved since the copy was opened.
async function placementsOf(client: Client, markerId: string): Promise<Placements> {
  const { placements, marker } = await client.call("marker.get", { markerId, since: 1 });
  if (placements) return placements;
  return (marker as unknown as MarkerDocument).pieces.map(({ id, at, rotation = 0, flip = false, tilt = 0 }) => ({ id, at: at!, rotation, flip, tilt }));
}
