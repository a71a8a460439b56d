// A daemon and a browser for the tests of a file, and functions to query the page.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before } from "node:test";
import { startDaemon } from "../../clients/typescript/test/daemon.mjs";
import { Browser } from "./browser.mjs";

process.setMaxListeners(64); // a daemon and a browser each end with the process

export { squares, startDaemon, token } from "../../clients/typescript/test/daemon.mjs";

export const example = (name) => JSON.parse(readFileSync(new URL(`../../examples/markers/${name}.json`, import.meta.url), "utf8"));

/** A browser for the tests of a file. */
export function withBrowser() {
  const here = {};
  before(async () => {
    here.browser = await Browser.launch();
  });
  after(() => here.browser.close());
  return here;
}

/** Calls a daemon over HTTP. */
export async function call(port, method, params = {}) {
  const response = await fetch(`http://127.0.0.1:${port}/rpc`, {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify({ jsonrpc: "2.0", id: 1, method, params }),
  });
  const { result, error } = await response.json();
  if (error) throw new Error(error.message);
  return result;
}

/** Opens the page of a daemon, and waits until its marker is drawn. */
export async function visit(browser, port, options = {}) {
  const page = await browser.open(`http://localhost:${port}/${options.marker ? `#${options.marker}` : ""}`, options);
  await page.until(`!!document.querySelector("#length")?.textContent && !!selvageRoom.view()`, "a marker on the table");
  return page;
}

/** The daemon's copy of the marker that the page shows. */
export const shown = async (page, port) => {
  const { markerId } = await page.ask("selvageRoom.view()");
  const { marker, revision } = await call(port, "marker.get", { markerId });
  return { markerId, marker, revision };
};

/** The position of a piece's label on the screen. */
export const spot = (page, piece) => page.ask(`selvageRoom.spotOf(${JSON.stringify(piece)})`);
export const revision = (page) => page.ask("selvageRoom.revision()");
export const atRevision = (page, wanted) => page.until(`selvageRoom.revision() >= ${wanted}`, `revision ${wanted}`);

/** Chooses the entry of the marker's menu that begins with a text. */
export async function choose(page, entry) {
  await page.click("#menu");
  const found = `[...document.querySelectorAll("#marker-menu [role=menuitem]")].find((one) => one.textContent.startsWith(${JSON.stringify(entry)}))`;
  await page.until(`!!${found}`, entry);
  await page.ask(`${found}.click()`);
}

/** Whether the marker is valid, according to the daemon. */
export async function assertValid(port, markerId) {
  const { valid, overlaps } = await call(port, "marker.check", { markerId });
  assert.ok(valid, `overlaps: ${JSON.stringify(overlaps)}`);
}

/** Runs a test with a new daemon and page; the page must not report an error. */
export async function story(here, act, { daemon = {}, page: options = {}, faults = [] } = {}) {
  const served = await startDaemon(daemon);
  try {
    const page = await visit(here.browser, served.port, options);
    await act(page, served.port, served);
    assert.deepEqual(page.faults.filter((fault) => !faults.some((expected) => fault.includes(expected))), []);
  } finally {
    await served.stop().catch(() => {});
  }
}
