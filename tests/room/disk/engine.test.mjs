// The engine of a page that opens from disk, without the page: ENGINE names engine.wasm. It is the daemon without transport,
// threads and store, so it answers the golden exchanges as the daemon does; only layouts and worths that small linear programs
// decide may differ, because one of the two solvers is left out.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { after, test } from "node:test";

const work = mkdtempSync(join(tmpdir(), "selvage-engine-"));
after(() => rmSync(work, { recursive: true }));
const here = (name) => fileURLToPath(new URL(name, import.meta.url));
execFileSync("esbuild", [here("../../../clients/room/standalone/system.ts"), "--format=esm", "--log-level=warning", `--outfile=${join(work, "system.mjs")}`]);
const { systemCalls } = await import(pathToFileURL(join(work, "system.mjs")).href);
const program = await WebAssembly.compile(readFileSync(process.env.ENGINE));

/** A new engine: a function that answers a message, with the notifications before the answer. */
async function begin() {
  let engine;
  let messages = [];
  const send = (at, bytes) => void messages.push(JSON.parse(new TextDecoder().decode(new Uint8Array(engine.memory.buffer, at, bytes))));
  const log = (text) => console.log(text);
  engine = (await WebAssembly.instantiate(program, { wasi_snapshot_preview1: systemCalls(() => engine.memory, log), page: { send } })).exports;
  engine._initialize();
  return (message) => {
    messages = [];
    const text = new TextEncoder().encode(JSON.stringify(message));
    const at = engine.allocate(text.length);
    new Uint8Array(engine.memory.buffer, at, text.length).set(text);
    engine.receive(at, text.length);
    return messages;
  };
}

function alike(expected, actual) {
  if (expected === "$any") return true;
  if (typeof expected !== "object" || expected === null || typeof actual !== "object" || actual === null) return expected === actual;
  const keys = Object.keys(expected);
  return keys.length === Object.keys(actual).length && keys.every((key) => key in actual && alike(expected[key], actual[key]));
}

const SAME = ["changes", "dragged", "dragging", "life_of_a_marker", "mistakes", "watching"];
const folder = new URL("../../golden/rpc/", import.meta.url);
for (const name of readdirSync(folder).filter((file) => file.endsWith(".json"))) {
  const same = SAME.includes(name.replace(".json", ""));
  test(`golden exchanges: ${name}${same ? "" : ", except results of small linear programs"}`, async () => {
    const call = await begin();
    let count = 0;
    for (const { request, response } of JSON.parse(readFileSync(new URL(name, folder), "utf8"))) {
      const messages = call(request);
      const answer = messages.find((message) => !("method" in message));
      if (same) assert.ok(alike(response, answer), `${JSON.stringify(request)}\nexpected ${JSON.stringify(response)}\nanswered ${JSON.stringify(answer)}`);
      else if (response?.error) assert.equal(answer.error?.code, response.error.code, JSON.stringify(request));
      else if (response !== undefined) assert.ok(answer.result && answer.result.valid === response.result.valid, JSON.stringify(answer));
      ++count;
    }
    assert.ok(count > 4);
  });
}

test("a deadline ends a search, and progress is reported while it runs", async () => {
  const call = await begin();
  const marker = JSON.parse(readFileSync(here("../../../examples/markers/jeans_02g.json"), "utf8"));
  call({ jsonrpc: "2.0", id: 1, method: "marker.open", params: { marker } });
  const since = performance.now();
  const messages = call({ jsonrpc: "2.0", id: 2, method: "motion.compact", params: { markerId: "m1", accuracy: "fine", deadlineMs: 400, progressToken: "p" } });
  assert.ok(performance.now() - since < 20_000);
  assert.equal(messages.at(-1).result.stop, "deadline");
  assert.ok(messages.some(({ method }) => method === "$/progress"));
  assert.equal(messages.at(-1).result.valid, true);
});
