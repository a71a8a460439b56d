// The page's speed, measured by the page: speed.mjs [FILE]; ONLY names the marker by how its name begins, MOVES how many moves a drag has, DRAGS
// how many drags the memory is watched over. The figures are printed beside their goals; whether a run counts, because its cores were quiet, is for who reads them.
import { writeFileSync } from "node:fs";
import { Browser } from "./browser.mjs";
import { call, example, revision, spot, squares, startDaemon, visit } from "./visit.mjs";

// An example as a native document: those of this repository are in another format.
async function native(name) {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker: example(name) });
  const { marker } = await call(daemon.port, "marker.get", { markerId });
  await daemon.stop();
  return marker;
}

const round = (figures) => Object.fromEntries(Object.entries(figures).map(([name, value]) => [name, Math.round(value * 100) / 100]));
const summary = async (page, kind) => round(await page.ask(`selvageRoom.times.${kind}.summary()`));

// Drags a piece near the middle around, at sixty positions a second.
async function dragAround(page, piece, moves) {
  const [x, y] = await spot(page, piece);
  await page.ask("Object.values(selvageRoom.times).forEach((times) => times.clear())");
  await page.mouse("mouseMoved", x, y, { button: "none", buttons: 0 });
  await page.mouse("mousePressed", x, y, { clickCount: 1 });
  for (let k = 1; k <= moves; ++k) {
    const angle = (2 * Math.PI * k) / 90;
    await page.mouse("mouseMoved", x + 30 * Math.cos(angle) - 30, y + 18 * Math.sin(angle));
    await new Promise((resolve) => setTimeout(resolve, 16));
  }
  await page.mouse("mouseReleased", x, y);
  await page.until(`selvageRoom.view().shown === 0`);
  return { frame: await summary(page, "frame"), answer: await summary(page, "answer") };
}

async function onMarker(browser, marker, piece, zoom) {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker });
  const start = performance.now();
  const page = await visit(browser, daemon.port, { marker: markerId });
  const opened = performance.now() - start;
  const paint = await page.until(`performance.getEntriesByName("first-contentful-paint")[0]?.startTime`, "the first paint");
  await whole(page);
  for (let k = 0; k < zoom; ++k) await page.wheel(...(await spot(page, piece)), -200);
  await new Promise((resolve) => setTimeout(resolve, 300));
  const dragged = await dragAround(page, piece, Number(process.env.MOVES ?? 180));
  const panned = await pan(page);
  await whole(page);
  const pannedWhole = await pan(page);
  await daemon.stop();
  return { opened: Math.round(opened), firstPaint: Math.round(paint), ...dragged, panned, pannedWhole };
}

// Key 0 shows the whole marker or, alternately for a long one, its whole width.
async function whole(page) {
  const scale = () => page.ask("selvageRoom.view().scale");
  await page.key("0");
  const one = await scale();
  await page.key("0");
  if ((await scale()) > one) await page.key("0");
  await new Promise((resolve) => setTimeout(resolve, 300));
}

async function pan(page) {
  await page.ask("Object.values(selvageRoom.times).forEach((times) => times.clear())");
  const frames = page.ask(FRAMES);
  await page.drag([700, 300], [500, 330], { button: "right", steps: 120, pause: 16 });
  await page.ask("globalThis.panned = true");
  return { frame: await summary(page, "frame"), whole: await summary(page, "settled"), framesPerSecond: Math.round(await frames) };
}
// How many frames a second the browser shows until the panning ends.
const FRAMES = `new Promise((resolve) => {
  const start = performance.now();
  let count = 0;
  globalThis.panned = false;
  const next = () => (panned ? resolve((1000 * count) / (performance.now() - start)) : (++count, requestAnimationFrame(next)));
  requestAnimationFrame(next);
})`;

const tiles = (count) => {
  const marker = { ...squares(1) };
  marker.strip = { width: 1000 };
  marker.pieces = Array.from({ length: count }, (_, k) => ({ id: `p${k}`, shape: "square", at: [42 * Math.floor(k / 23), 42 * (k % 23)] }));
  return marker;
};

// Copies of a garment-like marker one behind another, with outlines of a hundred vertices.
const repeated = (marker, times) => {
  const { pieces, ...rest } = marker;
  return { ...rest, pieces: Array.from({ length: times }, (_, k) => pieces.map((piece) => ({ ...piece, id: `${piece.id}-${k}`, at: [piece.at[0] + k * LONG, piece.at[1]] }))).flat() };
};
const LONG = 26_700; // jeans_22g is a little shorter

// Drags one after another, each of them begun, moved and committed; the next begins when the revision of the last is there.
async function memoryOver(browser, drags) {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker: squares(12) });
  const page = await visit(browser, daemon.port, { marker: markerId });
  await page.key("0"); // all of it
  const at = (wanted) => page.ask(`new Promise((resolve) => {
    const look = () => (selvageRoom.revision() >= ${wanted} ? resolve(selvageRoom.spotOf("p5")) : setTimeout(look, 1));
    look();
  })`);
  let next = (await revision(page)) + 1;
  const many = async (count) => {
    for (let k = 0; k < count; ++k, ++next) {
      const [x, y] = await at(next - 1);
      const to = x + (next % 2 ? 8 : -8);
      await Promise.all([page.mouse("mouseMoved", x, y, { button: "none", buttons: 0 }), page.mouse("mousePressed", x, y, { clickCount: 1 }), page.mouse("mouseMoved", to, y), page.mouse("mouseReleased", to, y)]);
    }
    await at(next - 1);
  };
  const kept = async () => {
    const counts = await page.living();
    return { ...counts, heapMiB: Math.round((await page.send("Runtime.getHeapUsage")).usedSize / 1048.576) / 1000 };
  };
  await many(Math.ceil(drags / 10)); // creates everything that is created only once
  const series = [await kept()];
  for (let k = 0; k < 4; ++k) {
    await many(Math.ceil(drags / 4));
    series.push(await kept());
  }
  await daemon.stop();
  return { drags: 4 * Math.ceil(drags / 4), series };
}

// The goals, each with the function that reads its figure.
const GOALS = [
  ["440 pieces", "script per frame while dragged, p95", 4, ({ frame }) => frame.p95],
  ["1,000 pieces", "script per frame while dragged, p95", 8, ({ frame }) => frame.p95],
  ["440 pieces", "from the move to the neighbours' new places, p50", 16, ({ answer }) => answer.p50],
  ["440 pieces", "from the move to the neighbours' new places, p99", 50, ({ answer }) => answer.p99],
  ["1,000 pieces", "from the move to the neighbours' new places, p50", 16, ({ answer }) => answer.p50],
  ["1,000 pieces", "from the move to the neighbours' new places, p99", 50, ({ answer }) => answer.p99],
  ["440 pieces", "first paint", 500, ({ firstPaint }) => firstPaint],
  ["4,000 pieces", "opened and drawn", 1500, ({ opened }) => opened],
  ["4,000 pieces", "milliseconds a frame while panned, near", 1000 / 30, ({ panned }) => 1000 / panned.framesPerSecond],
  ["4,000 pieces", "milliseconds a frame while panned, all in view", 1000 / 30, ({ pannedWhole }) => 1000 / pannedWhole.framesPerSecond],
  ["4,400 pieces", "opened and drawn", 1500, ({ opened }) => opened],
  ["4,400 pieces", "milliseconds a frame while panned, all in view", 1000 / 30, ({ pannedWhole }) => 1000 / pannedWhole.framesPerSecond],
  ["memory", "MiB of heap that the last three quarters of the drags added", 0.1, ({ series }) => series[4].heapMiB - series[1].heapMiB],
];

function judged(figures) {
  return GOALS.flatMap(([of, what, most, read]) => {
    const name = Object.keys(figures).find((one) => one.startsWith(of));
    if (name === undefined) return [];
    const value = Math.round(read(figures[name]) * 100) / 100;
    return [`${value <= most ? "met   " : "MISSED"} ${name}: ${what}: ${value}, goal ${Math.round(most * 10) / 10}`];
  });
}

const browser = await Browser.launch();
try {
  await onMarker(browser, tiles(1), "p0", 0); // the browser itself has started then
  const measured = {
    "440 pieces (jeans_22g)": () => onMarker(browser, example("jeans_22g"), "200", 8),
    "1,000 pieces": () => onMarker(browser, tiles(1000), "p500", 4),
    "4,000 pieces": () => onMarker(browser, tiles(4000), "p2000", 9),
    "4,400 pieces (jeans_22g ten times)": async () => onMarker(browser, repeated(await native("jeans_22g"), 10), "200-0", 8),
    memory: () => memoryOver(browser, Number(process.env.DRAGS ?? 60)),
  };
  const figures = {};
  for (const [name, measure] of Object.entries(measured)) {
    if (name.startsWith(process.env.ONLY ?? "")) figures[name] = await measure();
  }
  console.log(JSON.stringify(figures, null, 1));
  console.log(judged(figures).join("\n"));
  if (process.argv[2]) writeFileSync(process.argv[2], JSON.stringify(figures, null, 1) + "\n");
} finally {
  await browser.close();
}
