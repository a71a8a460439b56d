/** The part of the system interface of WebAssembly programs (WASI preview 1) that the engine needs: a clock and a console. */
const DONE = 0;
const NO_SUCH_FILE = 8;
const NOT_THERE = 52;
const NANOSECONDS = 1e6; // per millisecond

type Call = (...values: any[]) => unknown;

/** The system calls for a program; `memory` is called when a system call is made. */
export function systemCalls(memory: () => WebAssembly.Memory, log: (text: string) => void): Record<string, Call> {
  const view = () => new DataView(memory().buffer);
  const bytes = (at: number, count: number) => new Uint8Array(memory().buffer, at, count);
  const text = new TextDecoder();
  const known: Record<string, Call> = {
    clock_time_get(_clock: number, _precision: bigint, at: number) {
      view().setBigUint64(at, BigInt(Math.round(performance.now() * NANOSECONDS)), true);
      return DONE;
    },
    random_get(at: number, count: number) {
      crypto.getRandomValues(bytes(at, count));
      return DONE;
    },
    environ_sizes_get(count: number, size: number) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return DONE;
    },
    environ_get: () => DONE,
    fd_write(_file: number, parts: number, count: number, written: number) {
      let total = 0;
      for (let k = 0; k < count; ++k) {
        const length = view().getUint32(parts + 8 * k + 4, true);
        log(text.decode(bytes(view().getUint32(parts + 8 * k, true), length)));
        total += length;
      }
      view().setUint32(written, total, true);
      return DONE;
    },
    fd_prestat_get: () => NO_SUCH_FILE,
    proc_exit(code: number) {
      throw new Error(`the engine ended with ${code}`);
    },
  };
  return new Proxy(known, { get: (calls, name: string) => calls[name] ?? (() => NOT_THERE) });
}
