// Connects over TCP or a Unix socket, with a JSON message per line. For Node only; it needs no package.
import { connect } from "node:net";
import { authorisation, type Connect } from "./connection.js";

export function overLines(address: { host: string; port: number } | { path: string }, token?: string): Connect {
  return (listener) =>
    new Promise((resolve, reject) => {
      const socket = connect(address);
      let open = false;
      let rest = "";
      socket.setEncoding("utf8");
      socket.on("connect", () => {
        open = true;
        if ("port" in address) socket.setNoDelay(true);
        if (token !== undefined) socket.write(authorisation(token) + "\n");
        resolve({ send: (text) => void socket.write(text + "\n"), close: () => socket.end() });
      });
      socket.on("data", (text) => {
        const lines = (rest + text).split("\n");
        rest = lines.pop() ?? "";
        for (const line of lines) listener.message(line);
      });
      socket.on("error", reject);
      socket.on("close", () => open && listener.closed("the daemon ended the connection"));
    });
}
