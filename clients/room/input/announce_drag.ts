import type { Client } from "../../typescript/src/index";
import type { Piece } from "../marker/marker";
import type { Desk } from "../session/desk";

const MOST = 8; // number of pieces that are announced; the daemon allows 16 drag sessions on one connection

/**
 * Announces to other users which pieces are being dragged while only this page moves them, by drag sessions without moves. The
 * returned function ends these sessions. Its promise resolves when the requests have been sent, so that whatever is sent
 * afterwards reaches other users later. Without a connection nothing is announced.
 */
export function announceDrag(desk: Desk, pieces: readonly Piece[]): () => Promise<void> {
  const { markerId } = desk;
  const begin = async (client: Client, { id }: Piece) => (await client.call("drag.begin", { markerId, piece: id })).dragId;
  const begun = desk.link.ready().then((client) => Promise.all(pieces.slice(0, MOST).map((piece) => begin(client, piece).catch(() => undefined))));
  return async () => {
    const drags = await begun;
    const client = await desk.link.ready();
    for (const dragId of drags) if (dragId !== undefined) void client.call("drag.end", { dragId, markerId, commit: false }).catch(() => {});
  };
}
