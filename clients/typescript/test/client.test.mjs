import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";

import { CallError, Client, Code, ConnectionLost } from "../dist/index.js";
import { overLines } from "../dist/lines.js";
import { squares, startDaemon } from "./daemon.mjs";

async function withClient(work) {
  const daemon = await startDaemon();
  const client = await Client.open(overLines({ host: "127.0.0.1", port: daemon.port }));
  try {
    await work(client, daemon);
  } finally {
    client.close();
    await daemon.stop();
  }
}

test("a marker is opened, shortened and read", () =>
  withClient(async (client) => {
    const opened = await client.call("marker.open", { marker: squares(2) });
    assert.equal(opened.length, 90);
    const done = await client.call("motion.compact", { markerId: opened.markerId });
    assert.equal(done.lengthAfter, 80);
    assert.equal(done.valid, true);
    const { marker } = await client.call("marker.get", { markerId: opened.markerId });
    assert.equal(marker.pieces.length, 2);
  }));

test("an error has a code, a name and a field", () =>
  withClient(async (client) => {
    await assert.rejects(client.call("marker.get", { markerId: "nobody" }), { name: "CallError", code: Code.UnknownMarker });
    const wrong = client.call("motion.compact", { markerId: "m1", rounds: -1 });
    await assert.rejects(wrong, (error) => error instanceof CallError && error.data.field === "/rounds");
  }));

test("a motion reports its rounds in order, and then its result", () =>
  withClient(async (client) => {
    const { markerId } = await client.call("marker.open", { marker: squares(9) });
    const run = client.start("motion.compact", { markerId });
    const rounds = [];
    for await (const { round } of run.progress) rounds.push(round);
    const result = await run.result;
    assert.ok(rounds.length > 0);
    assert.deepEqual(rounds, [...rounds].sort((a, b) => a - b));
    assert.ok(result.lengthAfter < result.lengthBefore);
  }));

test("an abort signal cancels the call, and nothing is committed", () =>
  withClient(async (client) => {
    const { markerId } = await client.call("marker.open", { marker: squares(300) });
    const abort = new AbortController();
    const run = client.start("motion.velocity", { markerId }, { signal: abort.signal });
    abort.abort();
    await assert.rejects(run.result, { name: "CallError", code: Code.Cancelled });
    const [listed] = (await client.call("marker.list", {})).markers;
    assert.equal(listed.revision, 1);
    await assert.rejects(client.call("marker.list", {}, { signal: abort.signal }), { code: Code.Cancelled });
  }));

test("watching clients are notified of changes", () =>
  withClient(async (client) => {
    const { markerId } = await client.call("marker.open", { marker: squares(2) });
    await client.call("marker.watch", { markerId });
    const notified = new Promise((resolve) => client.on("marker.changed", resolve));
    await client.call("marker.apply", { markerId, ops: [{ op: "move", piece: "p1", by: [5, 0] }] });
    const change = await notified;
    assert.equal(change.by, "marker.apply");
    assert.equal(change.placements[0].id, "p1");
  }));

test("a call whose answer is lost with the connection is repeated, and carried out once", async () => {
  const daemon = await startDaemon();
  const connect = overLines({ host: "127.0.0.1", port: daemon.port });
  // A transport that drops the next answer and ends the connection.
  let swallow = false;
  const lossy = async (listener) => {
    let broken = false;
    const connection = await connect({
      message: (text) => {
        if (broken || swallow) {
          swallow = false;
          if (!broken) connection.close();
          broken = true;
        } else {
          listener.message(text);
        }
      },
      closed: listener.closed,
    });
    return connection;
  };
  const client = await Client.open(lossy, { patience: 1 });
  const { markerId } = await client.call("marker.open", { marker: squares(2) });
  swallow = true;
  const change = await client.call("marker.apply", { markerId, ops: [{ op: "move", piece: "p1", by: [5, 0] }] });
  assert.equal(change.revision, 2);
  assert.equal(change.placements[0].at[0], 55);
  assert.equal((await client.call("marker.list", {})).markers[0].revision, 2);
  swallow = true;
  await assert.rejects(client.call("marker.list", {}), ConnectionLost);
  client.close();
  await daemon.stop();
});

test("a call is sent again to a restarted daemon", async () => {
  const folder = mkdtempSync(join(tmpdir(), "selvage-"));
  const more = ["--store", join(folder, "store.sqlite")];
  const first = await startDaemon({ more });
  const client = await Client.open(overLines({ host: "127.0.0.1", port: first.port }), { attempts: 12, patience: 10 });
  const { markerId } = await client.call("marker.open", { marker: squares(2) });
  await first.stop("SIGKILL");
  const done = client.call("motion.compact", { markerId });
  const second = await startDaemon({ port: first.port, more });
  assert.equal((await done).lengthAfter, 80);
  client.close();
  await second.stop();
  rmSync(folder, { recursive: true });
});

test("a call on a marker is not sent to a daemon that was started again without a store", async () => {
  const first = await startDaemon();
  const client = await Client.open(overLines({ host: "127.0.0.1", port: first.port }), { attempts: 12, patience: 50 });
  const { instance } = client;
  const { markerId } = await client.call("marker.open", { marker: squares(2) });
  await first.stop("SIGKILL");
  const compacted = client.call("motion.compact", { markerId });
  const opened = client.call("marker.open", { marker: squares(3) });
  const refused = assert.rejects(compacted, { name: "CallError", code: Code.UnknownMarker });
  const second = await startDaemon({ port: first.port });
  await refused;
  assert.equal((await opened).markerId, markerId);
  assert.notEqual(client.instance, instance);
  assert.equal((await client.call("marker.list", {})).markers[0].revision, 1);
  client.close();
  await second.stop();
});

test("when no daemon can be reached again, every call rejects", async () => {
  const daemon = await startDaemon();
  const client = await Client.open(overLines({ host: "127.0.0.1", port: daemon.port }), { attempts: 1 });
  await daemon.stop("SIGKILL");
  await assert.rejects(client.call("marker.open", { marker: squares(2) }), ConnectionLost);
  await assert.rejects(client.call("marker.list", {}), ConnectionLost);
});
