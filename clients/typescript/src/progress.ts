import type { Notifications } from "./methods.js";

export type Round = Notifications["$/progress"];

/** The progress notifications of one motion. The iteration ends with the motion; it can be made once. */
export class Progress implements AsyncIterable<Round> {
  private readonly waiting: Round[] = [];
  private ended = false;
  private wake: () => void = () => {};

  /** @internal */
  add(round: Round): void {
    this.waiting.push(round);
    this.wake();
  }
  /** @internal */
  end(): void {
    this.ended = true;
    this.wake();
  }

  async *[Symbol.asyncIterator](): AsyncIterator<Round> {
    for (;;) {
      for (let round = this.waiting.shift(); round; round = this.waiting.shift()) yield round;
      if (this.ended) return;
      await new Promise<void>((resolve) => (this.wake = resolve));
    }
  }
}
