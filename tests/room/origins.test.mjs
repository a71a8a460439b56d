// Pages of another site: one whose origin is allowed calls over HTTP, with the preflight of a real browser; others cannot.
import assert from "node:assert/strict";
import { createServer } from "node:http";
import { after, before, test } from "node:test";
import { startDaemon, token } from "../../clients/typescript/test/daemon.mjs";
import { Browser } from "./browser.mjs";

const sites = ["front.example", "foreign.example"];
let browser;
let server;
let port;

before(async () => {
  server = createServer((_, response) => response.writeHead(200, { "Content-Type": "text/html" }).end("<title>a site</title>"));
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  ({ port } = server.address());
  // Their names resolve to this machine, but the browser treats them like any other site.
  browser = await Browser.launch([`--host-resolver-rules=${sites.map((site) => `MAP ${site} 127.0.0.1`).join(",")}`]);
});
after(async () => {
  await browser.close();
  server.close();
});

/** The result of a call to the daemon by a page of the site: the status and the method, or the error. */
async function callFrom(site, daemon, headers) {
  const page = await browser.open(`http://${site}:${port}/`);
  await page.until(`document.title === "a site"`);
  return page.ask(`fetch("http://127.0.0.1:${daemon.port}/rpc", {
    method: "POST",
    headers: ${JSON.stringify({ "Content-Type": "application/json", ...headers })},
    body: JSON.stringify({ jsonrpc: "2.0", id: 1, method: "engine.info", params: {} }),
  }).then(async (response) => [response.status, response.ok && (await response.json()).result.name], (error) => [error.name])`);
}

test("a page of an allowed origin calls over HTTP", async () => {
  const daemon = await startDaemon({ more: ["--allow-origin", `http://front.example:${port}`] });
  assert.deepEqual(await callFrom("front.example", daemon), [200, "selvage"]);
  assert.deepEqual(await callFrom("foreign.example", daemon), ["TypeError"]);
  await daemon.stop();
});

test("it sends the token, and may read a refusal", async () => {
  const daemon = await startDaemon({ more: ["--allow-origin", `http://front.example:${port}`], locked: true });
  assert.deepEqual(await callFrom("front.example", daemon, { Authorization: `Bearer ${token}` }), [200, "selvage"]);
  assert.deepEqual(await callFrom("front.example", daemon, { Authorization: "Bearer guessed" }), [401, false]);
  assert.deepEqual(await callFrom("foreign.example", daemon, { Authorization: `Bearer ${token}` }), ["TypeError"]);
  await daemon.stop();
});
