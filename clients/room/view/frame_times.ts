/** The latest measurements of one kind, in milliseconds. */
export class Times {
  private readonly kept: number[] = [];
  private next = 0;

  constructor(private readonly capacity = 2000) {}

  add(milliseconds: number): void {
    this.kept[this.next] = milliseconds;
    this.next = (this.next + 1) % this.capacity;
  }
  clear(): void {
    this.kept.length = 0;
    this.next = 0;
  }
  get last(): number {
    return this.kept[(this.next + this.capacity - 1) % this.capacity] ?? 0;
  }

  summary(): { count: number; p50: number; p95: number; p99: number; most: number } {
    const sorted = [...this.kept].sort((a, b) => a - b);
    const at = (part: number) => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))] ?? 0;
    return { count: sorted.length, p50: at(0.5), p95: at(0.95), p99: at(0.99), most: at(1) };
  }
}

/** The page's measurements: script time per frame, time to draw the settled pieces, and time from a pointer move to the answer with the new places. */
export const times = { frame: new Times(), settled: new Times(), answer: new Times() };
