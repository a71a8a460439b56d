import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import test from "node:test";

import { discover, generate } from "../scripts/generate.mjs";
import { selvaged } from "./daemon.mjs";

const source = new URL("../src/", import.meta.url);
const generated = generate(discover(selvaged));

test("the types are those of the daemon: npm run generate changes nothing", () => {
  for (const [path, text] of Object.entries(generated)) assert.equal(readFileSync(new URL(path, source), "utf8"), text, path);
});

test("src/methods contains generated files only", () => {
  const files = readdirSync(new URL("methods/", source)).map((name) => `methods/${name}`);
  assert.deepEqual(files.sort(), Object.keys(generated).filter((path) => path.startsWith("methods/")).sort());
});

test("no generated file is longer than 500 lines", () => {
  for (const [path, text] of Object.entries(generated)) assert.ok(text.split("\n").length <= 500, path);
});
