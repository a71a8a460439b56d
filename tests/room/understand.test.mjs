// Figures, money, prices, free cloth, cloth's rules, stripes, ruler, overview and printing.
import assert from "node:assert/strict";
import { test } from "node:test";
import { atRevision, call, choose, example, revision, spot, squares, startDaemon, story, visit, withBrowser } from "./visit.mjs";

const here = withBrowser();
const offered = `document.querySelector("#offer").dataset.shown === "yes"`;

/** Runs a test on a marker of its own; the page must report no error. */
const onMarker = (marker, act, options = {}) => async () => {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker });
  const page = await visit(here.browser, daemon.port, { marker: markerId, ...options });
  await act(page, daemon.port, markerId);
  assert.deepEqual(page.faults, []);
  await daemon.stop();
};

/** The colour of the lower canvas at a point of the cloth, after everything has been drawn. */
const colourAt = (page, [u, v]) =>
  page.ask(`(async () => {
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    const { scale, origin: [x, y] } = selvageRoom.view();
    const canvas = document.querySelector("#base");
    const ratio = canvas.width / canvas.clientWidth;
    return [...canvas.getContext("2d").getImageData(Math.round((x + ${u} * scale) * ratio), Math.round((y - ${v} * scale) * ratio), 1, 1).data].slice(0, 3).join(" ");
  })()`);
/** The content of a canvas after all animations. */
const shows = (page, canvas) => page.ask(`new Promise((resolve) => setTimeout(() => resolve(document.querySelector("${canvas}").toDataURL()), 400))`);
const set = (page, text, value) =>
  page.ask(`(() => {
    const select = [...document.querySelectorAll("label")].find((label) => label.textContent.startsWith("${text}")).querySelector("select, input");
    select.value = ${JSON.stringify(value)};
    select.dispatchEvent(new Event("change"));
  })()`);
const inSettings = async (page, act) => {
  await page.press("Settings");
  await act();
  await page.press("Done", "dialog");
};

test("length, utilisation, and the gain since opening in millimetres and in money", onMarker(squares(4), async (page) => {
  assert.equal(await page.text("#length"), "190.0 mm");
  assert.equal(await page.text("#gain"), "0.0 mm");
  await page.key("c");
  await page.until(offered);
  await page.key("Enter");
  await atRevision(page, 2);
  await page.until(`document.querySelector("#gain").textContent === "−30.0 mm"`);
  assert.equal(await page.text("#utilisation"), "40.00 %");
  assert.equal(await page.text("#gain + .figure-side"), "14.40 € in 60 plies"); // 0.03 m at 8 € a metre
  await page.click("#tab-length");
  await set(page, "Price per metre", "12,50");
  await set(page, "Plies", "10");
  await page.until(`document.querySelector("#gain + .figure-side").textContent === "3.75 € in 10 plies"`);
  assert.match(await page.text("#money"), /per ply2\.00 €/);
}));

test("the list of pieces is sorted by price and shows it", () =>
  story(here, async (page) => {
    await page.key("c");
    await page.until(offered);
    await page.key("Enter");
    await atRevision(page, 2);
    await page.click("#tab-pieces");
    await set(page, "Sort by", "worth");
    const column = `[...document.querySelectorAll("#pieces .option-detail")].map((cell) => Number(cell.textContent))`;
    await page.until(`${column}[0] > 0`, "a piece that is worth something");
    const worths = await page.ask(column);
    assert.deepEqual(worths, worths.toSorted((a, b) => b - a));
    await set(page, "Sort by", "area");
    await page.until(`document.querySelector("#pieces .option-detail").textContent.includes("cm²")`);
  }));

test("the price of a degree of tilt is shown for a piece that may tilt", async () => {
  const marker = example("jeans_02g");
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker });
  await call(daemon.port, "motion.compact", { markerId });
  const { tilts } = await call(daemon.port, "marker.hold", { markerId });
  const page = await visit(here.browser, daemon.port, { marker: markerId });
  const { marker: native } = await call(daemon.port, "marker.get", { markerId });
  const limits = new Map(native.shapes.map(({ id, tilt_limit: limit = 0 }) => [id, limit]));
  const tilted = tilts.find(({ piece }) => limits.get(native.pieces.find(({ id }) => id === piece).shape) > 0);
  if (tilted) {
    const [x, y] = await spot(page, tilted.piece);
    await page.drag([x, y], [x, y]);
    // On the piece, whatever else is shown: a dark flag below its name.
    await page.until(`(() => {
      const canvas = document.querySelector("#top");
      const { left, top } = canvas.getBoundingClientRect();
      const at = canvas.getContext("2d").getImageData(${Math.round(x)} - left - 30, ${Math.round(y)} - top + 16, 1, 1).data;
      return at[0] < 60 && at[1] < 60 && at[2] < 60 && at[3] === 255;
    })()`, "the flag");
    await page.click("#tab-pieces");
    await page.until(`document.querySelector("#panel-pieces").textContent.includes("1° more tilt")`);
  } else assert.ok([...limits.values()].every((limit) => limit === 0), "no piece of this marker may tilt");
  await daemon.stop();
});

test("free cloth is shaded, and its amount is shown", onMarker(squares(2), async (page) => {
  const before = await colourAt(page, [70, 80]);
  await page.key("e");
  await page.click("#tab-length");
  await page.until(`/\\d regions?, /.test(document.querySelector("#cloth").textContent)`);
  const shaded = await colourAt(page, [70, 80]);
  assert.notEqual(shaded, before);
}));

// Walls 30 wide, and a square of 40 beyond them. Between walls that begin at 0, 50 and 125 it fits into the second gap only, although the first has the area for it.
const walls = (...begins) => ({
  ...squares(1),
  shapes: [...squares(1).shapes, { id: "wall", outline: [[0, 0], [30, 0], [30, 100], [0, 100]] }],
  pieces: [{ id: "s", shape: "square", at: [185, 30] }, ...begins.map((x, k) => ({ id: `w${k}`, shape: "wall", at: [x, 0] }))],
});
test("free cloth is darker where the smallest piece fits, and the page says where it does", onMarker(walls(0, 50, 125), async (page, port) => {
  await page.key("e");
  await page.click("#tab-length");
  await page.until(`document.querySelector("#cloth").textContent.includes("square, the smallest piece, fits into 1 of them")`, "what fits");
  assert.notEqual(await colourAt(page, [40, 50]), await colourAt(page, [102, 50]));
  // Another marker, at the same revision: its free cloth is asked for, too.
  const { markerId: next } = await call(port, "marker.open", { marker: walls(0, 75, 150) });
  await choose(page, next);
  await page.until(`document.querySelector("#cloth").textContent.includes("fits into 2 of them")`, "what fits in the other marker");
  // Hidden during the search and shown again, it is complete.
  await page.key("e");
  await page.key("e");
  await page.until(`document.querySelector("#cloth").textContent.includes("fits into 2 of them")`, "what fits, again");
}));

const ruled = {
  ...squares(4),
  strip: { width: 100, below: 12, above: 8 },
  shade: 120,
  pieces: [
    { id: "folded", shape: "square", at: [0, 0], rules: { fold: true } },
    { id: "banded", shape: "square", at: [60, 20], rules: { from: 50, to: 130 } },
    { id: "one", shape: "square", at: [140, 20], rules: { shade: "A" } },
    { id: "two", shape: "square", at: [190, 20], rules: { shade: "A" } },
  ],
};
test("selvedges, the fold, bands and shades are drawn, and a piece's rules are listed", onMarker(ruled, async (page) => {
  const cloth = await colourAt(page, [120, 50]);
  assert.notEqual(await colourAt(page, [120, 6]), cloth, "the lower selvedge");
  assert.notEqual(await colourAt(page, [120, 95]), cloth, "the upper selvedge");
  await page.click("#tab-pieces");
  const listsRules = async (piece, words) => {
    const [x, y] = await spot(page, piece);
    await page.drag([x, y], [x, y]);
    await page.until(`document.querySelector("#piece-rules summary").textContent.includes(${JSON.stringify(words)})`, words);
  };
  const before = await shows(page, "#top");
  await listsRules("folded", "On the fold");
  await listsRules("banded", "From 50.0 mm · Up to 130.0 mm");
  assert.notEqual(await shows(page, "#top"), before, "the room that its rules leave");
  await listsRules("one", "Shade A");
}));

test("a piece outside of its room makes the marker invalid and is marked", onMarker({ ...squares(2), strip: { width: 100, below: 12 } }, async (page) => {
  await page.until(`document.querySelector("#length + .figure-side").textContent === "not valid"`);
}));

test("stripes, plaid and the middle of the cloth are drawn, and the pattern is the marker's", onMarker(squares(2), async (page, port, markerId) => {
  const plain = await shows(page, "#base");
  await page.click("#tab-pieces");
  await page.click("#cloth-rules summary");
  await page.enter("#cloth-along", "25");
  await atRevision(page, 2);
  const striped = await shows(page, "#base");
  assert.notEqual(striped, plain);
  await page.enter("#cloth-across", "20");
  await atRevision(page, 3);
  const plaid = await shows(page, "#base");
  assert.notEqual(plaid, striped);
  assert.match(await page.text("#cloth-rules summary"), /plaid, 25.0 × 20.0 mm/);
  await page.enter("#cloth-phase-across", "7");
  await atRevision(page, 4);
  assert.notEqual(await shows(page, "#base"), plaid);
  const repeat = async () => (await call(port, "marker.get", { markerId })).marker.strip.repeat;
  assert.deepEqual(await repeat(), { along: 25, across: 20, phase: [0, 7] });
  await page.enter("#cloth-along", "");
  await page.enter("#cloth-across", "");
  await atRevision(page, 6);
  assert.equal(await repeat(), undefined);
  const before = await shows(page, "#base");
  await inSettings(page, async () => {
    await page.ask(`[...document.querySelectorAll("label")].find((label) => label.textContent.startsWith("Line in the middle")).querySelector("input").click()`);
  });
  assert.notEqual(await shows(page, "#base"), before);
}));

test("selvedges and a piece's own rules are entered in fields; pieces moved by a rule are one step to undo", onMarker(squares(3), async (page, port, markerId) => {
  const marker = async () => (await call(port, "marker.get", { markerId })).marker;
  const rulesOf = async (id) => (await marker()).pieces.find((piece) => piece.id === id).rules ?? {};
  const pick = async (id) => {
    const [x, y] = await spot(page, id);
    await page.drag([x, y], [x, y]);
  };
  await page.click("#tab-pieces");
  await page.click("#cloth-rules summary");
  await page.enter("#cloth-below", "15"); // the first two lie at 0 and 10, and move
  await page.until("selvageRoom.revision() >= 3", "put into their room");
  assert.equal((await marker()).strip.below, 15);
  assert.ok((await marker()).pieces.every(({ at }) => at[1] >= 15));
  await page.press("Undo");
  await page.until(`document.querySelector("#cloth-below").value === ""`, "one undo");
  assert.deepEqual((await marker()).pieces.map(({ at }) => at[1]), [0, 10, 20]);

  await pick("p1");
  await page.click("#piece-rules summary");
  await page.until(`document.querySelector("#piece-rules summary").textContent.includes("anywhere")`);
  const since = await revision(page);
  await page.enter("#rule-from", "30");
  await page.enter("#rule-to", "200");
  await page.enter("#rule-shade", "M-A");
  await atRevision(page, since + 3);
  assert.deepEqual(await rulesOf("p1"), { from: 30, to: 200, shade: "M-A" });
  assert.match(await page.text("#piece-rules summary"), /From 30.0 mm · Up to 200.0 mm · Shade M-A/);
  await page.enter("#rule-from", "");
  await atRevision(page, since + 4); // the summary is shorter then, and the fields below it move up
  await page.click("#rule-fold");
  await page.until(`document.querySelector("#rule-fold").checked && selvageRoom.revision() >= ${since} + 6`, "put onto the fold");
  assert.deepEqual(await rulesOf("p1"), { to: 200, shade: "M-A", fold: true });
  assert.equal((await marker()).pieces.find(({ id }) => id === "p1").at[1], 0);
  // A field shows why it refuses a value, and nothing changes.
  const now = await revision(page);
  await page.enter("#rule-above", "wide");
  assert.equal(await page.ask(`document.querySelector("#rule-above").validationMessage`), "A length in mm, 0 or more.");
  assert.equal(await revision(page), now);
}));

test("a piece is matched to the pattern where it lies, and its match point can be entered", onMarker({ ...squares(3), strip: { width: 100, repeat: { along: 25, across: 20 } } }, async (page, port, markerId) => {
  const matched = async () => (await call(port, "marker.get", { markerId })).marker.pieces.find(({ id }) => id === "p1");
  await page.click("#tab-pieces");
  const [x, y] = await spot(page, "p1");
  await page.drag([x, y], [x, y]);
  await page.click("#piece-rules summary");
  await page.click("#rule-match");
  await atRevision(page, 2);
  const { at, rules } = await matched();
  assert.deepEqual([(at[0] + rules.match[0]) % 25, (at[1] + rules.match[1]) % 20], [0, 0]);
  assert.equal((await call(port, "marker.check", { markerId })).valid, true);
  // Another point of it: the piece moves to where that one lies on the pattern.
  await page.enter("#rule-point-along", "5");
  await page.until("selvageRoom.revision() >= 4", "moved");
  const moved = await matched();
  assert.equal(moved.rules.match[0], 5);
  assert.equal((moved.at[0] + 5) % 25, 0);
  await page.click("#rule-match");
  await page.until(`document.querySelector("#rule-point-along").closest(".row").hidden`);
  assert.deepEqual((await matched()).rules ?? {}, {});
}));

// A stain under the second square, whose right half is seen.
const stained = {
  ...squares(2),
  pieces: [...squares(2).pieces, { id: "stain", shape: "square", at: [20, 60], rules: { zone: true, quality: 2 } }],
};
stained.pieces[1] = { ...stained.pieces[1], at: [50, 50] };
test("the quality of cloth that a piece accepts is entered, and the part of it that accepts less is drawn", onMarker(stained, async (page, port, markerId) => {
  const validity = (said) => page.until(`(document.querySelector("#length + .figure-side").textContent === "not valid") === ${!said}`, said ? "valid" : "not valid");
  const rulesOf = async () => (await call(port, "marker.get", { markerId })).marker.pieces.find(({ id }) => id === "p1").rules ?? {};
  await validity(false);
  await page.click("#tab-pieces");
  const [x, y] = await spot(page, "p1");
  await page.drag([x, y], [x, y]);
  await page.click("#piece-rules summary");
  await page.enter("#rule-quality", "2");
  await atRevision(page, 2);
  assert.deepEqual(await rulesOf(), { quality: 2 });
  await validity(true);
  assert.match(await page.text("#piece-rules summary"), /Cloth down to quality 2/);
  const whole = await shows(page, "#base");
  const part = { outline: [[20, 0], [40, 0], [40, 40], [20, 40]], quality: 1 };
  await call(port, "marker.apply", { markerId, ops: [{ op: "rules", piece: "p1", rules: { quality: 2, part } }] });
  await page.until(`document.querySelector("#piece-rules summary").textContent.includes("A part of it down to 1")`, "the part");
  assert.notEqual(await shows(page, "#base"), whole);
  await validity(true); // the stain lies under the other half
  // Another rule leaves the part as it is.
  const now = await revision(page);
  await page.enter("#rule-shade", "M-A");
  await atRevision(page, now + 1);
  assert.deepEqual(await rulesOf(), { shade: "M-A", quality: 2, part });
  assert.equal((await call(port, "marker.check", { markerId })).valid, true);
}));

const bundled = { ...squares(3), pieces: squares(3).pieces.map((piece, k) => ({ ...piece, attributes: { bundle: k < 2 ? "M-A" : "M-B" } })) };
test("pieces are coloured by bundle, with a legend", onMarker(bundled, async (page) => {
  await inSettings(page, () => set(page, "Colour pieces by", "bundle"));
  await page.until(`document.querySelector("#legend").textContent === "M-AM-B"`);
  const fills = await Promise.all([10, 60, 110].map((x) => colourAt(page, [x, 25])));
  assert.equal(fills[0], fills[1]);
  assert.notEqual(fills[1], fills[2]);
}));

test("the ruler measures, and Escape removes it", onMarker(squares(2), async (page) => {
  const before = await shows(page, "#top");
  await page.key("m");
  await page.drag([500, 300], [640, 340]);
  assert.notEqual(await shows(page, "#top"), before);
  await page.key("Escape");
  await page.key("Escape");
  assert.equal(await page.ask(`document.querySelector("#top").dataset.tool`), "select");
  // By keys: along and across the selected piece.
  const [x, y] = await spot(page, "p1");
  await page.drag([x, y], [x, y]);
  await page.key("m");
  await page.key("ArrowRight");
  await page.until(`document.querySelector("#toast").textContent === "Measured: 40.0 mm."`);
  assert.notEqual(await shows(page, "#top"), before);
}));

test("a long marker has an overview, and a drag on it pans", onMarker(squares(60), async (page) => {
  assert.ok(await page.ask(`document.querySelector("#overview").offsetParent !== null`));
  await page.key("0");
  if ((await page.ask("selvageRoom.view().scale")) < 2) await page.key("0");
  const before = (await page.ask("selvageRoom.view().origin"))[0];
  const [x, y, width] = await page.ask(`(({ x, y, width, height }) => [x, y + height / 2, width])(document.querySelector("#overview").getBoundingClientRect())`);
  await page.drag([x + width * 0.2, y], [x + width * 0.8, y]);
  assert.ok((await page.ask("selvageRoom.view().origin"))[0] < before - 100);
}));

test("printing uses the daemon's drawing of the marker", () =>
  story(here, async (page) => {
    await page.ask(`void (globalThis.print = () => { const picture = document.querySelector("#print"); globalThis.printed = [picture.naturalWidth, picture.alt]; })`);
    await choose(page, "Print");
    const [width, name] = await page.until("globalThis.printed");
    assert.ok(width > 0);
    assert.equal(name, "jeans_02g");
    assert.equal(await page.ask(`document.querySelector("#print")`), null);
  }));
