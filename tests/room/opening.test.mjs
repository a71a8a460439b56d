// What happens when the page is opened, and how markers are opened, saved and copied.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { Browser } from "./browser.mjs";
import { call, choose, example, shown, squares, startDaemon, story, token, visit, withBrowser } from "./visit.mjs";

const here = withBrowser();

test("an example marker is open", () =>
  story(here, async (page, port) => {
    const { marker } = await shown(page, port);
    assert.equal(marker.name, "jeans_02g");
    assert.equal(await page.text("#length"), "2,460.4 mm");
    assert.equal(await page.text("#utilisation"), "81.11 %");
    // Nothing is loaded from other sites.
    for (const url of page.requests) assert.match(url, new RegExp(`^(https?|ws)://localhost:${port}/`));
    const painted = await page.ask(`performance.getEntriesByName("first-contentful-paint")[0]?.startTime`);
    assert.ok(painted > 0);
  }));

test("the marker that is open already is shown, not a new one", async () => {
  const daemon = await startDaemon();
  const { markerId } = await call(daemon.port, "marker.open", { marker: squares(5) });
  const page = await visit(here.browser, daemon.port);
  assert.equal((await shown(page, daemon.port)).markerId, markerId);
  assert.equal((await call(daemon.port, "marker.list")).markers.length, 1);
  await daemon.stop();
});

test("the page is small, cached by hash, and may load nothing from other sites", async () => {
  const daemon = await startDaemon();
  const page = await fetch(`http://127.0.0.1:${daemon.port}/`);
  const html = await page.text();
  assert.equal(page.headers.get("cache-control"), "no-cache");
  const policy = page.headers.get("content-security-policy");
  assert.match(policy, /default-src 'none'/);
  assert.doesNotMatch(policy, /unsafe|\*|https?:/);
  const names = [...html.matchAll(/(?:href|src)="([^"]+)"/g)].map(([, name]) => name);
  assert.ok(names.length >= 4);
  const more = JSON.parse(await (await fetch(`http://127.0.0.1:${daemon.port}/${names.find((name) => name.startsWith("examples"))}`)).text());
  let bytes = Number(page.headers.get("content-length"));
  for (const name of [...names, ...more.map(({ file }) => file)]) {
    const response = await fetch(`http://127.0.0.1:${daemon.port}/${name}`);
    assert.equal(response.status, 200, name);
    assert.match(name, /-[0-9a-f]{10}\.\w+$/);
    assert.match(response.headers.get("cache-control"), /immutable/);
    assert.equal(response.headers.get("content-encoding"), "gzip");
    bytes += Number(response.headers.get("content-length"));
  }
  console.log(`the page and all its files: ${bytes} bytes compressed`);
  assert.ok(bytes < 150_000, `${bytes} bytes`);
  await daemon.stop();
});

test("files are opened by dropping them, and saved as they are shown", () =>
  story(here, async (page, port) => {
    const text = JSON.stringify({ ...squares(7), name: "seven" });
    await page.ask(`(() => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([${JSON.stringify(text)}], "seven.json"));
      dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
    })()`);
    await page.until(`document.querySelector("#marker-name").textContent === "seven"`);
    const folder = mkdtempSync(join(tmpdir(), "selvage-saved-"));
    await page.saveTo(folder);
    await page.key("s", "control");
    let saved;
    for (let k = 0; k < 200 && !saved; ++k, await new Promise((resolve) => setTimeout(resolve, 25))) {
      try {
        saved = JSON.parse(readFileSync(join(folder, "seven.json"), "utf8"));
      } catch {}
    }
    assert.equal(saved.pieces.length, 7);
    const { length } = await call(port, "marker.open", { marker: saved });
    assert.equal(length, 340);
  }));

test("the drawing is saved as an SVG", () =>
  story(here, async (page) => {
    const folder = mkdtempSync(join(tmpdir(), "selvage-saved-"));
    await page.saveTo(folder);
    await page.click("#menu");
    await page.press("Save drawing (SVG)", "#marker-menu");
    let drawing = "";
    for (let k = 0; k < 400 && !drawing.includes("</svg>"); ++k, await new Promise((resolve) => setTimeout(resolve, 25))) {
      try {
        drawing = readFileSync(join(folder, "jeans_02g.svg"), "utf8");
      } catch {}
    }
    assert.match(drawing, /<svg[^]*<\/svg>/);
  }));

test("a pattern is opened with its rule table and an order, and written for the cutter", () =>
  story(here, async (page, port) => {
    const text = (name) => readFileSync(new URL(`../../examples/trade/${name}`, import.meta.url), "utf8");
    const names = ["clo_like.dxf", "clo_like.rul"];
    await page.ask(`(() => {
      const transfer = new DataTransfer();
      for (const [name, content] of ${JSON.stringify(names.map((name) => [name, text(name)]))}) transfer.items.add(new File([content], name));
      dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
    })()`);
    await page.until(`document.querySelector("#toast").textContent.startsWith("clo_like.dxf: ")`);
    const { marker } = await call(port, "marker.get", { markerId: (await page.ask("selvageRoom.view()")).markerId });
    const graded = await call(port, "marker.open", { marker: text("clo_like.dxf"), rules: text("clo_like.rul") });
    assert.equal(marker.pieces.length, graded.pieces);
    const folder = mkdtempSync(join(tmpdir(), "selvage-saved-"));
    await page.saveTo(folder);
    await choose(page, "jeans_02g");
    await page.until(`document.querySelector("#marker-name").textContent === "jeans_02g"`);
    for (const [entry, file, start] of [["Save for the cutter", "jeans_02g.cut", "H1*"], ["Save in full size", "jeans_02g.pdf", "%PDF-"]]) {
      await choose(page, entry);
      let written = "";
      for (let k = 0; k < 400 && !written.startsWith(start); ++k, await new Promise((resolve) => setTimeout(resolve, 25))) {
        try {
          written = readFileSync(join(folder, file), "utf8");
        } catch {}
      }
      assert.ok(written.startsWith(start), file);
    }
  }));

test("a file that is not a marker is refused with a message", () =>
  story(here, async (page) => {
    await page.ask(`(() => {
      const transfer = new DataTransfer();
      transfer.items.add(new File(['{"format": "selvage-marker"}'], "bad.json"));
      dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
    })()`);
    await page.until(`document.querySelector("#toast").textContent.length > 10`);
    assert.equal(await page.text("#marker-name"), "jeans_02g");
  }));

test("a daemon with a token asks for it, and says when it is wrong", async () => {
  const daemon = await startDaemon({ locked: true });
  const page = await here.browser.open(`http://localhost:${daemon.port}/`);
  await page.until(`!!document.querySelector("dialog #token")`);
  await page.click("#token");
  await page.type("something else entirely");
  await page.key("Enter");
  await page.until(`document.querySelector("dialog .fault")?.textContent.length > 5`);
  await page.click("#token");
  await page.type(token);
  await page.key("Enter");
  await page.until(`!document.querySelector("dialog") && !!document.querySelector("#length")?.textContent`);
  await daemon.stop();
});

test("a page under the daemon's own name may call it; another origin may not", async () => {
  const daemon = await startDaemon({ more: ["--allow-host", "marker-room.test"] });
  const browser = await Browser.launch(["--host-resolver-rules=MAP marker-room.test 127.0.0.1"]);
  try {
    const page = await browser.open(`http://marker-room.test:${daemon.port}/`);
    await page.until(`!!document.querySelector("#length")?.textContent`);
  } finally {
    await browser.close();
  }
  const headers = { Host: `localhost:${daemon.port}`, Origin: "http://elsewhere.test" };
  assert.equal((await fetch(`http://127.0.0.1:${daemon.port}/healthz`, { headers })).status, 403);
  await daemon.stop();
});

test("without a store the page says that nothing is kept", () =>
  story(here, async (page) => {
    await page.until(`document.querySelector("#keeps-nothing").offsetParent !== null`);
    assert.match(await page.text("#keeps-nothing"), /--store/);
  }));

test("a copy is another marker", () =>
  story(here, async (page, port) => {
    await page.click("#menu");
    await page.press("Make a copy", "#marker-menu");
    await page.until(`document.querySelector("#marker-name").textContent === "jeans_02g 2"`);
    assert.equal((await call(port, "marker.list")).markers.length, 2);
  }));
