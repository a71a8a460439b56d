import type { Client } from "../../typescript/src/index";
import type { Link } from "./link";

/**
 * Markers that this page opens in the daemon for itself, such as the copy on which a search works. Each is closed when it is no
 * longer needed. The daemon closes it when its connection ends: when the page goes, the browser fails, or the connection is lost.
 */
export class Copies {
  private readonly open = new Map<string, number>(); // the number of the connection that a copy belongs to, by id

  constructor(private readonly link: Link) {}

  async make(client: Client, document: Record<string, unknown>): Promise<string> {
    const { markerId } = await client.call("marker.open", { marker: document, closeWithConnection: true });
    this.open.set(markerId, this.link.joined.value);
    return markerId;
  }

  /** Whether the copy is still open. After a lost connection it is not, and its id may be that of another marker. */
  has(markerId: string): boolean {
    return this.open.get(markerId) === this.link.joined.value;
  }

  async close(markerId: string): Promise<void> {
    const client = await this.link.ready();
    const isOpen = this.has(markerId);
    this.open.delete(markerId);
    if (isOpen) await client.call("marker.close", { markerId }).catch(() => {});
  }
}
