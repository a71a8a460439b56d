import { Code, type Answer, type Client } from "../../typescript/src/index";
import type { MarkerDocument } from "../marker/document";
import type { Copies } from "../session/copies";
import { hasCode } from "../session/messages";

const FIRST = 1500; // time limit of the first call in milliseconds
const PATIENCE = 45_000; // a search ends after this many milliseconds without an improvement
/** The longest time limit of a call in milliseconds; it is shorter in the page, whose engine answers nothing else during a call. */
const LONGEST = { daemon: 24_000, page: 3000 };

/** The kind of search: fine compaction, nesting, filling gaps, or exact compaction of one window of pieces after another. */
export type Search =
  | { kind: "fine" | "nest" | "fillGaps" }
  | { kind: "compactExactly"; among?: string[] }; // only windows with one of these pieces; all windows when absent
type Answered = Pick<Answer<"motion.compact">, "revision" | "lengthBefore" | "lengthAfter" | "utilisationAfter" | "stop">;
type Placements = Answer<"motion.compact">["placements"];

/** Receives the progress of a search, and decides whether it should make another call. */
export interface SearchListener {
  goesOn(): boolean;
  round(round: number, length: number): void;
  better(answer: Answered, all: Placements): void;
}

/**
 * A search that reports its best marker while it runs and can be stopped at any time. It works on a copy of the marker with a
 * series of calls that have a time limit; after each call the copy is the best marker found. A call without an improvement is
 * followed by one of up to twice its time limit. A copy that was lost with its connection is made anew from the best marker.
 * `best` is the length that a result has to beat.
 */
export async function search(wanted: Search, client: Client, copies: Copies, document: MarkerDocument, best: number, signal: AbortSignal, listener: SearchListener, where: keyof typeof LONGEST): Promise<void> {
  let copied: MarkerDocument = { ...document, name: `${document.name ?? ""} (search)` };
  let latest = copied;
  let markerId = await copies.make(client, asParameter(copied));
  try {
    let rounds = 0;
    let number = 0;
    let inVain = 0;
    for (let turn = FIRST; inVain < PATIENCE && !signal.aborted && listener.goesOn(); ) {
      if (!copies.has(markerId)) markerId = await copies.make(client, asParameter((copied = latest)));
      const run = startTurn(wanted, client, markerId, Math.round(turn), ++number, signal);
      let last = 0;
      for await (const { round, length } of run.progress) listener.round(rounds + (last = round), length);
      rounds += last;
      let answer: Answered & { placed?: number };
      let gained: boolean;
      try {
        answer = await run.result;
        const shorter = best - answer.lengthAfter > 1e-6 * answer.lengthAfter;
        gained = shorter || (wanted.kind === "fillGaps" && (answer.placed ?? 0) > 0);
        if (gained) latest = await documentOf(client, markerId, copied);
      } catch (error) {
        if (await wasLost(error, () => copies.has(markerId))) continue;
        throw error;
      }
      if (gained) {
        best = Math.min(best, answer.lengthAfter);
        listener.better(answer, placementsIn(latest));
      }
      if (answer.stop === "converged" || (wanted.kind === "fine" && answer.stop !== "deadline")) return;
      inVain = gained ? 0 : inVain + turn;
      turn = gained ? turn : Math.min(2 * turn, LONGEST[where]);
    }
  } catch (error) {
    if (!signal.aborted) throw error;
  } finally {
    void copies.close(markerId);
  }
}

// Starts a call with this time limit; the number is the seed of its random choices.
function startTurn(wanted: Search, client: Client, markerId: string, deadlineMs: number, number: number, signal: AbortSignal) {
  switch (wanted.kind) {
    case "fine": return client.start("motion.compact", { markerId, accuracy: "fine", deadlineMs }, { signal });
    case "nest": return client.start("marker.nest", { markerId, seconds: deadlineMs / 1000, seed: number }, { signal });
    case "fillGaps": return client.start("marker.fillGaps", { markerId, deadlineMs, seed: number }, { signal });
    case "compactExactly": {
      const among = wanted.among && { among: wanted.among };
      return client.start("marker.compactExactly", { markerId, deadlineMs, ...among }, { signal });
    }
  }
}

// Whether the copy is unknown because its connection was lost, which the page may learn a moment later.
async function wasLost(error: unknown, has: () => boolean): Promise<boolean> {
  if (!hasCode(error, Code.UnknownMarker)) return false;
  await new Promise((resolve) => setTimeout(resolve));
  return !has();
}

// The copy as it is now; `copied` is what it was when it was opened.
async function documentOf(client: Client, markerId: string, copied: MarkerDocument): Promise<MarkerDocument> {
  const { placements, marker } = await client.call("marker.get", { markerId, since: 1 });
  if (!placements) return marker as unknown as MarkerDocument;
  const byId = new Map(placements.map(({ id, at, rotation, flip, tilt }) => [id, { at, rotation, flip, tilt }]));
  return { ...copied, pieces: copied.pieces.map((piece) => ({ ...piece, ...byId.get(String(piece.id)) })) };
}

const placementsIn = (document: MarkerDocument): Placements =>
  document.pieces.map(({ id, at, rotation = 0, flip = false, tilt = 0 }) => ({ id: String(id), at, rotation, flip, tilt }));

const asParameter = (document: MarkerDocument) => document as unknown as Record<string, unknown>;
