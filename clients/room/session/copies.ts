import type { Client } from "../../typescript/src/index";
import type { Link } from "./link";

/**
 * Markers that this page opens in the daemon for itself, such as the copy on which a search works. Each is closed when it is no
 * longer needed, over another connection if its own was lost, and when the page goes.
 */
export class Copies {
  private readonly open = new Map<string, string | undefined>(); // the instance of the daemon in which it is open, by id

  constructor(private readonly link: Link) {
    addEventListener("pagehide", () => {
      this.link.sendLast([...this.open].map(([markerId]) => ({ method: "marker.close", params: { markerId } })));
      this.open.clear();
    });
  }

  async make(client: Client, document: Record<string, unknown>): Promise<string> {
    const { markerId } = await client.call("marker.open", { marker: document });
    this.open.set(markerId, client.instance);
    return markerId;
  }

  /** Whether the client leads to where the copy is open. In another instance of the daemon its id may be that of another marker. */
  has(markerId: string, client: Client): boolean {
    return this.open.has(markerId) && this.open.get(markerId) === client.instance;
  }

  async close(markerId: string): Promise<void> {
    const client = await this.link.ready();
    const isHere = this.has(markerId, client);
    this.open.delete(markerId);
    if (isHere) await client.call("marker.close", { markerId }).catch(() => {});
  }
}
