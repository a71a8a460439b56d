// Two browsers on one marker, connections that are lost, and edits that clash.
import assert from "node:assert/strict";
import { test } from "node:test";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { assertValid, atRevision, call, example, revision, shown, spot, squares, startDaemon, story, visit, withBrowser } from "./visit.mjs";

const here = withBrowser();

/** Waits until both pages show the piece at the same place, after its animation. */
async function assertSeenAlike(page, other, piece) {
  const [x, y] = await other.ask(`new Promise((resolve) => setTimeout(() => resolve(selvageRoom.spotOf("${piece}")), 400))`);
  await page.until(`Math.hypot(selvageRoom.spotOf("${piece}")[0] - ${x}, selvageRoom.spotOf("${piece}")[1] - ${y}) < 0.01`, "the same place in both");
}

test("each page shows and reports the changes of the other", () =>
  story(here, async (page, port) => {
    const { markerId } = await shown(page, port);
    const other = await visit(here.browser, port, { marker: markerId });
    await page.key("c");
    await page.until(`document.querySelector("#offer").dataset.shown === "yes"`);
    await page.key("Enter");
    await atRevision(other, 2);
    await other.until(`document.querySelector("#toast").textContent.includes("Changed elsewhere: edited, now 2,452.2 mm")`);
    assert.equal(await other.text("#length"), "2,452.2 mm");
    const [x, y] = await spot(other, "20");
    await other.drag([x, y], [x + 30, y - 20]);
    await atRevision(page, 3);
    await assertSeenAlike(page, other, "20");
    assert.deepEqual(other.faults, []);
  }));

test("two users drag one piece: the second gets a message, and nothing is lost", () =>
  story(here, async (page, port) => {
    const { markerId } = await shown(page, port);
    const other = await visit(here.browser, port, { marker: markerId });
    const [x, y] = await spot(page, "20");
    await page.drag([x, y], [x + 20, y - 20], { hold: true });
    await other.drag([x, y], [x - 20, y + 20], { hold: true });
    await page.mouse("mouseReleased", x + 20, y - 20);
    await atRevision(other, 2);
    await other.mouse("mouseReleased", x - 20, y + 20);
    await other.until(`document.querySelector("#toast").textContent.includes("changed this marker first")`);
    await other.until("selvageRoom.view().shown === 0");
    assert.equal((await call(port, "marker.get", { markerId })).revision, 2);
    await assertSeenAlike(page, other, "20");
    await assertValid(port, markerId);
  }));

test("a drop that fails is taken back alone: a change that another user made meanwhile stays", () =>
  story(here, async (page, port) => {
    const opened = await call(port, "marker.open", { marker: example("jeans_22g") });
    const { marker } = await call(port, "marker.get", { markerId: opened.markerId });
    marker.strip.longest = Math.ceil(opened.length); // there is no room for a separation
    const { markerId } = await call(port, "marker.open", { marker });
    const other = await visit(here.browser, port, { marker: markerId });
    await other.key("0");
    const [x, y] = await spot(other, "0");
    const before = await call(port, "marker.get", { markerId });
    await other.drag([x, y], [x + 420, y + 8], { modifiers: 8 });
    await atRevision(other, 2);
    await call(port, "marker.apply", { markerId, ops: [{ op: "lock", piece: "400", locked: true }] });
    await other.until(`document.querySelector("#toast").textContent.includes("no free place")`);
    const after = await call(port, "marker.get", { markerId });
    const piece = (of, id) => of.marker.pieces.find((one) => one.id === id);
    assert.equal(piece(after, "400").locked, true);
    assert.deepEqual(piece(after, "0").at, piece(before, "0").at);
    await assertValid(port, markerId);
  }));

test("a daemon is killed and restarted with its store: the page shows it, retries, and loses nothing", async () => {
  const folder = mkdtempSync(join(tmpdir(), "selvage-store-"));
  const more = ["--store", join(folder, "store")];
  const first = await startDaemon({ more });
  const page = await visit(here.browser, first.port);
  await page.until(`document.querySelector("#keeps-nothing").offsetParent === null`);
  const [x, y] = await spot(page, "20");
  await page.drag([x, y], [x + 30, y - 20], { hold: true });
  await first.stop("SIGKILL");
  await page.until(`document.querySelector("#status").dataset.state === "lost"`);
  // The drag continues; the piece follows it and is put down although there is no daemon.
  await page.mouse("mouseMoved", x + 60, y - 40);
  await page.mouse("mouseReleased", x + 60, y - 40);
  const second = await startDaemon({ port: first.port, more });
  await page.until(`document.querySelector("#status").dataset.state === "open"`);
  await atRevision(page, 2);
  const { markerId, marker } = await shown(page, second.port);
  assert.notDeepEqual(marker.pieces.find(({ id }) => id === "20").at, undefined);
  await assertValid(second.port, markerId);
  await second.stop();
  rmSync(folder, { recursive: true });
});

// From now on, new connections of the page keep back the answer to its first marker.list until the test delivers it.
const keepBackTheList = (page) =>
  page.ask(`{
    const Socket = WebSocket;
    globalThis.WebSocket = class extends Socket {
      set onmessage(receive) {
        super.onmessage = (event) => {
          if (globalThis.deliverTheList || !/"markers":.*"markerId":/.test(event.data)) return receive(event);
          globalThis.deliverTheList = () => receive(event);
        };
      }
    };
  }`);

test("a change that is reported while the page reads the marker again is not lost", async () => {
  const folder = mkdtempSync(join(tmpdir(), "selvage-store-"));
  const more = ["--store", join(folder, "store")];
  const first = await startDaemon({ more });
  const page = await visit(here.browser, first.port);
  const { markerId } = await shown(page, first.port);
  await keepBackTheList(page);
  await first.stop("SIGKILL");
  const second = await startDaemon({ port: first.port, more });
  await page.until("!!globalThis.deliverTheList", "the list of markers");
  await call(second.port, "motion.compact", { markerId });
  await atRevision(page, 2);
  await page.ask("void deliverTheList()");
  await page.until(`document.querySelector("#toast").textContent.includes("Connected again")`);
  assert.equal(await revision(page), 2);
  assert.equal(await page.text("#length"), "2,452.2 mm");
  await second.stop();
  rmSync(folder, { recursive: true });
});

test("a daemon that is restarted without the marker gets it from the page", async () => {
  const first = await startDaemon();
  const page = await visit(here.browser, first.port);
  await page.key("c");
  await page.until(`document.querySelector("#offer").dataset.shown === "yes"`);
  await page.key("Enter");
  await atRevision(page, 2);
  await first.stop("SIGKILL");
  await page.until(`document.querySelector("#status").dataset.state === "lost"`);
  const second = await startDaemon({ port: first.port });
  await page.until(`document.querySelector("#toast").textContent.includes("opened again")`);
  const { markers } = await call(second.port, "marker.list");
  assert.equal(markers.length, 1);
  assert.equal(markers[0].length, 2452.178013);
  await second.stop();
});

test("another marker that has the same id after a restart is not taken for the page's own", async () => {
  const first = await startDaemon();
  const page = await visit(here.browser, first.port);
  const { markerId, marker } = await shown(page, first.port);
  await first.stop("SIGKILL");
  await page.until(`document.querySelector("#status").dataset.state === "lost"`);
  // The page meets the daemon only once another marker is open there.
  await page.ask(`{
    const Socket = WebSocket;
    globalThis.WebSocket = function (url) { return new Socket(globalThis.mayConnect ? url : url.replace(/:\\d+/, ":1")); };
  }`);
  const second = await startDaemon({ port: first.port });
  const other = await call(second.port, "marker.open", { marker: squares(3) });
  assert.equal(other.markerId, markerId);
  await page.ask("void (globalThis.mayConnect = true)");
  await page.until(`document.querySelector("#toast").textContent.includes("opened again")`);
  const now = await shown(page, second.port);
  assert.notEqual(now.markerId, markerId);
  assert.equal(now.marker.pieces.length, marker.pieces.length);
  const { markers } = await call(second.port, "marker.list");
  assert.deepEqual(markers.map(({ pieces }) => pieces), [3, marker.pieces.length]);
  await second.stop();
});

test("kept results fit only the marker that they were made of, also after a restart that gives its id to another one", async () => {
  const first = await startDaemon();
  const page = await visit(here.browser, first.port);
  const { markerId } = await shown(page, first.port);
  const keep = async (cards) => {
    await page.key("k");
    await page.until(`document.querySelectorAll("#beside .card").length === ${cards}`);
  };
  const fitting = () => page.ask(`[...document.querySelectorAll("#beside button")].filter((one) => one.textContent === "Apply").map((one) => !one.disabled)`);
  await keep(2); // with the card of the marker as it was opened
  const other = await call(first.port, "marker.open", { marker: squares(5) });
  await page.ask(`void (location.hash = "${other.markerId}")`);
  await page.until(`selvageRoom.view().markerId === "${other.markerId}"`);
  await keep(3);
  assert.deepEqual(await fitting(), [false, true]);
  await first.stop("SIGKILL");
  await page.until(`document.querySelector("#status").dataset.state === "lost"`);
  const second = await startDaemon({ port: first.port });
  await page.until(`document.querySelector("#toast").textContent.includes("opened again")`);
  assert.equal((await shown(page, second.port)).markerId, markerId);
  await page.ask("selvageRoom.view()");
  assert.deepEqual(await fitting(), [false, true]);
  await second.stop();
});

test("a piece that one user drags is marked at its position for all others until it is released", () =>
  story(here, async (page, port) => {
    const { markerId } = await shown(page, port);
    const other = await visit(here.browser, port, { marker: markerId });
    const [x, y] = await spot(page, "20");
    await page.drag([x, y], [x + 30, y - 20], { hold: true });
    await other.until(`selvageRoom.draggedByOthers().includes("20")`, "the mark");
    assert.deepEqual(await page.ask("selvageRoom.draggedByOthers()"), []);
    // Whoever comes meanwhile sees it, too.
    const third = await visit(here.browser, port, { marker: markerId });
    await third.until(`selvageRoom.draggedByOthers().includes("20")`, "the mark for who comes later");
    await other.drag([x, y], [x + 6, y], { hold: true });
    await other.until(`document.querySelector("#toast").textContent.includes("Someone else is also dragging")`);
    await other.key("Escape");
    await page.mouse("mouseReleased", x + 30, y - 20);
    await atRevision(other, 2);
    for (const watching of [other, third]) await watching.until(`selvageRoom.draggedByOthers().length === 0`, "no mark any more");
    // A piece that is moved freely is marked, too; a page that is closed lets go.
    const [u, v] = await spot(third, "3");
    await third.drag([u, v], [u + 9, v], { hold: true, modifiers: 8 });
    await other.until(`selvageRoom.draggedByOthers().includes("3")`, "the mark of a free drag");
    await third.close();
    await other.until(`selvageRoom.draggedByOthers().length === 0`, "no mark after the page is gone");
  }));

test("a watcher is notified that a piece was released before it is notified of its new position", () =>
  story(here, async (page, port) => {
    const { markerId } = await shown(page, port);
    const other = await visit(here.browser, port, { marker: markerId });
    const heard = [];
    here.browser.on(({ method, params, sessionId }) => {
      if (sessionId !== other.session || method !== "Network.webSocketFrameReceived") return;
      const message = JSON.parse(params.response.payloadData);
      if (message.method === "marker.changed") heard.push("changed");
      if (message.method === "marker.dragged") heard.push(`${message.params.pieces.length} held`);
    });
    const [x, y] = await spot(page, "20");
    for (const [k, modifiers] of [0, 8].entries()) {
      heard.length = 0;
      await page.drag([x + 20 * k, y], [x + 20 * k + 20, y], { modifiers });
      await atRevision(other, 2 + k);
      await other.until("selvageRoom.draggedByOthers().length === 0");
      assert.ok(heard.includes("1 held"), heard.join());
      assert.ok(heard.includes("changed"), heard.join());
      assert.equal(heard[heard.indexOf("changed") - 1], "0 held", heard.join());
    }
  }));
