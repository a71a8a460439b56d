import type { Client } from "../../typescript/src/index";
import type { Piece } from "../marker/marker";
import type { Desk } from "../session/desk";

const MOST = 8; // pieces that are told; the daemon allows 16 drags on one connection

/**
 * Tells others that pieces are in this hand while only this page moves them: by drag sessions without moves. The answer ends
 * them. What is not told for want of a connection is no error: the pieces are merely not marked.
 */
export function tellInHand(desk: Desk, pieces: readonly Piece[]): () => void {
  const { markerId } = desk;
  const begin = async (client: Client, { id }: Piece) => (await client.call("drag.begin", { markerId, piece: id })).dragId;
  const begun = desk.link.ready().then((client) => Promise.all(pieces.slice(0, MOST).map((piece) => begin(client, piece).catch(() => undefined))));
  return () =>
    void begun.then(async (drags) => {
      const client = await desk.link.ready();
      for (const dragId of drags) if (dragId !== undefined) void client.call("drag.end", { dragId, markerId, commit: false }).catch(() => {});
    });
}
