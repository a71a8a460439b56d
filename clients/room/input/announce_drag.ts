import type { Client } from "../../typescript/src/index";
import type { Piece } from "../marker/marker";
import type { Desk } from "../session/desk";

const MOST = 8; // pieces that are announced; the daemon allows 16 drags on one connection

/**
 * Announces to other users which pieces are dragged while only this page moves them, by drag sessions without moves. The function
 * that is returned ends them, and is done when the ends have been sent: others hear of what is sent then after them. Without a
 * connection nothing is announced, and the pieces are merely not marked.
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
