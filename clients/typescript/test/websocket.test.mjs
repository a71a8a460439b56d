// Over a WebSocket.
import assert from "node:assert/strict";
import test from "node:test";

import { Client, overWebSocket } from "../dist/index.js";
import { squares, startDaemon, token } from "./daemon.mjs";
import { Socket } from "./socket.mjs";

test("a marker is compacted over a WebSocket", async () => {
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

test("an unreachable WebSocket address is reported", async () => {
  await assert.rejects(Client.open(overWebSocket("ws://127.0.0.1:1/ws", { Socket })), /cannot reach/);
});

test("a page sends its token in the first message", async () => {
  const daemon = await startDaemon({ locked: true });
  const url = `ws://127.0.0.1:${daemon.port}/ws`;
  const client = await Client.open(overWebSocket(url, { token, Socket }));
  assert.equal((await client.call("engine.info", {})).name, "selvage");
  client.close();
  await daemon.stop();
});
