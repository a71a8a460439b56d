// The example of the package, as a user runs it: the package is found under its name.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";

import { startDaemon } from "./daemon.mjs";

const at = (path) => fileURLToPath(new URL(path, import.meta.url));

test("examples/typescript/compact.mjs", async () => {
  const daemon = await startDaemon();
  const folder = mkdtempSync(join(tmpdir(), "selvage-"));
  mkdirSync(join(folder, "node_modules"));
  symlinkSync(at(".."), join(folder, "node_modules", "selvage-client"));
  cpSync(at("../../../examples/typescript/compact.mjs"), join(folder, "compact.mjs"));
  const words = [join(folder, "compact.mjs"), at("../../../examples/markers/simon_06g.json"), String(daemon.port)];
  const told = execFileSync(process.execPath, words, { encoding: "utf8" });
  assert.match(told, /round 1: [\d.]+\n/);
  const [, before, after] = told.match(/([\d.]+) -> ([\d.]+), valid: true/);
  assert.ok(Number(after) < Number(before));
  rmSync(folder, { recursive: true });
  await daemon.stop();
});
