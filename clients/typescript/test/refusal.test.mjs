// Daemons that accept a connection and then end it: such attempts count, and every call is answered in the end.
import assert from "node:assert/strict";
import test from "node:test";

import { Client, Code, ConnectionLost, overWebSocket } from "../dist/index.js";
import { overLines } from "../dist/lines.js";
import { squares, startDaemon, token } from "./daemon.mjs";
import { Socket } from "./socket.mjs";

const transports = {
  lines: ({ port }, shown) => overLines({ host: "127.0.0.1", port }, shown),
  WebSocket: ({ port }, shown) => overWebSocket(`ws://127.0.0.1:${port}/ws`, { token: shown, Socket }),
};

/** A transport whose first connection breaks at the first call, and whose others are those of `connect`; `count` counts them. */
function brokenFirst(connect) {
  const transport = { count: 0 };
  const breaking = async (listener) => ({
    send: (text) => (JSON.parse(text).id === "first" ? queueMicrotask(() => listener.message("{}")) : listener.closed("it broke")),
    close: () => {},
  });
  transport.connect = (listener) => (transport.count++ === 0 ? breaking : connect)(listener);
  return transport;
}

for (const [name, connectTo] of Object.entries(transports)) {
  test(`over ${name}, a wrong token is reported at once`, async () => {
    const daemon = await startDaemon({ locked: true });
    await assert.rejects(Client.open(connectTo(daemon, "wrong horse battery")), { name: "CallError", code: Code.Unauthorised });
    await assert.rejects(Client.open(connectTo(daemon)), { name: "CallError", code: Code.Unauthorised });
    const client = await Client.open(connectTo(daemon, token));
    client.close();
    await daemon.stop();
  });

  test(`over ${name}, a token that is no longer valid closes the client, and its calls report that`, async () => {
    const daemon = await startDaemon({ locked: true });
    const transport = brokenFirst(connectTo(daemon, "wrong horse battery"));
    const client = await Client.open(transport.connect, { patience: 1 });
    const calls = [1, 2].map(() => client.call("marker.open", { marker: squares(2) }));
    for (const call of calls) await assert.rejects(call, { name: "CallError", code: Code.Unauthorised });
    await assert.rejects(client.call("marker.list", {}), { name: "CallError", code: Code.Unauthorised });
    assert.equal(transport.count, 2);
    await daemon.stop();
  });

  test(`over ${name}, the client makes all its attempts to reach a daemon that accepts no more connections`, async () => {
    const daemon = await startDaemon({ more: ["--max-connections", "1"] });
    const other = await Client.open(connectTo(daemon));
    const transport = brokenFirst(connectTo(daemon));
    const client = await Client.open(transport.connect, { attempts: 3, patience: 1 });
    await assert.rejects(client.call("marker.open", { marker: squares(2), opId: "once" }), ConnectionLost);
    await assert.rejects(client.call("marker.list", {}), ConnectionLost);
    assert.equal(transport.count, 1 + 3);
    other.close();
    await daemon.stop();
  });
}

test("a call that breaks every connection is given up", async () => {
  const daemon = await startDaemon({ more: ["--max-body-mb", "1"] });
  const connect = transports.WebSocket(daemon);
  let count = 0;
  const client = await Client.open((listener) => (++count, connect(listener)), { attempts: 2, patience: 1 });
  const long = { ...squares(2), name: "x".repeat(1 << 20) };
  await assert.rejects(client.call("marker.open", { marker: long }), ConnectionLost);
  assert.equal((await client.call("marker.open", { marker: squares(2) })).length, 90);
  assert.equal(count, 1 + 3);
  client.close();
  await daemon.stop();
});

test("over lines, a call that is too long rejects with that error", async () => {
  const daemon = await startDaemon({ more: ["--max-body-mb", "1"] });
  const client = await Client.open(transports.lines(daemon));
  const long = { ...squares(2), name: "x".repeat(1 << 20) };
  const calls = [client.call("marker.list", {}), client.call("marker.open", { marker: long })];
  await assert.rejects(calls[1], { name: "CallError", code: Code.TooLarge });
  assert.deepEqual((await calls[0]).markers, []);
  client.close();
  await daemon.stop();
});

test("a server that is not a Selvage daemon is reported", async () => {
  const stranger = async (listener) => ({ send: () => queueMicrotask(() => listener.message("220 welcome")), close: () => {} });
  await assert.rejects(Client.open(stranger), { name: "ConnectionLost", message: /not a Selvage daemon/ });
});

test("calls that a loading daemon refuses after the connection broke are sent again", async () => {
  let connections = 0;
  let calls = 0;
  const connect = async (listener) => {
    const breaks = connections++ === 0;
    const answer = (text) => {
      const { id } = JSON.parse(text);
      if (id === "first") return listener.message("{}");
      if (breaks) return listener.closed("it broke");
      const busy = { code: Code.Busy, message: "the server is loading its markers", data: { retryAfterMs: 1 } };
      listener.message(JSON.stringify({ jsonrpc: "2.0", id, ...(++calls % 3 > 0 ? { error: busy } : { result: { calls } }) }));
    };
    return { send: (text) => queueMicrotask(() => answer(text)), close: () => {} };
  };
  const client = await Client.open(connect, { patience: 1 });
  assert.deepEqual(await client.call("marker.undo", { markerId: "m1" }), { calls: 3 });
  assert.deepEqual(await client.call("marker.list", {}), { calls: 6 });
  client.close();
});

test("a connection that ends together with its first answer counts as ended at once", async () => {
  const transport = async (listener) => ({
    send: () => (listener.message("{}"), listener.closed("it broke")),
    close: () => {},
  });
  await assert.rejects(Client.open(transport), ConnectionLost);
});
