import type { Connect, Connection } from "./connection.js";
import { CallError, ConnectionLost, type ErrorData } from "./errors.js";

const firstCall = JSON.stringify({ jsonrpc: "2.0", id: "first", method: "engine.info", params: {} });

// Throws the error of the answer, if it has one.
function check(text: string): void {
  let answer: { error?: { code: number; message: string; data?: ErrorData } };
  try {
    answer = JSON.parse(text);
  } catch {
    throw new ConnectionLost("the server at this address is not a Selvage daemon");
  }
  if (answer.error) throw new CallError(answer.error.code, answer.error.message, answer.error.data);
}

/**
 * A transport whose connections count as open only after the daemon has answered a first call, because a daemon that is
 * full or rejects the token accepts a connection and then ends it. If the daemon answers with an error, connecting
 * rejects with that CallError; if the connection ends without an answer, with ConnectionLost.
 */
export const afterFirstAnswer =
  (connect: Connect): Connect =>
  (listener) =>
    new Promise((resolve, reject) => {
      let state: "waiting" | "open" | "refused" = "waiting";
      let connection: Connection;
      const receiveFirst = (text: string) => {
        try {
          check(text);
          state = "open";
          resolve(connection);
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
