import type { Connect, Connection, Listener } from "./connection.js";
import { CallError, Code, ConnectionLost, type ErrorData } from "./errors.js";
import { afterFirstAnswer, type Greeted } from "./first_answer.js";
import { retriable, type Methods, type Notifications } from "./methods.js";
import { Progress } from "./progress.js";

export type Motion = Extract<keyof Methods, `motion.${string}` | "marker.nest" | "marker.remake" | "marker.fillGaps" | "marker.compactExactly">;
export type Params<M extends keyof Methods> = Methods[M]["params"];
export type Answer<M extends keyof Methods> = Methods[M]["result"];

export interface CallOptions {
  /** Cancels the call, which then rejects with the code -32800, unless its answer was already on its way. */
  signal?: AbortSignal;
}
export interface ClientOptions {
  /** How many times the client tries to reconnect before all calls reject; the count restarts when the daemon answers. Default: 5. */
  attempts?: number;
  /** The delay before the second attempt in milliseconds; it doubles with each further attempt. Default: 100. */
  patience?: number;
}

/** For this many milliseconds after the connection was restored, calls are sent again if the daemon is busy. */
const INSIST = 10_000;

interface Pending {
  method: string;
  text: string;
  ofMarker: boolean; // it names an open marker or a drag session
  retriesLeft: number; // how often it may still be sent again on another connection
  resolve(result: unknown): void;
  reject(error: Error): void;
}
interface Message {
  id?: number | null;
  method?: string;
  params?: unknown;
  result?: unknown;
  error?: { code: number; message: string; data?: ErrorData };
}

const unauthorised = (error: unknown): error is CallError => error instanceof CallError && error.code === Code.Unauthorised;
const wait = (milliseconds: number) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/**
 * Calls the methods of one daemon. When the connection is lost, the client reconnects and sends every unanswered call that takes
 * an `opId` again with the same `opId`, so that it is carried out once; other calls reject with ConnectionLost. Watches and drag
 * sessions end with their connection: watch again on "reconnected". If the daemon was started again without a store, its ids may
 * name other markers: unanswered calls on markers then reject with UnknownMarker, and `instance` changes. If the daemon rejects the token, the client is closed and
 * every call rejects with the daemon's error.
 */
export class Client {
  /** The daemon's instance: as long as it is the same, an id names the same marker. */
  instance: string | undefined;
  private connection: Connection | undefined;
  private closedBy: Error | undefined; // why the client is closed; every call rejects with it
  private insistUntil = 0; // in milliseconds since 1970
  private ids = 0;
  private readonly name = Math.random().toString(36).slice(2) + Date.now().toString(36);
  private readonly pending = new Map<number, Pending>();
  private readonly rounds = new Map<string, Progress>();
  private readonly listeners = new Map<string, Set<(params: never) => void>>();

  private constructor(
    private readonly connect: (listener: Listener) => Promise<Greeted>,
    private readonly options: Required<ClientOptions>,
  ) {}

  static async open(connect: Connect, options: ClientOptions = {}): Promise<Client> {
    const client = new Client(afterFirstAnswer(connect), { attempts: 5, patience: 100, ...options });
    await client.openConnection();
    return client;
  }

  call<M extends keyof Methods>(method: M, params: Params<M>, options: CallOptions = {}): Promise<Answer<M>> {
    const id = ++this.ids;
    const canRetry = retriable.has(method);
    const withId = canRetry ? { opId: `${this.name}-${id}`, ...params } : params;
    const text = JSON.stringify({ jsonrpc: "2.0", id, method, params: withId });
    const { signal } = options;
    return new Promise<Answer<M>>((resolve, reject) => {
      if (this.closedBy) return reject(this.closedBy);
      if (signal?.aborted) return reject(new CallError(Code.Cancelled, "cancelled before it was sent"));
      const cancel = () => this.cancel(id);
      const done = () => signal?.removeEventListener("abort", cancel);
      signal?.addEventListener("abort", cancel);
      this.pending.set(id, {
        method,
        text,
        ofMarker: ["markerId", "dragId"].some((name) => name in (params ?? {})),
        retriesLeft: canRetry ? this.options.attempts : 0,
        resolve: (result) => (done(), resolve(result as Answer<M>)),
        reject: (error) => (done(), reject(error)),
      });
      if (this.connection || !canRetry) this.send(id);
    });
  }

  /** Starts a motion with progress notifications: `for await (const round of run.progress)`, then `await run.result`. */
  start<M extends Motion>(method: M, params: Params<M>, options: CallOptions = {}) {
    const progress = new Progress();
    const progressToken = `${this.name}-${this.ids + 1}`;
    this.rounds.set(progressToken, progress);
    const result = this.call(method, { ...params, progressToken }, options).finally(() => {
      this.rounds.delete(progressToken);
      progress.end();
    });
    result.catch(() => {}); // not an unhandled rejection: a caller that awaits the result still receives the error
    return { progress, result };
  }

  /** Calls the listener for each notification of this name, or on "reconnected". Returns a function that unsubscribes. */
  on<N extends keyof Notifications>(name: N, listener: (params: Notifications[N]) => void): () => void;
  on(name: "reconnected", listener: () => void): () => void;
  on(name: string, listener: (params: never) => void): () => void {
    const listeners = this.listeners.get(name) ?? new Set();
    this.listeners.set(name, listeners.add(listener));
    return () => void listeners.delete(listener);
  }

  close(): void {
    this.end(new ConnectionLost("the client is closed"));
  }

  private async openConnection(): Promise<void> {
    let ended = false; // the connection may end before `connect` resolves
    let connection: Greeted | undefined;
    connection = await this.connect({
      message: (text) => this.receive(JSON.parse(text) as Message),
      closed: (reason) => {
        ended = true;
        if (connection && this.connection === connection) void this.lost(reason);
      },
    });
    if (ended) throw new ConnectionLost("the connection ended at once");
    if (this.closedBy) {
      connection.close();
      throw this.closedBy;
    }
    this.connection = connection;
    const { instance } = connection;
    if (this.instance !== undefined && instance !== undefined && instance !== this.instance) {
      const lost = () => new CallError(Code.UnknownMarker, "the daemon was started again and no longer has this marker", { field: "/markerId" });
      this.giveUp((call) => call.ofMarker, lost);
    }
    this.instance = instance ?? this.instance;
  }

  private async lost(reason: string): Promise<void> {
    this.connection = undefined;
    this.giveUp((call) => call.retriesLeft-- === 0, (call) => new ConnectionLost(`${call.method}: ${reason}`));
    for (let k = 0; k < this.options.attempts && !this.closedBy; ++k) {
      if (k > 0) await wait(this.options.patience * 2 ** (k - 1));
      try {
        await this.openConnection();
      } catch (error) {
        if (unauthorised(error)) return this.end(error);
        continue;
      }
      this.insistUntil = Date.now() + INSIST;
      for (const id of this.pending.keys()) this.send(id);
      return this.notify("reconnected", undefined);
    }
    this.end(new ConnectionLost(reason));
  }

  private end(why: Error): void {
    this.closedBy ??= why;
    this.connection?.close();
    this.giveUp(() => true, () => why);
  }

  private giveUp(which: (call: Pending) => boolean, why: (call: Pending) => Error): void {
    for (const [id, call] of this.pending) {
      if (!which(call)) continue;
      this.pending.delete(id);
      call.reject(why(call));
    }
  }

  private send(id: number): void {
    const call = this.pending.get(id);
    if (!call) return;
    if (this.connection) return this.connection.send(call.text);
    this.pending.delete(id);
    call.reject(new ConnectionLost(`${call.method}: there is no connection`));
  }

  // A daemon that has just been started may still be loading its markers, and has done nothing of the call.
  private async sendLater(id: number, { retryAfterMs }: ErrorData = {}): Promise<void> {
    await wait(retryAfterMs ?? this.options.patience);
    if (this.connection) this.send(id); // otherwise it is sent on the next connection
  }

  private cancel(id: number): void {
    const text = JSON.stringify({ jsonrpc: "2.0", method: "$/cancelRequest", params: { id } });
    if (this.connection) return this.connection.send(text);
    const call = this.pending.get(id);
    this.pending.delete(id);
    call?.reject(new CallError(Code.Cancelled, "cancelled while there was no connection"));
  }

  private receive(message: Message): void {
    if (message.method !== undefined) return this.notify(message.method, message.params);
    const { error } = message;
    const id = message.id ?? (error && this.longest());
    const call = this.pending.get(id ?? -1);
    if (!call) return;
    // A drag's move is not sent again: it would come after later ones.
    if (error?.code === Code.Busy && !call.method.startsWith("drag.") && Date.now() < this.insistUntil)
      return void this.sendLater(id as number, error.data);
    this.pending.delete(id as number);
    if (error) call.reject(new CallError(error.code, error.message, error.data));
    else call.resolve(message.result);
  }

  /** The longest unanswered call. An answer without an id refuses a call that was too long for the daemon to read. */
  private longest(): number | undefined {
    const [first] = [...this.pending].sort(([, one], [, other]) => other.text.length - one.text.length);
    return first?.[0];
  }

  private notify(name: string, params: unknown): void {
    if (name === "$/progress") {
      const round = params as Notifications["$/progress"];
      this.rounds.get(String(round.token))?.add(round);
    }
    for (const listener of this.listeners.get(name) ?? []) listener(params as never);
  }
}
