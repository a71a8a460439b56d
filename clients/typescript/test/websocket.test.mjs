// Over a WebSocket, where there is a class of that name: Node's own (22, or 20 with --experimental-websocket), or ws.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";

import { Client, overWebSocket } from "../dist/index.js";
import { squares, startDaemon } from "./daemon.mjs";

const Socket = globalThis.WebSocket ?? (await import("ws").then((ws) => ws.WebSocket, () => undefined));

test("a marker over a WebSocket", { skip: Socket ? false : "no WebSocket here" }, async () => {
  const daemon = await startDaemon();
  const client = await Client.open(overWebSocket(`ws://127.0.0.1:${daemon.port}/ws`, { Socket }));
  const { markerId } = await client.call("marker.open", { marker: squares(2) });
  const run = client.start("motion.compact", { markerId });
  let rounds = 0;
  for await (const round of run.progress) rounds += round.round > 0 ? 1 : 0;
  assert.ok(rounds > 0);
  assert.equal((await run.result).lengthAfter, 80);
  client.close();
  await daemon.stop();
});

test("a WebSocket that leads nowhere is said so", { skip: Socket ? false : "no WebSocket here" }, async () => {
  await assert.rejects(Client.open(overWebSocket("ws://127.0.0.1:1/ws", { Socket })), /cannot reach/);
});

test("a page shows its token in the first message", { skip: Socket ? false : "no WebSocket here" }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "selvage-"));
  const file = join(folder, "token");
  writeFileSync(file, "correct horse battery\n");
  const daemon = await startDaemon({ more: ["--token-file", file] });
  const url = `ws://127.0.0.1:${daemon.port}/ws`;
  const client = await Client.open(overWebSocket(url, { token: "correct horse battery", Socket }));
  assert.equal((await client.call("engine.info", {})).name, "selvage");
  client.close();
  const stranger = await Client.open(overWebSocket(url, { token: "wrong horse battery", Socket }));
  await assert.rejects(stranger.call("engine.info", {}), { name: "ConnectionLost" });
  stranger.close();
  await daemon.stop();
  rmSync(folder, { recursive: true });
});
