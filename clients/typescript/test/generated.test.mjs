import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";

import { discover, generate } from "../scripts/generate.mjs";
import { markerTypes } from "../scripts/marker_types.mjs";
import { selvaged } from "./daemon.mjs";

test("the types are those of the daemon: npm run generate changes nothing", () => {
  assert.equal(readFileSync(new URL("../src/methods.ts", import.meta.url), "utf8"), generate(discover(selvaged)));
});

test("the document's types are those of the schema: npm run generate changes nothing", () => {
  assert.equal(readFileSync(new URL("../src/marker.ts", import.meta.url), "utf8"), markerTypes());
});
