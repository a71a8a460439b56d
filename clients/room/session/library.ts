import type { Answer } from "../../typescript/src/index";
import { Signal } from "../base/signal";
import { say } from "../texts/texts";
import type { Desk } from "./desk";
import { inWords } from "./words";

export type StoredMarker = Answer<"library.list">["markers"][number];

const MOST = 40; // that are listed

/** The daemon's library of stored markers, whose arrangements orders take over. */
export class Library {
  /** How many markers it holds. */
  readonly count = new Signal(0);

  constructor(
    private readonly desk: Desk,
    private readonly tell: (text: string) => void,
  ) {
    desk.link.joined.follow((connections) => connections > 0 && void this.newest().catch(() => {}));
  }

  /** The markers that were stored last, the newest first. */
  async newest(): Promise<StoredMarker[]> {
    const client = await this.desk.link.ready();
    const { count } = await client.call("library.list", { most: 1 });
    this.count.value = count;
    if (count === 0) return [];
    const { markers } = await client.call("library.list", { offset: Math.max(0, count - MOST), most: MOST });
    return markers.reverse();
  }

  /** Stores the present revision of the marker on the table. */
  store = (): void =>
    void this.trying(async () => {
      const client = await this.desk.link.ready();
      const { name, id, added } = await client.call("library.add", { markerId: this.desk.markerId });
      await this.newest();
      this.tell(say(added ? "stored" : "storedAlready", { name: name || id }));
    });

  /** Opens a stored marker as a new one, which may be edited: the library keeps its own. */
  open = (id: string): void =>
    void this.trying(async () => {
      const client = await this.desk.link.ready();
      const { marker } = await client.call("library.get", { id });
      await this.desk.open(marker as Record<string, unknown>);
    });

  private async trying(act: () => Promise<void>): Promise<void> {
    try {
      await act();
    } catch (error) {
      this.tell(inWords(error));
    }
  }
}
