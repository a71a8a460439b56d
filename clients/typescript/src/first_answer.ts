import type { Connect, Connection, Listener } from "./connection.js";
import { CallError, ConnectionLost, type ErrorData } from "./errors.js";

const firstCall = JSON.stringify({ jsonrpc: "2.0", id: "first", method: "engine.info", params: {} });

/** A connection to a daemon, which tells as long as `instance` is the same that its ids name the same markers. */
export interface Greeted extends Connection {
  instance: string | undefined;
}

// The daemon's instance. Throws the error of the answer, if it has one.
function read(text: string): string | undefined {
  let answer: { result?: { instance?: string }; error?: { code: number; message: string; data?: ErrorData } };
  try {
    answer = JSON.parse(text);
  } catch {
    throw new ConnectionLost("the server at this address is not a Selvage daemon");
  }
  if (answer.error) throw new CallError(answer.error.code, answer.error.message, answer.error.data);
  return answer.result?.instance;
}

/**
 * A transport whose connections count as open only after the daemon has answered a first call, because a daemon that is
 * full or rejects the token accepts a connection and then ends it. If the daemon answers with an error, connecting
 * rejects with that CallError; if the connection ends without an answer, with ConnectionLost.
 */
export const afterFirstAnswer =
  (connect: Connect): ((listener: Listener) => Promise<Greeted>) =>
  (listener) =>
    new Promise((resolve, reject) => {
      let state: "waiting" | "open" | "refused" = "waiting";
      let connection: Connection;
      const receiveFirst = (text: string) => {
        try {
          const instance = read(text);
          state = "open";
          resolve({ send: (message) => connection.send(message), close: () => connection.close(), instance });
        } catch (error) {
          state = "refused";
          reject(error);
          connection.close();
        }
      };
      connect({
        message(text) {
          if (state === "open") listener.message(text);
          else if (state === "waiting") receiveFirst(text);
        },
        closed(reason) {
          if (state === "open") listener.closed(reason);
          else reject(new ConnectionLost(reason));
        },
      }).then((made) => {
        connection = made;
        connection.send(firstCall);
      }, reject);
    });
