// The page's speed, measured by the page: speed.mjs [FILE]. Limits are judged on quiet cores by who reads the figures.
import { writeFileSync } from "node:fs";
import { Browser } from "./browser.mjs";
import { atRevision, call, example, revision, spot, squares, startDaemon, visit } from "./visit.mjs";

const round = (figures) => Object.fromEntries(Object.entries(figures).map(([name, value]) => [name, Math.round(value * 100) / 100]));
const summary = async (page, kind) => round(await page.ask(`selvageRoom.times.${kind}.summary()`));

// A piece near the middle is led around, as a hand would, at sixty positions a second.
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
  const before = await revision(page);
  await page.mouse("mouseReleased", x, y);
  await page.until(`selvageRoom.view().shown === 0`);
  return { frame: await summary(page, "frame"), answer: await summary(page, "answer"), committed: (await revision(page)) > before };
}

async function onMarker(browser, marker, piece, zoom) {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker });
  const start = performance.now();
  const page = await visit(browser, daemon.port, { marker: markerId });
  const opened = performance.now() - start;
  const paint = await page.ask(`performance.getEntriesByName("first-contentful-paint")[0]?.startTime`);
  for (let k = 0; k < zoom; ++k) await page.wheel(...(await spot(page, piece)), -200);
  await new Promise((resolve) => setTimeout(resolve, 300));
  const dragged = await dragAround(page, piece, 180);
  const panned = await pan(page);
  await daemon.stop();
  return { opened: Math.round(opened), firstPaint: Math.round(paint), ...dragged, panned };
}

async function pan(page) {
  await page.ask("Object.values(selvageRoom.times).forEach((times) => times.clear())");
  await page.drag([700, 300], [500, 330], { button: "right", steps: 60, pause: 16 });
  return { frame: await summary(page, "frame"), whole: await summary(page, "settled") };
}

const tiles = (count) => {
  const marker = { ...squares(1) };
  marker.strip = { width: 1000 };
  marker.pieces = Array.from({ length: count }, (_, k) => ({ id: `p${k}`, shape: "square", at: [42 * Math.floor(k / 23), 42 * (k % 23)] }));
  return marker;
};

async function memoryOver(browser, drags) {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker: squares(12) });
  const page = await visit(browser, daemon.port, { marker: markerId });
  const heap = async () => {
    await page.send("HeapProfiler.collectGarbage");
    return (await page.send("Runtime.getHeapUsage")).usedSize;
  };
  const once = async () => {
    const [x, y] = await spot(page, "p5");
    const before = await revision(page);
    await page.drag([x, y], [x + (before % 2 ? 8 : -8), y], { steps: 2, pause: 1 });
    await atRevision(page, before + 1);
  };
  for (let k = 0; k < drags / 10; ++k) await once();
  const first = await heap();
  for (let k = 0; k < drags; ++k) await once();
  const last = await heap();
  await daemon.stop();
  return { drags, firstMiB: Math.round(first / 1048.576) / 1000, lastMiB: Math.round(last / 1048.576) / 1000 };
}

const browser = await Browser.launch();
try {
  const figures = {
    "440 pieces (jeans_22g)": await onMarker(browser, example("jeans_22g"), "200", 4),
    "1,000 pieces": await onMarker(browser, tiles(1000), "p500", 4),
    "4,000 pieces": await onMarker(browser, tiles(4000), "p2000", 6),
    memory: await memoryOver(browser, Number(process.env.DRAGS ?? 60)),
  };
  console.log(JSON.stringify(figures, null, 1));
  if (process.argv[2]) writeFileSync(process.argv[2], JSON.stringify(figures, null, 1) + "\n");
} finally {
  await browser.close();
}
