import type { Answer, Client } from "../../typescript/src/index";
import { Signal } from "../base/signal";
import type { Desk } from "../session/desk";
import type { Scene } from "../view/scene";
import { fitting, smallestOf, type Regions } from "./fits";

const MANY = 1000; // in markers with more pieces, selecting a piece is no reason to request the critical path

/** The marker and the revision that an answer is about. */
type Asked = Pick<Regions, "markerId" | "revision">;

/** The critical path and the free cloth of the current revision, which are requested only while they are shown. */
export class Insight {
  readonly chainShown = new Signal(false);
  readonly regionsShown = new Signal(false);
  readonly chain = new Signal<Answer<"marker.hold"> | undefined>(undefined);
  readonly regions = new Signal<Regions | undefined>(undefined);
  /** The indices of the regions into which the smallest piece fits, as far as they have been searched. */
  readonly fits = new Signal<ReadonlySet<number>>(new Set());
  /** How much the marker's length depends on each piece: the load of the contacts on its left. */
  readonly worth = new Signal<ReadonlyMap<string, number>>(new Map());
  private waiting = 0;
  private panelOpen = false;

  constructor(
    private readonly desk: Desk,
    private readonly scene: Scene,
  ) {
    desk.figures.follow(() => this.renew());
    scene.selection.follow(() => this.mayTilt && this.renew());
    this.chainShown.follow(() => this.renew());
    this.regionsShown.follow(() => this.renew());
  }

  /** The panel that explains the length needs the chain, too. */
  set wanted(open: boolean) {
    this.panelOpen = open;
    this.renew();
  }

  /** Whether exactly one piece is selected and may tilt: the worth of a degree is then written on it. */
  private get mayTilt(): boolean {
    const [only, ...others] = this.scene.selected();
    return only !== undefined && others.length === 0 && only.shape.tiltLimit > 0 && this.scene.marker!.pieces.length <= MANY;
  }

  private renew(): void {
    clearTimeout(this.waiting);
    this.waiting = window.setTimeout(() => void this.ask(), 120);
    this.show();
  }

  private async ask(): Promise<void> {
    const { markerId } = this.desk;
    const { revision, valid } = this.desk.figures.value;
    if (!markerId || !valid) return;
    const client = await this.desk.link.ready();
    const known = (answer: Asked | undefined) => answer?.markerId === markerId && answer.revision === revision;
    try {
      if ((this.chainShown.value || this.panelOpen || this.mayTilt) && !known(this.chain.value)) {
        this.chain.value = await client.call("marker.hold", { markerId, deadlineMs: 20_000 });
        this.worth.value = worths(this.chain.value);
      }
      if (this.regionsShown.value && !known(this.regions.value)) {
        this.regions.value = await client.call("marker.regions", { markerId, deadlineMs: 20_000 });
        void this.findFits(client, this.regions.value).catch(() => {}); // repeated for the next revision
      }
    } catch {
      return; // repeated for the next revision
    }
    this.show();
  }

  // Shows the regions that fit as they are found, for as long as these regions are shown.
  private async findFits(client: Client, regions: Regions): Promise<void> {
    this.fits.value = new Set();
    const piece = this.desk.marker.value && smallestOf(this.desk.marker.value);
    if (!piece) return;
    for await (const { index, fits } of fitting(client, regions, piece)) {
      if (this.regions.value !== regions || !this.isCurrent(regions)) return;
      if (!this.regionsShown.value) return void (this.regions.value = undefined); // requested again when they are shown again
      if (!fits) continue;
      this.fits.value = new Set([...this.fits.value, index]);
      this.show();
    }
  }

  private isCurrent({ markerId, revision }: Asked): boolean {
    return markerId === this.desk.markerId && revision === this.desk.figures.value.revision;
  }

  private show(): void {
    const current = <T extends Asked>(answer: T | undefined) => (answer && this.isCurrent(answer) ? answer : undefined);
    const chain = current(this.chain.value);
    this.scene.chain = this.chainShown.value ? chain : undefined;
    this.scene.tilts = chain?.tilts ?? [];
    this.scene.regions = this.regionsShown.value ? current(this.regions.value) : undefined;
    this.scene.fits = this.fits.value;
    this.scene.onChange("settled");
  }
}

// The load of a contact is split between its two pieces, because a piece passes on to its right the load from its left.
function worths(chain: Answer<"marker.hold">): Map<string, number> {
  const loads = new Map<string, number>();
  const add = (id: string | undefined, worth: number) => id !== undefined && loads.set(id, (loads.get(id) ?? 0) + worth / 2);
  for (const { piece, other, edge, worth } of chain.contacts) {
    add(piece, edge === "top" || edge === "bottom" ? 0 : worth);
    add(other, worth);
  }
  return loads;
}
