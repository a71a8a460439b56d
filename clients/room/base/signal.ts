/** An observable value. It calls its followers synchronously when it changes, in the order in which they subscribed. */
export class Signal<T> {
  private readonly followers = new Set<(value: T) => void>();

  constructor(private current: T) {}

  get value(): T {
    return this.current;
  }
  set value(next: T) {
    if (Object.is(next, this.current)) return;
    this.current = next;
    this.announce();
  }

  /** Calls the followers although the value is the same object, because something inside the object changed. */
  announce(): void {
    for (const follower of [...this.followers]) follower(this.current);
  }

  /** Calls the follower now and after every change. Returns a function that unsubscribes it. */
  follow(follower: (value: T) => void): () => void {
    this.followers.add(follower);
    follower(this.current);
    return () => void this.followers.delete(follower);
  }
}

/** Calls `draw` at most once per turn of the event loop, however many of the signals have changed. */
export function follow(signals: ReadonlyArray<Signal<any>>, draw: () => void): void {
  let waiting = false;
  const later = () => {
    if (waiting) return;
    waiting = true;
    queueMicrotask(() => {
      waiting = false;
      draw();
    });
  };
  for (const signal of signals) signal.follow(later);
}
