/** A connection to a daemon, which carries messages as text in both directions. */
export interface Connection {
  send(text: string): void;
  close(): void;
}

/** The callbacks of a connection. `closed` is called at most once, and nothing is called after it. */
export interface Listener {
  message(text: string): void;
  closed(reason: string): void;
}

/** A transport: opens a connection, or rejects if that fails. It is called again after a connection was lost. */
export type Connect = (listener: Listener) => Promise<Connection>;

type SocketClass = new (url: string) => WebSocket;

/** The first message on a connection to a daemon that requires a token. */
export const authorisation = (token: string): string => JSON.stringify({ jsonrpc: "2.0", method: "auth", params: { token } });

/** Connects over a WebSocket: `ws://127.0.0.1:7171/ws`. Node before 22 has no WebSocket: pass the class of the package `ws`. */
export function overWebSocket(url: string, options: { token?: string; Socket?: SocketClass } = {}): Connect {
  const { token, Socket = globalThis.WebSocket } = options;
  return (listener) =>
    new Promise((resolve, reject) => {
      const socket = new Socket(url);
      let open = false;
      socket.onopen = () => {
        open = true;
        if (token !== undefined) socket.send(authorisation(token));
        resolve({ send: (text) => socket.send(text), close: () => socket.close() });
      };
      socket.onmessage = (event: { data: unknown }) => listener.message(String(event.data));
      socket.onerror = () => reject(new Error(`cannot reach ${url}`));
      socket.onclose = () => (open ? listener.closed(`${url} ended the connection`) : reject(new Error(`cannot reach ${url}`)));
    });
}
