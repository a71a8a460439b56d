// The page as one file, opened from disk: ROOM_FILE names it. There is no daemon; the engine runs in the page.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { atRevision, spot, squares, withBrowser } from "../visit.mjs";

const here = withBrowser();
const offered = `document.querySelector("#offer").dataset.shown === "yes"`;

const story = (act) => async () => {
  const page = await here.browser.open(pathToFileURL(process.env.ROOM_FILE).href);
  await page.until(`!!document.querySelector("#length")?.textContent && !!selvageRoom.view()`, "a marker on the table");
  await act(page);
  assert.deepEqual(page.faults, []);
  await page.close();
};
const drop = (page, marker, name = "dropped.json") =>
  page.ask(`(() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([${JSON.stringify(typeof marker === "string" ? marker : JSON.stringify(marker))}], "${name}"));
    dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  })()`);

test("an example marker is open, and the page says that it runs without a daemon", story(async (page) => {
  assert.equal(await page.text("#marker-name"), "jeans_02g");
  assert.equal(await page.text("#length"), "2,460.4 mm");
  assert.equal(await page.text("#link-state"), "engine in this page");
  assert.match(await page.text("#keeps-nothing"), /^No daemon: .*one core/i);
  for (const url of page.requests) assert.match(url, /^(file|data|blob):/);
}));

test("it compacts, takes, and undoes; the length is that of the daemon", story(async (page) => {
  await page.key("c");
  await page.until(offered);
  assert.equal(await page.text("#length"), "2,452.2 mm");
  await page.key("Enter");
  await atRevision(page, 2);
  await page.key("z", "control");
  await atRevision(page, 3);
  await page.until(`document.querySelector("#length").textContent === "2,460.4 mm"`);
}));

test("a drag pushes its neighbours aside", story(async (page) => {
  await drop(page, { ...squares(6), name: "six" });
  await page.until(`document.querySelector("#marker-name").textContent === "six"`);
  await page.key("0");
  const [x, y] = await spot(page, "p1");
  const { scale } = await page.ask("selvageRoom.view()");
  await page.drag([x, y], [x + 40 * scale, y], { hold: true, steps: 20 });
  await page.until("selvageRoom.view().shown > 1", "a neighbour that makes way");
  await page.mouse("mouseReleased", x + 40 * scale, y);
  await atRevision(page, 2);
}));

test("a search shows its best result and stops after its turn; nothing waits for longer", story(async (page) => {
  await page.press("Fine");
  await page.until(offered);
  await page.press("Stop");
  await page.until(`document.querySelector("#progress").hidden`, "the end of the search");
  await page.key("Enter");
  await atRevision(page, 2);
}));

test("rules of the length, free cloth, the menu and the tray work, too", story(async (page) => {
  await page.click("#tab-length");
  await page.until(`!!document.querySelector("#prices")`);
  await page.key("e");
  await page.until(`/regions?, /.test(document.querySelector("#cloth").textContent)`);
  await page.click("#menu");
  await page.until(`document.querySelectorAll("#marker-menu [role=menuitem]").length > 11`);
  assert.match(await page.text("#marker-menu"), /Open in this page.*Examples/s);
  await page.press("simon_06g", "#marker-menu");
  await page.until(`document.querySelector("#marker-name").textContent === "simon_06g"`);
}));

test("pieces off the cloth are nested; a cut file is opened; other files are refused without a restart", story(async (page) => {
  const off = squares(4);
  const { pieces, ...rest } = off;
  await drop(page, { ...rest, name: "off", pieces: [], unplaced: pieces.map(({ at: _, ...piece }) => piece) });
  await page.until(`!document.querySelector("#tray").hidden`);
  await page.press("Nest");
  await page.until(offered);
  await page.until(`document.querySelector("#progress").hidden || (document.querySelector("#progress button").click(), false)`);
  await page.key("Enter");
  await atRevision(page, 2);
  assert.equal(await page.text("#length"), "80.0 mm");
  const cut = readFileSync(new URL("../../../examples/trade/gemini_like.cut", import.meta.url), "utf8");
  await drop(page, cut, "gemini.cut");
  await page.until(`document.querySelector("#toast").textContent.startsWith("gemini.cut: ")`);
  const id = (await page.ask("selvageRoom.view()")).markerId;
  await drop(page, "0\nSECTION\nnonsense", "bad.dxf");
  await page.until(`!document.querySelector("#toast").textContent.startsWith("gemini.cut: ")`);
  assert.equal((await page.ask("selvageRoom.view()")).markerId, id);
}));

test("invalid files are refused with a message; markers are saved", story(async (page) => {
  await drop(page, { format: "selvage-marker" });
  await page.until(`document.querySelector("#toast").textContent.length > 10`);
  const folder = mkdtempSync(join(tmpdir(), "selvage-saved-"));
  await page.saveTo(folder);
  await page.key("s", "control");
  let saved;
  for (let k = 0; k < 200 && !saved; ++k, await new Promise((resolve) => setTimeout(resolve, 25))) {
    try {
      saved = JSON.parse(readFileSync(join(folder, "jeans_02g.json"), "utf8"));
    } catch {}
  }
  assert.equal(saved.pieces.length, 40);
}));
