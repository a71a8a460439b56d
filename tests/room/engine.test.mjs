// Motions by the engine: every result is shown first, and then taken, kept or dropped.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertValid, atRevision, call, choose, example, revision, shown, spot, squares, startDaemon, story, visit, withBrowser } from "./visit.mjs";

const here = withBrowser();
const offered = `document.querySelector("#offer").dataset.shown === "yes"`;
const gone = `document.querySelector("#offer").dataset.shown !== "yes"`;

// What the page shows is drawn in the frame after a marker or a result has come.
const lengthBecomes = (page, text) => page.until(`document.querySelector("#length").textContent === ${JSON.stringify(text)}`, `the length ${text}`);

test("compact, look, take, undo", () =>
  story(here, async (page, port) => {
    const { markerId } = await shown(page, port);
    const expected = await call(port, "motion.compact", { markerId, commit: false });
    await page.key("c");
    await page.until(offered);
    assert.equal(await revision(page), 1);
    await lengthBecomes(page, "2,452.2 mm");
    await page.key("Enter");
    await atRevision(page, 2);
    await page.until(gone);
    const { length, revision: now } = (await call(port, "marker.list")).markers[0];
    assert.equal(length, expected.lengthAfter);
    assert.equal(now, 2);
    await assertValid(port, markerId);
    await page.key("z", "control");
    await atRevision(page, 3);
    assert.equal((await call(port, "marker.list")).markers[0].length, 2460.35);
  }));

test("a dropped result leaves the marker as it was", () =>
  story(here, async (page) => {
    await page.press("Standard");
    await page.until(offered);
    await page.key("Escape");
    await page.until(gone);
    assert.equal(await revision(page), 1);
    await lengthBecomes(page, "2,460.4 mm");
  }));

test("a result waits beside another marker that is shown, and is not applied to it", () =>
  story(here, async (page, port) => {
    const { markerId } = await shown(page, port);
    const other = await call(port, "marker.open", { marker: example("jeans_06g") });
    const entry = `[...document.querySelectorAll("#marker-menu [role=menuitem]")].find((one) => one.textContent.includes("jeans_06g"))`;
    await page.key("c");
    await page.until(offered);
    await page.click("#menu");
    await page.until(`!!${entry}`);
    await page.ask(`${entry}.click()`);
    await page.until(`selvageRoom.view().markerId === "${other.markerId}"`);
    await page.until(gone);
    await page.until(`document.querySelectorAll("#beside .card").length > 0`);
    await page.ask(`document.querySelector("#top").focus()`);
    await page.key("Enter");
    await page.key("g");
    const { markers } = await call(port, "marker.list");
    assert.deepEqual(markers.map((one) => [one.markerId, one.revision]), [[markerId, 1], [other.markerId, 1]]);
  }));

test("kept results are compared and taken later, in one step, although the marker was edited meanwhile", () =>
  story(here, async (page, port) => {
    await page.press("Standard");
    await page.until(offered);
    await page.key("k");
    await page.until(`document.querySelectorAll("#beside .card").length === 2`);
    const [x, y] = await spot(page, "20");
    await page.drag([x, y], [x, y]);
    await page.key("ArrowRight");
    await page.until(`selvageRoom.revision() > 1 || document.querySelector("#toast").textContent.includes("cannot move")`);
    const { markerId } = await shown(page, port);
    await call(port, "marker.apply", { markerId, ops: [{ op: "lock", piece: "3", locked: true }] });
    await page.until(`document.querySelector("#beside").textContent.includes("edited while")`);
    const before = await revision(page);
    await page.press("Apply", "#beside");
    await atRevision(page, before + 1);
    assert.equal((await call(port, "marker.list")).markers[0].length, 2452.178013);
    await assertValid(port, markerId);
    await page.key("z", "control");
    await atRevision(page, before + 2);
  }));

test("the fine search shows its best result so far, draws its curve, and returns it when stopped", () =>
  story(here, async (page, port) => {
    await page.press("Fine");
    await page.until(offered, "a better marker while the search goes on");
    assert.ok(await page.ask(`!document.querySelector("#progress").hidden && !!document.querySelector("#progress .curve-line")`));
    await page.press("Stop");
    await page.until(`document.querySelector("#progress").hidden`);
    await page.until(offered);
    await page.key("Enter");
    await atRevision(page, 2);
    const [{ length, markerId }] = (await call(port, "marker.list")).markers;
    assert.ok(length < 2455);
    await assertValid(port, markerId);
    await page.until(`fetch("/healthz").then((r) => r.ok)`);
    assert.equal((await call(port, "marker.list")).markers.length, 1, "the search's copy is closed");
  }));

test("tilt, float, separate, relax", () =>
  story(here, async (page, port) => {
    const { markerId } = await shown(page, port);
    for (const name of ["Float", "Tilt"]) {
      await page.press(name);
      await page.until(offered, name);
      const before = await revision(page);
      await page.key("Enter");
      await atRevision(page, before + 1);
      await assertValid(port, markerId);
    }
    const { at } = (await shown(page, port)).marker.pieces[20];
    await call(port, "marker.apply", { markerId, ops: [{ op: "move", piece: "20", at: [at[0] + 15, at[1] + 5] }] });
    await page.until(`document.querySelector("#length + .figure-side").textContent === "not valid"`);
    await page.press("Separate");
    await page.until(offered, "separate");
    const before = await revision(page);
    await page.key("Enter");
    await atRevision(page, before + 1);
    await assertValid(port, markerId);
  }));

test("several pieces are aligned", async () => {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker: squares(4) });
  const page = await visit(here.browser, daemon.port, { marker: markerId });
  await page.key("a", "control");
  await page.click("#tab-pieces");
  await page.press("⤒ align");
  await page.until(offered);
  await page.key("Enter");
  await atRevision(page, 2);
  const tops = (await shown(page, daemon.port)).marker.pieces.map(({ at }) => at[1]);
  assert.deepEqual(new Set(tops).size, 1);
  await daemon.stop();
});

test("a gap opens along a drawn line, and pieces fall along a drawn arrow", async () => {
  const daemon = await startDaemon();
  const marker = { ...squares(4), strip: { width: 100, longest: 400 } };
  const { markerId } = await call(daemon.port, "marker.open", { marker });
  const page = await visit(here.browser, daemon.port, { marker: markerId });
  const [ax, ay] = await spot(page, "p1");
  const [bx] = await spot(page, "p2");
  await page.key("a");
  await page.drag([ax, ay], [ax, ay + 80]);
  await page.until(offered);
  await page.key("Enter");
  await atRevision(page, 2);
  const fallen = (await shown(page, daemon.port)).marker.pieces;
  assert.ok(fallen.every(({ at }) => at[1] === 0));
  await page.key("g");
  const middle = (ax + bx) / 2;
  await page.drag([middle, ay - 120], [middle, ay + 120]);
  await page.until(offered);
  await page.key("Enter");
  await atRevision(page, 3);
  const separated = (await shown(page, daemon.port)).marker.pieces;
  assert.ok(separated[2].at[0] - separated[1].at[0] > fallen[2].at[0] - fallen[1].at[0]);
  await daemon.stop();
});

test("nesting places unplaced pieces, shows its best result so far, and is taken in one step", async () => {
  const daemon = await startDaemon();
  const marker = { ...squares(1), unplaced: Array.from({ length: 9 }, (_, k) => ({ id: `u${k}`, shape: "square" })) };
  const { markerId } = await call(daemon.port, "marker.open", { marker });
  const page = await visit(here.browser, daemon.port, { marker: markerId });
  await page.press("Nest");
  await page.until(offered, "a first marker");
  assert.equal(await revision(page), 1);
  await page.until(`document.querySelector("#progress").hidden || !document.querySelector("#progress button").disabled`);
  await page.key("Enter");
  await page.until(`document.querySelector("#tray").hidden`, "an empty tray");
  const now = (await shown(page, daemon.port)).marker;
  assert.equal(now.pieces.length, 10);
  assert.equal(now.unplaced?.length ?? 0, 0);
  await assertValid(daemon.port, markerId);
  const { length } = (await call(daemon.port, "marker.list")).markers.find((one) => one.markerId === markerId);
  assert.equal(length, 200);
  assert.deepEqual(page.faults, []);
  await daemon.stop();
});

const ended = (page) => page.until(`document.querySelector("#progress").hidden`, "the end of the search");

/** Runs a motion on a marker by its button, takes what it offers, and answers with the marker's length then. */
async function lengthAfter(marker, name, { prepare = () => {}, wait = ended } = {}) {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker });
  const page = await visit(here.browser, daemon.port, { marker: markerId });
  await prepare(page);
  await page.press(name);
  await page.until(offered, name);
  assert.equal(await revision(page), 1);
  await wait(page);
  await page.key("Enter");
  await atRevision(page, 2);
  await assertValid(daemon.port, markerId);
  assert.deepEqual(page.faults, []);
  const { markers } = await call(daemon.port, "marker.list");
  await daemon.stop();
  return markers.find((one) => one.markerId === markerId);
}
const box = (id, width, height) => ({ id, outline: [[0, 0], [width, 0], [width, height], [0, height]] });
const markerOf = (width, shapes, pieces, more = {}) => ({
  format: "selvage-marker",
  version: 1,
  name: "boxes",
  strip: { width },
  shapes,
  pieces: pieces.map(([shape, x, y], k) => ({ id: `p${k}`, shape, at: [x, y] })),
  ...more,
});

test("gaps are filled: a small piece goes into a hole, and so does an unplaced piece", async () => {
  const shapes = [box("lying", 60, 20), box("square", 9, 9), box("post", 25, 10), box("tiny", 0.9, 9)];
  const marker = markerOf(50, shapes, [["lying", 0, 0], ["lying", 0, 30], ["post", 0, 20], ["post", 35, 20], ["square", 60, 0]], { unplaced: [{ id: "u", shape: "tiny" }] });
  marker.pieces[3].locked = true; // keeps the hole open
  const { length, unplaced, pieces } = await lengthAfter(marker, "Fill gaps", {
    wait: async (page) => {
      await page.until(`document.querySelector("#length").textContent === "60.0 mm"`);
      await page.press("Stop");
      await ended(page);
    },
  });
  assert.deepEqual({ length, unplaced, pieces }, { length: 60, unplaced: undefined, pieces: 6 });
});

// One or more copies of a layout that compaction cannot shorten: there is room for the low bars above the tall ones, but
// they cannot get there.
function bars(times) {
  const half = [["whole", 0, 0], ["tall", 20, 0], ["low", 20, 65], ["tall", 50, 0], ["tall", 80, 0], ["low", 110, 0], ["low", 110, 35], ["whole", 140, 0]];
  const pieces = Array.from({ length: times }, (_, k) => half.map(([shape, x, y]) => [shape, x + 160 * k, y])).flat();
  return markerOf(100, [box("tall", 30, 65), box("low", 30, 35), box("whole", 20, 100)], pieces);
}

test("a marker is stored in the library, and an order of such pieces takes over its arrangement", async () => {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker: { ...squares(4), name: "model" } });
  await call(daemon.port, "motion.compact", { markerId });
  const page = await visit(here.browser, daemon.port, { marker: markerId });
  const button = `[...document.querySelectorAll("#panel-engine button")].find((one) => one.textContent === "From library")`;
  assert.equal(await page.ask(`${button}.offsetParent`), null);
  await choose(page, "Store in the library");
  await page.until(`document.querySelector("#toast").textContent.includes("model is now in the library")`);
  const { markerId: order } = await call(daemon.port, "marker.open", { marker: { ...squares(4), name: "order" } });
  await choose(page, "order");
  await page.until(`selvageRoom.view().markerId === "${order}"`);
  const { lengthAfter } = await call(daemon.port, "marker.remake", { markerId: order, commit: false });
  await page.press("From library");
  await page.until(offered);
  await lengthBecomes(page, `${lengthAfter.toFixed(1)} mm`);
  await page.key("Enter");
  await atRevision(page, 2);
  await assertValid(daemon.port, order);
  // The library's own marker opens as a new one.
  await page.click("#menu");
  await page.until(`document.querySelector("#marker-menu").textContent.includes("Library: 1model")`);
  await page.ask(`[...document.querySelectorAll("#marker-menu .menu-group")].find((group) => group.textContent.startsWith("Library")).querySelector("button").click()`);
  await page.until(`selvageRoom.view().markerId === "m3"`);
  await lengthBecomes(page, "160.0 mm");
  assert.deepEqual(page.faults, []);
  await daemon.stop();
});

test("two revisions are compared as outlines, and the earlier one is taken again", () =>
  story(here, async (page, port) => {
    await page.press("Keep this revision");
    await page.until(`document.querySelector("#beside").textContent.includes("Revision 1")`);
    const [x, y] = await spot(page, "20");
    await page.drag([x, y], [x + 30, y - 20]);
    await atRevision(page, 2);
    const later = (await shown(page, port)).marker;
    await page.press("Compare", "#beside");
    await page.until("selvageRoom.view().outlined > 0", "outlines of what differs");
    await page.press("Apply", "#beside");
    await atRevision(page, 3);
    const { marker } = await shown(page, port);
    assert.notDeepEqual(marker.pieces, later.pieces);
    assert.equal(await page.text("#gain"), "0.0 mm");
  }));

test("without a pointer: arrow keys choose the direction in which a gap opens and pieces fall", async () => {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker: { ...squares(4), strip: { width: 100, longest: 400 } } });
  const page = await visit(here.browser, daemon.port, { marker: markerId });
  await page.ask(`document.querySelector("#top").focus()`);
  await page.key("a");
  await page.key("ArrowDown");
  await page.until(offered);
  await page.key("Enter");
  await atRevision(page, 2);
  const fallen = (await shown(page, daemon.port)).marker.pieces;
  assert.ok(fallen.every(({ at }) => at[1] === 0));
  await page.key("g");
  await page.key("ArrowRight");
  await page.until(offered);
  await page.key("Enter");
  await atRevision(page, 3);
  const apart = (await shown(page, daemon.port)).marker.pieces;
  assert.ok(apart[2].at[0] - apart[1].at[0] > fallen[2].at[0] - fallen[1].at[0]);
  await daemon.stop();
});

test("exact compaction of everything in view, or around the selected pieces", async () => {
  assert.equal((await lengthAfter(bars(1), "Exactly")).length, 130);
  const prepare = async (page) => {
    await page.key("0"); // all of it
    const [x, y] = await spot(page, "p2");
    await page.drag([x, y], [x, y]);
    await page.until(`selvageRoom.view().selected[0] === "p2"`);
  };
  assert.equal((await lengthAfter(bars(2), "Exactly", { prepare })).length, 290);
});

test("the price of each rule, lock and millimetre, in length and in money", async () => {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker: { ...squares(4), spacing: 3 } });
  await call(daemon.port, "motion.compact", { markerId });
  await call(daemon.port, "marker.apply", { markerId, ops: [{ op: "lock", piece: "p1", locked: true }] });
  const page = await visit(here.browser, daemon.port, { marker: markerId });
  await page.click("#tab-length");
  await page.until(`document.querySelectorAll("#prices tbody tr").length === 2`, "two prices");
  const rows = () => page.ask(`[...document.querySelectorAll("#prices tbody tr")].map((row) => [...row.children].map((cell) => cell.textContent))`);
  // Two distances lie between the locked square and the end; 8 € a metre in 60 plies.
  assert.deepEqual(await rows(), [["Spacing", "2.00 mm", "0.96 €"], ["Lock ← square", "1.00 mm", "0.48 €"]]);
  await page.press("Lock ← square", "#prices");
  assert.deepEqual((await page.ask("selvageRoom.view()")).selected, ["p1"]);
  await call(daemon.port, "marker.apply", { markerId, ops: [{ op: "lock", piece: "p1", locked: false }] });
  await page.until(`document.querySelector("#prices tbody").children.length === 1`, "no lock any more");
  assert.equal((await rows())[0][1], "3.00 mm");
  assert.deepEqual(page.faults, []);
  await daemon.stop();
});
