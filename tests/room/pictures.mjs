// Writes the pictures of docs/marker-room.md: pictures.mjs FOLDER [NAMES], with FOLDER docs/pictures/room and the names separated by
// commas. Each picture shows the page in a state that a user reaches. The picture of the page opened from disk needs the environment
// variable ROOM_FILE (what `./dev room-file` builds), and is skipped without it.
import { mkdirSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";
import { atRevision, call, example, spot, startDaemon, visit } from "./visit.mjs";

const folder = process.argv[2];
for (const group of ["appearance", "editing", "results"]) mkdirSync(`${folder}/${group}`, { recursive: true });
const size = { width: 1280, height: 760 };
const browser = await Browser.launch();
const rest = (milliseconds = 450) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const offered = `document.querySelector("#offer").dataset.shown === "yes"`;

/** The marker without a layout: all its pieces are unplaced. */
const withoutSolution = ({ solution: _, ...instance }) => instance;

/** Opens a marker on a new daemon, brings the page to a state with `act`, and writes the picture to FOLDER/`name`.png. */
async function state(name, act, { marker = "jeans_02g", unplaced = false, ...options } = {}) {
  const daemon = await startDaemon();
  const document = typeof marker === "string" ? example(marker) : marker;
  const { markerId } = await call(daemon.port, "marker.open", { marker: unplaced ? withoutSolution(document) : document });
  const page = await visit(browser, daemon.port, { ...size, marker: markerId, ...options });
  await act(page, daemon.port, markerId);
  await page.ask(`document.querySelector("#toast").dataset.shown = ""`); // hide messages shown on the way to this state
  await rest();
  writeFileSync(`${folder}/${name}.png`, await page.picture());
  await daemon.stop();
}

/** A marker with selvedges, pieces on the fold, a band, and a shade. */
const ruled = {
  format: "selvage-marker",
  version: 1,
  name: "cloth's rules",
  strip: { width: 800, below: 15, above: 25 },
  shade: 1100,
  shapes: [
    { id: "front", outline: [[0, 0], [600, 0], [600, 240], [420, 300], [0, 300]] },
    { id: "sleeve", outline: [[0, 60], [120, 0], [420, 20], [500, 160], [420, 300], [120, 320], [0, 260]] },
    { id: "facing", outline: [[0, 0], [300, 0], [300, 70], [0, 90]] },
  ],
  pieces: [
    { id: "M-A front", shape: "front", at: [0, 0], rules: { fold: true, shade: "M-A" } },
    { id: "M-B front", shape: "front", at: [620, 0], rules: { fold: true, shade: "M-B" } },
    { id: "M-A sleeve", shape: "sleeve", at: [10, 330], rules: { shade: "M-A" } },
    { id: "banded", shape: "sleeve", at: [560, 340], rules: { from: 500, to: 1300 } },
    { id: "M-B sleeve", shape: "sleeve", at: [1190, 330], rules: { shade: "M-B" } },
    { id: "M-B facing", shape: "facing", at: [1240, 120], rules: { below: 0, shade: "M-B" } },
  ],
};

/** A plaid, two panels that are matched to it, and a pocket that is not yet. */
const plaid = {
  format: "selvage-marker",
  version: 1,
  name: "plaid",
  strip: { width: 760, below: 15, above: 15, repeat: { along: 90, across: 75, phase: [10, 20] } },
  shapes: [
    { id: "panel", outline: [[0, 0], [600, 0], [600, 240], [420, 300], [0, 300]] },
    { id: "pocket", outline: [[0, 0], [150, 0], [150, 160], [75, 190], [0, 160]] },
  ],
  pieces: [
    { id: "left", shape: "panel", at: [10, 20], rules: { match: [90, 75] } },
    { id: "right", shape: "panel", at: [10, 395], rules: { match: [90, 75] } },
    { id: "pocket", shape: "pocket", at: [655, 110] },
  ],
};

const compacted = async (page) => {
  await page.key("c");
  await page.until(offered);
  await page.key("Enter");
  await atRevision(page, 2);
};
const pick = async (page, piece) => {
  const [x, y] = await spot(page, piece);
  await page.drag([x, y], [x, y]);
};

const states = {
  opened: () => state("appearance/opened", () => {}),
  push: () => state("editing/push", async (page) => {
    await page.drag([818, 372], [850, 362], { hold: true, steps: 30 });
    await page.until("selvageRoom.view().shown > 1");
  }),
  free: () => state("editing/free", async (page) => {
    const [x, y] = await spot(page, "20");
    await page.drag([x, y], [x - 40, y - 45], { hold: true, modifiers: 8 });
  }),
  result: () => state("results/result", async (page) => {
    await page.key("c");
    await page.until(offered);
    await page.key("0"); // all of it
  }, { marker: "jeans_06g" }),
  fine: () => state("results/fine", async (page) => {
    await page.press("Fine");
    await page.until(offered);
    await rest(6000);
  }),
  beside: () => state("results/beside", async (page) => {
    for (const name of ["Draft", "Tilt"]) {
      await page.press(name);
      await page.until(offered);
      await page.key("k");
    }
    await page.press("Compare", "#beside");
  }),
  tray: () => state("editing/tray", async (page, port, markerId) => {
    const { marker } = await call(port, "marker.get", { markerId });
    const off = marker.pieces.slice(-14).map(({ id }) => ({ op: "takeOff", piece: id }));
    await call(port, "marker.apply", { markerId, ops: off });
    await page.until(`!document.querySelector("#tray").hidden`);
    const { x, y } = await page.ask(`(({ x, y, width, height }) => ({ x: x + width / 2, y: y + height / 2 }))(document.querySelector(".tray-row").getBoundingClientRect())`);
    await page.drag([x, y], [640, 330], { hold: true });
  }),
  places: () => state("editing/places", async (page, port, markerId) => {
    const { marker } = await call(port, "marker.get", { markerId });
    const off = marker.pieces.slice(-40).map(({ id }) => ({ op: "takeOff", piece: id }));
    await call(port, "marker.apply", { markerId, ops: off });
    await page.press("Show where");
    await page.until(`document.querySelector("#places").textContent.startsWith("Places where")`);
  }, { marker: "jeans_06g" }),
  together: () => state("editing/together", async (page, port, markerId) => {
    const other = await visit(browser, port, { ...size, marker: markerId });
    await other.drag([818, 372], [850, 362], { hold: true, steps: 30 });
    await page.until(`selvageRoom.draggedByOthers().length > 0`);
  }),
  nest: () => state("results/nest", async (page) => {
    await page.press("Nest");
    await page.until(offered);
  }, { marker: "jeans_02g", unplaced: true }),
  chain: () => state("results/chain", async (page) => {
    await compacted(page);
    await page.key("h");
    await page.click("#tab-length");
    await page.until(`!!document.querySelector("#prices")`);
  }),
  cloth: () => state("results/cloth", async (page) => {
    await page.key("e");
    await page.click("#tab-length");
    await page.until(`document.querySelector("#cloth").textContent.length > 5`);
  }),
  piece: () => state("editing/piece", async (page) => {
    await compacted(page);
    await page.key("h");
    await page.click("#tab-pieces");
    await pick(page, "3");
    await page.click("[data-part=x]");
    await atRevision(page, 3);
    await page.until(`document.querySelector("#panel-pieces").textContent.includes("1° more tilt")`);
  }),
  long: () => state("appearance/long", () => {}, { marker: "jeans_22g" }),
  rules: () => state("editing/rules", async (page) => {
    await page.click("#tab-pieces");
    await pick(page, "banded");
  }, { marker: ruled }),
  pattern: () => state("editing/pattern", async (page) => {
    await page.click("#tab-pieces");
    await pick(page, "pocket");
    await page.click("#piece-rules summary");
    await page.click("#rule-match");
    await atRevision(page, 2);
    await page.ask(`document.querySelector("#panel-pieces").scrollTop = 360`);
  }, { marker: plaid }),
  dark: () => state("appearance/dark", async (page) => {
    await compacted(page);
    await page.key("h");
  }, { media: [{ name: "prefers-color-scheme", value: "dark" }] }),
  german: () => state("appearance/german", async (page) => {
    await page.press("Tasten");
  }, { language: "de-DE" }),
  phone: () => state("appearance/phone", () => {}, { width: 390, height: 780, touch: true }),
};
if (process.env.ROOM_FILE) {
  states.disk = async () => {
    const page = await browser.open(pathToFileURL(process.env.ROOM_FILE).href, size);
    await page.until(`!!document.querySelector("#length")?.textContent && !!selvageRoom.view()`);
    await page.key("c");
    await page.until(offered);
    await rest();
    writeFileSync(`${folder}/appearance/disk.png`, await page.picture());
  };
}
const chosen = process.argv[3] ? process.argv[3].split(",") : Object.keys(states);
for (const name of chosen) await states[name]();
await browser.close();
