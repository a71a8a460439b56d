/** A way to a daemon: messages as text, either way. */
export interface Connection {
  send(text: string): void;
  close(): void;
}

/** What a connection tells of itself. `closed` is told once, and nothing after it. */
export interface Listener {
  message(text: string): void;
  closed(reason: string): void;
}

/** Opens a connection; rejects when there is none to be had. Called again after a connection was lost. */
export type Connect = (listener: Listener) => Promise<Connection>;

type SocketClass = new (url: string) => WebSocket;

/** What the first message says to a daemon that asks for a token. */
export const authorisation = (token: string): string => JSON.stringify({ jsonrpc: "2.0", method: "auth", params: { token } });

/** Over a WebSocket: `ws://127.0.0.1:7171/ws`. Node before 22 has none of its own: pass the class of the package `ws`. */
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
