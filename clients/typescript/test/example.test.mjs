// Runs the example of the package as a user would: it imports the package by its name.
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
  const command = [join(folder, "compact.mjs"), at("../../../examples/markers/simon_06g.json"), String(daemon.port)];
  const output = execFileSync(process.execPath, command, { encoding: "utf8" });
  assert.match(output, /round 1: [\d.]+\n/);
  const [, before, after] = output.match(/([\d.]+) -> ([\d.]+), valid: true/);
  assert.ok(Number(after) < Number(before));
  rmSync(folder, { recursive: true });
  await daemon.stop();
});
