// Two browsers on one marker, connections that are lost, and edits that clash.
import assert from "node:assert/strict";
import { test } from "node:test";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { assertValid, atRevision, call, revision, shown, spot, squares, startDaemon, story, visit, withBrowser } from "./visit.mjs";

const here = withBrowser();

test("what one does the other sees, and is told", () =>
  story(here, async (page, port) => {
    const { markerId } = await shown(page, port);
    const other = await visit(here.browser, port, { marker: markerId });
    await page.key("c");
    await page.until(`document.querySelector("#offer").dataset.shown === "yes"`);
    await page.key("Enter");
    await atRevision(other, 2);
    await other.until(`document.querySelector("#toast").textContent.includes("Changed elsewhere")`);
    assert.equal(await other.text("#length"), "2,452.2 mm");
    const [x, y] = await spot(other, "20");
    await other.drag([x, y], [x + 30, y - 20]);
    await atRevision(page, 3);
    assert.deepEqual(await spot(page, "20"), await spot(other, "20"));
    assert.deepEqual(other.faults, []);
  }));

test("two hands on one piece: the second is told in words, and nothing is lost", () =>
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
    assert.deepEqual(await spot(page, "20"), await spot(other, "20"));
    await assertValid(port, markerId);
  }));

test("a daemon that dies and comes back with its store: shown, retried, nothing lost", async () => {
  const folder = mkdtempSync(join(tmpdir(), "selvage-store-"));
  const more = ["--store", join(folder, "store")];
  const first = await startDaemon({ more });
  const page = await visit(here.browser, first.port);
  await page.until(`document.querySelector("#keeps-nothing").offsetParent === null`);
  const [x, y] = await spot(page, "20");
  await page.drag([x, y], [x + 30, y - 20], { hold: true });
  await first.stop("SIGKILL");
  await page.until(`document.querySelector("#status").dataset.state === "lost"`);
  // The hand goes on; the piece follows it, and is put down although there is no daemon.
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

test("a daemon that comes back without the marker gets it from the page", async () => {
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
