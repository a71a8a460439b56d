import type { Connect, Connection } from "./connection.js";
import { CallError, ConnectionLost, type ErrorData } from "./errors.js";

const greeting = JSON.stringify({ jsonrpc: "2.0", id: "greeting", method: "engine.info", params: {} });

// Throws what the daemon refused the greeting with.
function judge(text: string): void {
  let answer: { error?: { code: number; message: string; data?: ErrorData } };
  try {
    answer = JSON.parse(text);
  } catch {
    throw new ConnectionLost("what answers there is no Selvage daemon");
  }
  if (answer.error) throw new CallError(answer.error.code, answer.error.message, answer.error.data);
}

/**
 * Connections that count once the daemon has answered on them: one that is full, or does not know the token, takes a
 * connection only to end it. A refusal rejects with its CallError, an end without a word with ConnectionLost.
 */
export const greeted =
  (connect: Connect): Connect =>
  (listener) =>
    new Promise((resolve, reject) => {
      let state: "silent" | "greeted" | "refused" = "silent";
      let connection: Connection;
      const hear = (text: string) => {
        try {
          judge(text);
          state = "greeted";
          resolve(connection);
        } catch (error) {
          state = "refused";
          reject(error);
          connection.close();
        }
      };
      connect({
        message(text) {
          if (state === "greeted") listener.message(text);
          else if (state === "silent") hear(text);
        },
        closed(reason) {
          if (state === "greeted") listener.closed(reason);
          else reject(new ConnectionLost(reason));
        },
      }).then((made) => {
        connection = made;
        connection.send(greeting);
      }, reject);
    });
