// The part of Node's socket types that lines.ts uses, so that the package builds without @types/node.
declare module "node:net" {
  interface Socket {
    setEncoding(encoding: "utf8"): void;
    setNoDelay(on: boolean): void;
    on(event: "data", listener: (text: string) => void): this;
    on(event: "connect" | "close", listener: () => void): this;
    on(event: "error", listener: (error: Error) => void): this;
    write(text: string): boolean;
    end(): void;
  }
  export function connect(options: { host: string; port: number } | { path: string }): Socket;
}
