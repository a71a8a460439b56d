import type { Answer } from "../../typescript/src/index";
import { Signal } from "../base/signal";
import { say } from "../texts/texts";
import type { Desk } from "./desk";
import { errorText } from "./messages";

export type StoredMarker = Answer<"library.list">["markers"][number];

const MOST = 40; // number of stored markers that are listed

/** The daemon's library of stored markers, whose arrangements new orders can reuse. */
export class Library {
  /** The number of markers in the library. */
  readonly count = new Signal(0);

  constructor(
    private readonly desk: Desk,
    private readonly showMessage: (text: string) => void,
  ) {
    desk.link.joined.follow((connections) => connections > 0 && void this.newest().catch(() => {}));
  }

  /** The most recently stored markers, the newest first. */
  async newest(): Promise<StoredMarker[]> {
    const client = await this.desk.link.ready();
    const { count } = await client.call("library.list", { most: 1 });
    this.count.value = count;
    if (count === 0) return [];
    const { markers } = await client.call("library.list", { offset: Math.max(0, count - MOST), most: MOST });
    return markers.reverse();
  }

  /** Stores the current revision of the marker that is shown. */
  store = (): void =>
    void this.trying(async () => {
      const client = await this.desk.link.ready();
      const { name, id, added } = await client.call("library.add", { markerId: this.desk.markerId });
      await this.newest();
      this.showMessage(say(added ? "stored" : "storedAlready", { name: name || id }));
    });

  /** Opens a copy of a stored marker, so that editing it does not change the library. */
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
      this.showMessage(errorText(error));
    }
  }
}
