/**
 * Runs the engine in a worker of the page. The first message is the compressed WebAssembly program; every further one is a
 * message of the protocol. Answers and notifications are sent back as text. A fault ends the worker, as it would end a daemon.
 */
import { systemCalls } from "./system";

interface Engine {
  memory: WebAssembly.Memory;
  _initialize(): void;
  allocate(bytes: number): number;
  receive(at: number, bytes: number): void;
}

// The compiler's library of browser types does not have this class yet.
declare const DecompressionStream: new (format: "gzip") => ReadableWritablePair<Uint8Array, Uint8Array>;

const page = self as unknown as { postMessage(message: string | true): void; onmessage: (event: { data: ArrayBuffer | string }) => void };

async function started(program: ArrayBuffer): Promise<Engine> {
  const plain = new Response(new Blob([program]).stream().pipeThrough(new DecompressionStream("gzip")));
  const module = await WebAssembly.compile(await plain.arrayBuffer());
  const memory = () => engine.memory;
  const send = (at: number, bytes: number) => page.postMessage(new TextDecoder().decode(new Uint8Array(engine.memory.buffer, at, bytes)));
  const imports = { wasi_snapshot_preview1: systemCalls(memory, (text) => console.warn(text)), page: { send } };
  const engine = (await WebAssembly.instantiate(module, imports)).exports as unknown as Engine;
  engine._initialize();
  page.postMessage(true);
  return engine;
}

/** Throws outside of every promise, so that the error reaches the page. */
const fail = (fault: unknown) =>
  void setTimeout(() => {
    throw fault;
  });

let beginning: Promise<Engine> | undefined;

async function receive(message: string): Promise<void> {
  const engine = await beginning!;
  const text = new TextEncoder().encode(message);
  const at = engine.allocate(text.length);
  new Uint8Array(engine.memory.buffer, at, text.length).set(text);
  engine.receive(at, text.length);
}

page.onmessage = ({ data }) => {
  if (typeof data === "string") receive(data).catch(fail);
  else (beginning = started(data)).catch(fail);
};
