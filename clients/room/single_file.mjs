// Writes the page as one HTML file that can be opened from disk: single_file.mjs ENGINE FILE
// ENGINE is engine.wasm of packaging/wasm.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const [engine, file] = process.argv.slice(2);
const here = (name) => fileURLToPath(new URL(name, import.meta.url));
const work = mkdtempSync(join(tmpdir(), "selvage-page-"));
const page = join(work, "page");
const worker = join(work, "worker.js");
execFileSync(here("build.sh"), [page, here("../../examples/markers")]);
execFileSync("esbuild", [here("standalone/worker.ts"), "--bundle", "--minify", "--format=iife", "--target=es2022", "--log-level=warning", `--outfile=${worker}`]);

const textOf = (name) => readFileSync(join(page, name), "utf8");
const asData = (type, content) => `data:${type};base64,${Buffer.from(content).toString("base64")}`;
const inline = (script) => script.replaceAll("</script", "<\\/script");
// The replacement is a function, so that "$" in the content has no special meaning.
const replaced = (html, pattern, made) => {
  if (!pattern.test(html)) throw new Error(`index.html has no ${pattern}`);
  return html.replace(pattern, (_, name) => made(name));
};
const examplesIn = (name) => {
  const examples = JSON.parse(textOf(name)).map((one) => ({ ...one, file: asData("application/json", textOf(one.file)) }));
  return asData("application/json", JSON.stringify(examples));
};
const scriptsWith = (name) =>
  [
    `<script id="engine" type="application/octet-stream">${gzipSync(readFileSync(engine), { level: 9 }).toString("base64")}</script>`,
    `<script id="engine-worker" type="text/plain">${inline(readFileSync(worker, "utf8"))}</script>`,
    `<script type="module">${inline(textOf(name))}</script>`,
  ].join("\n");

let html = textOf("index.html");
html = replaced(html, /<link rel="icon" href="([^"]+)"/, (name) => `<link rel="icon" href="${asData("image/svg+xml", textOf(name))}"`);
html = replaced(html, /<link rel="stylesheet" href="([^"]+)">/, (name) => `<style>${textOf(name)}</style>`);
html = replaced(html, /<link rel="x-examples" href="([^"]+)">/, (name) => `<link rel="x-examples" href="${examplesIn(name)}">`);
html = replaced(html, /<script src="([^"]+)" type="module"><\/script>/, scriptsWith);
writeFileSync(file, html);
rmSync(work, { recursive: true });
console.log(`${file}: ${(html.length / 1e6).toFixed(2)} MB`);
