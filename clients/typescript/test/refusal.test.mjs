// Daemons that take a connection only to end it: such attempts are counted, and every call is answered in the end.
import assert from "node:assert/strict";
import test from "node:test";

import { Client, Code, ConnectionLost, overWebSocket } from "../dist/index.js";
import { overLines } from "../dist/lines.js";
import { squares, startDaemon, token } from "./daemon.mjs";
import { Socket } from "./socket.mjs";

const roads = {
  lines: ({ port }, shown) => overLines({ host: "127.0.0.1", port }, shown),
  WebSocket: ({ port }, shown) => overWebSocket(`ws://127.0.0.1:${port}/ws`, { token: shown, Socket }),
};

/** First a connection that greets and breaks at the first call, then those of `connect`; `count`: all of them. */
function brokenFirst(connect) {
  const ways = { count: 0 };
  const breaking = async (listener) => ({
    send: (text) => (JSON.parse(text).id === "greeting" ? queueMicrotask(() => listener.message("{}")) : listener.closed("it broke")),
    close: () => {},
  });
  ways.connect = (listener) => (ways.count++ === 0 ? breaking : connect)(listener);
  return ways;
}

for (const [road, way] of Object.entries(roads)) {
  test(`over ${road}, a wrong token is said at once`, async () => {
    const daemon = await startDaemon({ locked: true });
    await assert.rejects(Client.open(way(daemon, "wrong horse battery")), { name: "CallError", code: Code.Unauthorised });
    await assert.rejects(Client.open(way(daemon)), { name: "CallError", code: Code.Unauthorised });
    const client = await Client.open(way(daemon, token));
    client.close();
    await daemon.stop();
  });

  test(`over ${road}, a token that is no longer right ends the client: its calls say so`, async () => {
    const daemon = await startDaemon({ locked: true });
    const ways = brokenFirst(way(daemon, "wrong horse battery"));
    const client = await Client.open(ways.connect, { patience: 1 });
    const calls = [1, 2].map(() => client.call("marker.open", { marker: squares(2) }));
    for (const call of calls) await assert.rejects(call, { name: "CallError", code: Code.Unauthorised });
    await assert.rejects(client.call("marker.list", {}), { name: "CallError", code: Code.Unauthorised });
    assert.equal(ways.count, 2);
    await daemon.stop();
  });

  test(`over ${road}, a daemon that has no room for another connection is asked as often as was said`, async () => {
    const daemon = await startDaemon({ more: ["--max-connections", "1"] });
    const other = await Client.open(way(daemon));
    const ways = brokenFirst(way(daemon));
    const client = await Client.open(ways.connect, { attempts: 3, patience: 1 });
    await assert.rejects(client.call("marker.open", { marker: squares(2), opId: "once" }), ConnectionLost);
    await assert.rejects(client.call("marker.list", {}), ConnectionLost);
    assert.equal(ways.count, 1 + 3);
    other.close();
    await daemon.stop();
  });
}

test("a call that breaks every connection it is sent on is given up", async () => {
  const daemon = await startDaemon({ more: ["--max-body-mb", "1"] });
  const connect = roads.WebSocket(daemon);
  let count = 0;
  const client = await Client.open((listener) => (++count, connect(listener)), { attempts: 2, patience: 1 });
  const long = { ...squares(2), name: "x".repeat(1 << 20) };
  await assert.rejects(client.call("marker.open", { marker: long }), ConnectionLost);
  assert.equal((await client.call("marker.open", { marker: squares(2) })).length, 90);
  assert.equal(count, 1 + 3);
  client.close();
  await daemon.stop();
});

test("over lines, a call that is too long is said so", async () => {
  const daemon = await startDaemon({ more: ["--max-body-mb", "1"] });
  const client = await Client.open(roads.lines(daemon));
  const long = { ...squares(2), name: "x".repeat(1 << 20) };
  const calls = [client.call("marker.list", {}), client.call("marker.open", { marker: long })];
  await assert.rejects(calls[1], { name: "CallError", code: Code.TooLarge });
  assert.deepEqual((await calls[0]).markers, []);
  client.close();
  await daemon.stop();
});

test("what answers but is no daemon is said so", async () => {
  const stranger = async (listener) => ({ send: () => queueMicrotask(() => listener.message("220 welcome")), close: () => {} });
  await assert.rejects(Client.open(stranger), { name: "ConnectionLost", message: /no Selvage daemon/ });
});
