// To understand: figures, money, worth, free cloth, cloth's rules, stripes, ruler, overview, printing.
import assert from "node:assert/strict";
import { test } from "node:test";
import { atRevision, call, choose, example, spot, squares, startDaemon, story, visit, withBrowser } from "./visit.mjs";

const here = withBrowser();
const offered = `document.querySelector("#offer").dataset.shown === "yes"`;

/** A story on a marker of its own, without a fault of the page. */
const onMarker = (marker, act, options = {}) => async () => {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker });
  const page = await visit(here.browser, daemon.port, { marker: markerId, ...options });
  await act(page, daemon.port, markerId);
  assert.deepEqual(page.faults, []);
  await daemon.stop();
};

/** The colour of the lower canvas at a point of the cloth. */
const colourAt = (page, [u, v]) =>
  page.ask(`(() => {
    const { scale, origin: [x, y] } = selvageRoom.view();
    const canvas = document.querySelector("#base");
    const ratio = canvas.width / canvas.clientWidth;
    return [...canvas.getContext("2d").getImageData(Math.round((x + ${u} * scale) * ratio), Math.round((y - ${v} * scale) * ratio), 1, 1).data].slice(0, 3).join(" ");
  })()`);
/** What a canvas shows, once it has come to rest. */
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

test("the list of pieces is sorted by what they are worth, and says it", () =>
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

test("what a degree of tilt is worth is said of a piece that may tilt", async () => {
  const marker = example("jeans_02g");
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker });
  await call(daemon.port, "motion.compact", { markerId });
  const { tilts } = await call(daemon.port, "marker.hold", { markerId });
  const page = await visit(here.browser, daemon.port, { marker: markerId });
  const { marker: native } = await call(daemon.port, "marker.get", { markerId });
  const limits = new Map(native.shapes.map(({ id, tilt_limit: limit = 0 }) => [id, limit]));
  const tilted = tilts.find(({ piece }) => limits.get(native.pieces.find(({ id }) => id === piece).shape) > 0);
  await page.click("#tab-pieces");
  if (tilted) {
    const [x, y] = await spot(page, tilted.piece);
    await page.drag([x, y], [x, y]);
    await page.until(`document.querySelector("#panel-pieces").textContent.includes("1° more tilt")`);
  } else assert.ok([...limits.values()].every((limit) => limit === 0), "no piece of this marker may tilt");
  await daemon.stop();
});

test("free cloth is shaded, and its amount is said", onMarker(squares(2), async (page) => {
  const before = await colourAt(page, [70, 80]);
  await page.key("e");
  await page.click("#tab-length");
  await page.until(`/\\d regions?, /.test(document.querySelector("#cloth").textContent)`);
  assert.notEqual(await colourAt(page, [70, 80]), before);
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
test("selvedges, the fold, bands and shades are drawn, and a piece's rules are said", onMarker(ruled, async (page) => {
  const cloth = await colourAt(page, [120, 50]);
  assert.notEqual(await colourAt(page, [120, 6]), cloth, "the lower selvedge");
  assert.notEqual(await colourAt(page, [120, 95]), cloth, "the upper selvedge");
  await page.click("#tab-pieces");
  const told = async (piece, words) => {
    const [x, y] = await spot(page, piece);
    await page.drag([x, y], [x, y]);
    await page.until(`document.querySelector("#panel-pieces .facts").textContent.includes(${JSON.stringify(words)})`, words);
  };
  const before = await shows(page, "#top");
  await told("folded", "On the fold");
  await told("banded", "From 50.0 mm · Up to 130.0 mm");
  assert.notEqual(await shows(page, "#top"), before, "the room that its rules leave");
  await told("one", "Shade A");
}));

test("a piece outside of its room makes the marker not valid, and is marked", onMarker({ ...squares(2), strip: { width: 100, below: 12 } }, async (page) => {
  await page.until(`document.querySelector("#length + .figure-side").textContent === "not valid"`);
}));

test("stripes, plaid and the middle of the cloth are drawn over it", onMarker(squares(2), async (page) => {
  const plain = await shows(page, "#base");
  await inSettings(page, () => set(page, "Stripe repeat along", "25"));
  const striped = await shows(page, "#base");
  assert.notEqual(striped, plain);
  await inSettings(page, () => set(page, "Stripe repeat across", "20"));
  const plaid = await shows(page, "#base");
  assert.notEqual(plaid, striped);
  await inSettings(page, async () => {
    await page.ask(`[...document.querySelectorAll("label")].find((label) => label.textContent.startsWith("Fold line")).querySelector("input").click()`);
  });
  assert.notEqual(await shows(page, "#base"), plaid);
}));

const bundled = { ...squares(3), pieces: squares(3).pieces.map((piece, k) => ({ ...piece, attributes: { bundle: k < 2 ? "M-A" : "M-B" } })) };
test("pieces are coloured by bundle, and a legend says which is which", onMarker(bundled, async (page) => {
  await inSettings(page, () => set(page, "Colour pieces by", "bundle"));
  await page.until(`document.querySelector("#legend").textContent === "M-AM-B"`);
  const fills = await Promise.all([10, 60, 110].map((x) => colourAt(page, [x, 25])));
  assert.equal(fills[0], fills[1]);
  assert.notEqual(fills[1], fills[2]);
}));

test("the ruler measures, Escape takes it away", onMarker(squares(2), async (page) => {
  const before = await shows(page, "#top");
  await page.key("m");
  await page.drag([500, 300], [640, 340]);
  assert.notEqual(await shows(page, "#top"), before);
  await page.key("Escape");
  await page.key("Escape");
  assert.equal(await page.ask(`document.querySelector("#top").dataset.tool`), "select");
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

test("printing gives the printer the daemon's drawing of the marker", () =>
  story(here, async (page) => {
    await page.ask(`void (globalThis.print = () => { const picture = document.querySelector("#print"); globalThis.printed = [picture.naturalWidth, picture.alt]; })`);
    await choose(page, "Print");
    const [width, name] = await page.until("globalThis.printed");
    assert.ok(width > 0);
    assert.equal(name, "jeans_02g");
    assert.equal(await page.ask(`document.querySelector("#print")`), null);
  }));
