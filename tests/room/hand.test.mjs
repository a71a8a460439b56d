// Editing by hand: dragging, bumping, rotating, selecting, locking.  Every change ends with a valid marker, and one
// undo reverts it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertValid, atRevision, call, revision, shown, spot, squares, startDaemon, story, visit, withBrowser } from "./visit.mjs";

const here = withBrowser();
const placed = (marker, id) => marker.pieces.find((piece) => piece.id === id).at;

/** A story on squares in a row: 40 wide, 10 apart. */
const onSquares = (count, act, change = {}) => async () => {
  const daemon = await startDaemon();
  const marker = { ...squares(count), ...change };
  const { markerId } = await call(daemon.port, "marker.open", { marker });
  const page = await visit(here.browser, daemon.port, { marker: markerId });
  if (count > 4) await page.key("0"); // all of a long marker
  await act(page, daemon.port, markerId);
  await assertValid(daemon.port, markerId);
  assert.deepEqual(page.faults, []);
  await daemon.stop();
};

test("a drag pushes its neighbours aside", onSquares(6, async (page, port, markerId) => {
  const [x, y] = await spot(page, "p1");
  const scale = (await page.ask("selvageRoom.view()")).scale;
  await page.drag([x, y], [x + 40 * scale, y], { hold: true, steps: 20 });
  await page.until("selvageRoom.view().shown > 1", "a neighbour that makes way before the hand lets go");
  assert.equal((await call(port, "marker.get", { markerId })).revision, 1);
  await page.mouse("mouseReleased", x + 40 * scale, y);
  await atRevision(page, 2);
  const { marker } = await shown(page, port);
  assert.ok(placed(marker, "p1")[0] > 61, "farther than it could go alone");
  assert.ok(placed(marker, "p2")[0] > 101);
}));

test("the other kind of drag moves no other piece, and slides along its neighbours", onSquares(6, async (page, port, markerId) => {
  await page.key("p");
  const before = (await shown(page, port)).marker;
  const [x, y] = await spot(page, "p1");
  const scale = (await page.ask("selvageRoom.view()")).scale;
  await page.drag([x, y], [x + 40 * scale, y], { steps: 20 });
  await atRevision(page, 2);
  const { marker } = await shown(page, port);
  for (const { id, at } of before.pieces) if (id !== "p1") assert.deepEqual(placed(marker, id), at);
  assert.notDeepEqual(placed(marker, "p1"), placed(before, "p1"));
}));

test("Escape ends a drag and puts everything back", onSquares(6, async (page, port, markerId) => {
  const [x, y] = await spot(page, "p1");
  await page.drag([x, y], [x + 120, y], { hold: true });
  await page.key("Escape");
  await page.until("selvageRoom.view().shown === 0");
  await page.mouse("mouseReleased", x + 120, y);
  assert.equal((await call(port, "marker.get", { markerId })).revision, 1);
}));

test("with Shift a piece can be moved anywhere; overlaps are then separated, and one undo reverts all of it", onSquares(6, async (page, port) => {
  const before = (await shown(page, port)).marker;
  const [x, y] = await spot(page, "p4");
  const [toX, toY] = await spot(page, "p1");
  await page.drag([x, y], [toX + 6, toY + 3], { modifiers: 8 });
  await atRevision(page, 3);
  const { marker } = await shown(page, port);
  assert.ok(placed(marker, "p4")[0] < 120);
  await page.key("z", "control");
  await atRevision(page, 5);
  assert.deepEqual((await shown(page, port)).marker.pieces.map(({ at }) => at), before.pieces.map(({ at }) => at));
  await page.key("y", "control");
  await atRevision(page, 7);
  assert.deepEqual((await shown(page, port)).marker.pieces.map(({ at }) => at), marker.pieces.map(({ at }) => at));
}));

test("arrow keys bump, Home shoots to the corner, Shift nudges", onSquares(4, async (page, port) => {
  await page.ask(`document.querySelector("#top").focus()`);
  await page.click("#top");
  await page.drag(await spot(page, "p3"), await spot(page, "p3"));
  await page.key("ArrowLeft");
  await atRevision(page, 2);
  const bumped = (await shown(page, port)).marker;
  assert.ok(placed(bumped, "p3")[0] < 150);
  await page.key("Home");
  await atRevision(page, 3);
  const [, y] = placed((await shown(page, port)).marker, "p3");
  assert.equal(y, 60);
  const now = await revision(page);
  await page.key("ArrowRight", "shift");
  await atRevision(page, now + 1);
}));

test("rotate, flip and tilt within what the shape allows", async () => {
  const daemon = await startDaemon();
  const marker = squares(3);
  Object.assign(marker.shapes[0], { rotations: [0, 90, 180, 270], flip: true, tilt_limit: 2 });
  marker.pieces.forEach((piece, k) => (piece.at = [100 * k, 20]));
  const { markerId } = await call(daemon.port, "marker.open", { marker });
  const page = await visit(here.browser, daemon.port, { marker: markerId });
  const [x, y] = await spot(page, "p1");
  await page.drag([x, y], [x, y]);
  const piece = async () => (await shown(page, daemon.port)).marker.pieces.find(({ id }) => id === "p1");
  await page.key("r");
  await atRevision(page, 2);
  assert.equal((await piece()).rotation, 90);
  await page.key("f");
  await atRevision(page, 3);
  assert.equal((await piece()).flip, true);
  await page.wheel(x, y, -100, 1);
  await atRevision(page, 4);
  assert.equal((await piece()).tilt, 0.25);
  for (let k = 0; k < 20; ++k) await page.key("[");
  await page.until(`document.querySelector("#toast") && selvageRoom.revision() > 4`);
  for (let last = 0; last !== (await revision(page)); ) {
    last = await revision(page);
    await new Promise((resolve) => setTimeout(resolve, 400));
  }
  assert.ok((await piece()).tilt <= 2);
  // The middle of the piece has stayed where it was.
  const [u, v] = await spot(page, "p1");
  assert.ok(Math.hypot(u - x, v - y) < 3);
  await daemon.stop();
});

test("a rubber band selects pieces, which are then moved, grouped and locked together", onSquares(6, async (page, port) => {
  const [ax, ay] = await spot(page, "p0");
  const [bx, by] = await spot(page, "p2");
  const scale = (await page.ask("selvageRoom.view()")).scale;
  await page.drag([ax - 22 * scale, Math.max(ay, by) + 24 * scale], [bx + 22 * scale, Math.min(ay, by) - 35 * scale]);
  await page.until("selvageRoom.view().selected.length === 3");
  await page.key("u");
  await atRevision(page, 2);
  assert.equal(new Set((await shown(page, port)).marker.pieces.slice(0, 3).map(({ group }) => group)).size, 1);
  await page.key("l");
  await atRevision(page, 3);
  assert.ok((await shown(page, port)).marker.pieces.slice(0, 3).every(({ locked }) => locked === true));
  const now = await revision(page);
  await page.drag([ax, ay], [ax + 60, ay]);
  await page.until(`document.querySelector("#toast").textContent.includes("locked")`);
  assert.equal(await revision(page), now);
}));

test("wheel zooms at the pointer, right button pans, 0 fits", (t) =>
  story(here, async (page) => {
    const [x, y] = await spot(page, "20");
    await page.wheel(x, y, -300);
    await page.until("selvageRoom.view().scale > 0.5");
    const [u, v] = await spot(page, "20");
    assert.ok(Math.hypot(u - x, v - y) < 1, "what is under the pointer stays there");
    await page.drag([x, y], [x - 100, y + 40], { button: "right" });
    const [p, q] = await spot(page, "20");
    assert.ok(Math.abs(p - u + 100) < 2 && Math.abs(q - v - 40) < 2);
    await page.key("0");
    const [s, w] = await spot(page, "20");
    assert.ok(Math.hypot(s - x, w - y) < 1);
  }));

const centre = (page, selector) => page.ask(`(() => { const r = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()`);

test("unplaced pieces are in the tray: one is dragged onto the cloth, one pressed, and the counts decrease", onSquares(2, async (page, port, markerId) => {
  await page.until(`document.querySelector("#tray")?.textContent.includes("× 3")`, "the tray");
  const from = await centre(page, ".tray-row");
  const canvas = await centre(page, "#top");
  await page.drag(from, canvas, { hold: true });
  assert.equal(await revision(page), 1);
  await page.mouse("mouseReleased", ...canvas);
  await page.until(`document.querySelector("#tray")?.textContent.includes("× 2")`, "a piece less in the tray");
  await page.click(".tray-row");
  await page.until(`document.querySelector("#tray")?.textContent.includes("× 1")`, "another piece less");
  const { marker } = await shown(page, port);
  assert.equal(marker.pieces.length, 4);
  assert.equal(marker.unplaced.length, 1);
  await assertValid(port, markerId);
  await page.key("z", "control");
  await page.until(`document.querySelector("#tray")?.textContent.includes("× 2")`, "one undo takes back one piece");
  assert.equal((await shown(page, port)).marker.pieces.length, 3);
}, { unplaced: ["u1", "u2", "u3"].map((id) => ({ id, shape: "square" })) }));

test("Delete takes the selected piece off the cloth", onSquares(2, async (page, port) => {
  assert.ok(await page.ask(`document.querySelector("#tray").hidden`));
  const [x, y] = await spot(page, "p1");
  await page.drag([x, y], [x, y]);
  await page.key("Delete");
  await page.until(`document.querySelector("#tray")?.textContent.includes("× 1")`, "the piece in the tray");
  const { marker } = await shown(page, port);
  assert.deepEqual(marker.unplaced.map(({ id }) => id), ["p1"]);
  await page.key("z", "control");
  await page.until(`document.querySelector("#tray").hidden`, "undone");
}));

// Two walls with a gap of 60 between them, and squares of 40 that wait.
const gaps = {
  shapes: [{ id: "square", outline: [[0, 0], [40, 0], [40, 40], [0, 40]] }, { id: "wall", outline: [[0, 0], [30, 0], [30, 100], [0, 100]] }],
  pieces: [0, 90, 165, 245].map((x, k) => ({ id: `w${k}`, shape: "wall", at: [x, 0] })),
  unplaced: ["u1", "u2"].map((id) => ({ id, shape: "square" })),
};

test("all places where an unplaced piece fits are shown; one is clicked, one chosen by keys", onSquares(1, async (page, port, markerId) => {
  await page.key("0"); // all of it
  const ready = `document.querySelector("#places").textContent.startsWith("Places where it fits")`;
  const fits = () => page.press("Show where");
  await fits();
  await page.until(ready, "places");
  // The gaps of 60 and of 50 have room, that of 45 too; each has one place or more.
  const places = await page.ask("selvageRoom.places()");
  assert.ok(places.length >= 3, JSON.stringify(places));
  assert.equal(await revision(page), 1);
  const last = places.at(-1);
  await page.mouse("mouseMoved", last.x, last.y, { button: "none", buttons: 0 });
  await page.drag([last.x, last.y], [last.x, last.y]);
  await atRevision(page, 2);
  const at = placed((await shown(page, port)).marker, "u1");
  assert.deepEqual(at, last.at);
  await assertValid(port, markerId);
  // The places of the next piece of this shape are shown now.
  await page.until(ready, "places of the next piece");
  await page.key("ArrowRight");
  const chosen = (await page.ask("selvageRoom.places()")).find(({ chosen }) => chosen);
  await page.key("Enter");
  await page.until(`document.querySelector("#tray").hidden`, "an empty tray");
  assert.deepEqual(placed((await shown(page, port)).marker, "u2"), chosen.at);
  assert.deepEqual(await page.ask("selvageRoom.places()"), []);
}, gaps));

test("the page says when a piece fits nowhere; Escape ends the search", onSquares(1, async (page) => {
  await page.press("Show where");
  await page.until(`document.querySelector("#places").textContent.startsWith("It fits nowhere")`);
  await page.key("Escape");
  await page.until(`document.querySelector("#places").textContent === ""`);
}, { ...gaps, pieces: gaps.pieces.slice(0, 1) }));

test("pieces may overlap by what the marker, or the piece itself, allows; both are kept in the document", onSquares(4, async (page, port, markerId) => {
  await page.click("#tab-pieces");
  await page.enter("#overlap", "3");
  await atRevision(page, 2);
  assert.equal((await shown(page, port)).marker.overlap, 3);
  const [x, y] = await spot(page, "p1");
  await page.drag([x, y], [x, y]);
  assert.equal(await page.ask(`document.querySelector("#piece-overlap").placeholder`), "3.0");
  await page.enter("#piece-overlap", "1.5");
  await atRevision(page, 3);
  const own = () => shown(page, port).then(({ marker }) => marker.pieces.find(({ id }) => id === "p1").overlap);
  assert.equal(await own(), 1.5);
  // Pushed together they overlap by that much; without the allowance the page separates them again.
  await call(port, "motion.compact", { markerId });
  await atRevision(page, 4);
  const before = (await call(port, "marker.list")).markers[0].length;
  assert.ok(before < 160);
  await page.enter("#overlap", "0");
  await page.until(`document.querySelector("#overlap").value === "0.0"`);
  await page.until("selvageRoom.revision() >= 6", "separated");
  assert.ok((await call(port, "marker.list")).markers[0].length > before);
}));
