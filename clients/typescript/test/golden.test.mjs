// Replays each file of golden exchanges through the client to a fresh daemon.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import test from "node:test";

import { CallError, Client } from "../dist/index.js";
import { overLines } from "../dist/lines.js";
import { startDaemon } from "./daemon.mjs";

const folder = new URL("../../../tests/golden/rpc/", import.meta.url);

function alike(expected, actual) {
  if (expected === "$any") return true;
  if (typeof expected !== "object" || expected === null || typeof actual !== "object" || actual === null) return expected === actual;
  const keys = Object.keys(expected);
  return keys.length === Object.keys(actual).length && keys.every((key) => key in actual && alike(expected[key], actual[key]));
}

const isCall = ({ request }) => typeof request === "object" && request.jsonrpc === "2.0" && typeof request.method === "string";

for (const name of readdirSync(folder).filter((file) => file.endsWith(".json"))) {
  test(`golden exchanges: ${name}`, async (t) => {
    const daemon = await startDaemon({ more: ["--workers", "1"] });
    const client = await Client.open(overLines({ host: "127.0.0.1", port: daemon.port }));
    t.after(() => {
      client.close();
      return daemon.stop();
    });
    let played = 0;
    for (const { request, response } of JSON.parse(readFileSync(new URL(name, folder), "utf8")).filter(isCall)) {
      if (Array.isArray(request.params) || typeof request.id === "object") continue; // the client never sends such calls
      const answer = await client.call(request.method, request.params).then(
        (result) => ({ result }),
        (error) => {
          assert.ok(error instanceof CallError, String(error));
          return { error: { code: error.code, message: error.message, data: error.data } };
        },
      );
      const expected = response.error ? { error: { data: {}, ...response.error } } : { result: response.result };
      assert.ok(alike(expected, answer), `${JSON.stringify(request)}\nexpected ${JSON.stringify(expected)}\nanswered ${JSON.stringify(answer)}`);
      ++played;
    }
    assert.ok(played > 0);
  });
}
