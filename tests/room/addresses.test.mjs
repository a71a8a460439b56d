// Markers named by the page's address, files in the encodings of the trade, and what a page leaves behind in the daemon.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { call, shown, squares, startDaemon, story, token, visit, withBrowser } from "./visit.mjs";

const here = withBrowser();
const markersOf = async (port) => (await call(port, "marker.list")).markers;
const shows = (page, markerId) => page.until(`selvageRoom.view()?.markerId === "${markerId}" && location.hash === "#${markerId}"`);

test("an address that names a closed marker says so", () =>
  story(
    here,
    async (page, port) => {
      await page.until(`document.querySelector("#toast").textContent.includes("m7")`);
      await shows(page, "m1");
      assert.equal((await markersOf(port)).length, 1);
    },
    { page: { marker: "m7" } },
  ));

test("an address with a sign that is no encoded character opens the page", () =>
  story(
    here,
    async (page) => {
      await page.until(`document.querySelector("#toast").textContent.includes("%")`);
      await shows(page, "m1");
    },
    { page: { marker: "%" } },
  ));

test("a changed address shows the marker that it names", () =>
  story(here, async (page, port) => {
    const { markerId } = await call(port, "marker.open", { marker: squares(5) });
    await page.ask(`void (location.hash = "${markerId}")`);
    await shows(page, markerId);
    assert.equal((await shown(page, port)).marker.pieces.length, 5);
    await page.ask(`void (location.hash = "m99")`);
    await page.until(`document.querySelector("#toast").textContent.includes("m99")`);
    await shows(page, markerId);
    await page.ask("history.go(-2)");
    await shows(page, "m1");
  }));

const pattern = readFileSync(new URL("../../examples/trade/clo_like.dxf", import.meta.url), "latin1");
// The bytes of a pattern whose first piece has this name, as one character for each byte.
const named = (name, page = "") => {
  const stated = page && `  0\r\nSECTION\r\n  2\r\nHEADER\r\n  9\r\n$DWGCODEPAGE\r\n  3\r\n${page}\r\n  0\r\nENDSEC\r\n`;
  return stated + pattern.replaceAll(/(Piece Name: ?)[^\r\n]*/gi, `$1${name}`);
};
const wide = (text) => Buffer.from(text, "utf16le").toString("latin1");
const swapped = (text) => Buffer.from(text, "utf16le").swap16().toString("latin1");

test("names in files are read as the command line reads them", () =>
  story(here, async (page, port) => {
    const front = "\u524d\u7247"; // as GBK: c7 b0 c6 ac
    const cases = {
      gbk: [named("\xc7\xb0\xc6\xac"), front],
      "utf-8": [named(Buffer.from(front).toString("latin1")), front],
      marked: ["\xff\xfe" + wide(named(front)), front],
      unmarked: [wide(named(front)), front],
      "big-endian": ["\xfe\xff" + swapped(named(front)), front],
      western: [named("Pi\xe8ce"), "Pi\u00e8ce"],
      big5: [named("\xab\x65\xa4\xf9"), front],
      japanese: [named("\x91\x4f\x95\xd0", "ANSI_932"), "\u524d\u7247"],
    };
    const encodings = { gbk: "GBK", marked: "UTF-16 (little-endian)", western: "Windows-1252", big5: "Big5", japanese: "Shift JIS" };
    for (const [name, [bytes, expected]] of Object.entries(cases)) {
      await page.ask(`(() => {
        const transfer = new DataTransfer();
        const bytes = Uint8Array.from(atob("${Buffer.from(bytes, "latin1").toString("base64")}"), (letter) => letter.charCodeAt(0));
        transfer.items.add(new File([bytes], "${name}.dxf"));
        dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
      })()`);
      await page.until(`document.querySelector("#toast").textContent.startsWith("${name}.dxf: ")`);
      const message = await page.text("#toast");
      if (encodings[name]) assert.match(message, /notes, the first: /);
      if (encodings[name]) assert.ok(message.includes(`texts are read as ${encodings[name]}`), message);
      else if (name === "plain") assert.ok(!message.includes("read as"), message);
      const { marker } = await shown(page, port);
      assert.ok(marker.shapes.some(({ id, attributes }) => `${id} ${attributes?.name}`.includes(expected)), `${name}: ${marker.shapes.map(({ id }) => id)}`);
    }
  }));

for (const locked of [false, true]) {
  test(`a page that is left during a search leaves no copy behind${locked ? ", with a token" : ""}`, async () => {
    const daemon = await startDaemon({ locked });
    const page = await visit(here.browser, daemon.port, locked ? { token } : {});
    await page.press("Fine");
    const names = async () => (await openMarkers(daemon.port, locked)).map(({ name }) => name);
    for (const end = Date.now() + 30_000; (await names()).length < 2 && Date.now() < end; ) await new Promise((resolve) => setTimeout(resolve, 20));
    assert.equal((await names()).length, 2);
    await page.send("Page.navigate", { url: "about:blank" });
    for (const end = Date.now() + 10_000; (await names()).length > 1 && Date.now() < end; ) await new Promise((resolve) => setTimeout(resolve, 20));
    assert.deepEqual(await names(), ["jeans_02g"]);
    await daemon.stop();
  });
}

test("a page to which the user returns is connected again", () =>
  story(here, async (page, port) => {
    await page.send("Page.navigate", { url: "about:blank" });
    await page.until(`location.href === "about:blank"`);
    await page.ask("history.back()");
    await page.until(`document.querySelector("#status")?.dataset.state === "open" && !!selvageRoom.view()`);
    const { markerId } = await shown(page, port);
    await call(port, "motion.compact", { markerId });
    await page.until("selvageRoom.revision() >= 2");
  }));

test("a page that crashes during a search leaves no copy behind", () =>
  story(here, async (page, port) => {
    await page.press("Fine");
    await becomes(2, port);
    void page.send("Page.crash").catch(() => {});
    await becomes(1, port);
    assert.deepEqual((await markersOf(port)).map(({ name }) => name), ["jeans_02g"]);
  }));

test("a search goes on with a new copy after the daemon was started again", async () => {
  const first = await startDaemon();
  const page = await visit(here.browser, first.port);
  await page.press("Nest");
  await becomes(2, first.port);
  await first.stop("SIGKILL");
  const second = await startDaemon({ port: first.port });
  await page.until(`document.querySelector("#toast").textContent.includes("opened again")`);
  await becomes(2, second.port);
  const names = (await markersOf(second.port)).map(({ name }) => name).sort();
  assert.deepEqual(names, ["jeans_02g", "jeans_02g (search)"]);
  await second.stop();
});

async function becomes(count, port) {
  for (const end = Date.now() + 30_000; (await markersOf(port)).length !== count && Date.now() < end; ) await new Promise((resolve) => setTimeout(resolve, 20));
  assert.equal((await markersOf(port)).length, count);
}

// The open markers, asked with the token if the daemon is locked.
async function openMarkers(port, locked) {
  const headers = { "Content-Type": "application/json", ...(locked ? { Authorization: `Bearer ${token}` } : {}) };
  const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "marker.list", params: {} });
  const response = await fetch(`http://127.0.0.1:${port}/rpc`, { method: "POST", headers, body });
  return (await response.json()).result.markers;
}
