// Starts a daemon for one test, on free ports.
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export const selvaged = process.env.SELVAGED;
if (!selvaged) throw new Error("SELVAGED must name the daemon's program");

/** The token of a locked daemon. */
export const token = "correct horse battery";

/** Starts a daemon and returns its port and a function that stops it. `port`: 0 for a free one; `more`: further options. */
export async function startDaemon({ port = 0, locked = false, more = [] } = {}) {
  const folder = mkdtempSync(join(tmpdir(), "selvage-"));
  const file = join(folder, "ports");
  const options = ["--listen", `127.0.0.1:${port}`, "--port-file", file, "--log-level", "off", ...more];
  if (locked) {
    writeFileSync(join(folder, "token"), `${token}\n`);
    options.push("--token-file", join(folder, "token"));
  }
  const child = spawn(selvaged, options, { stdio: "ignore" });
  // A failing test must not wait for the daemon.
  child.unref();
  process.once("exit", () => child.kill("SIGKILL"));
  const ended = new Promise((resolve) => child.once("exit", resolve));
  while (!existsSync(file)) {
    if (child.exitCode !== null) throw new Error(`selvaged ended with ${child.exitCode}`);
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
  const stop = async (signal = "SIGTERM") => {
    child.ref();
    child.kill(signal);
    await ended;
    rmSync(folder, { recursive: true });
  };
  return { port: Number(readFileSync(file, "utf8").split("\n")[0]), stop };
}

/** A marker of separate squares in a row. */
export const squares = (count) => ({
  format: "selvage-marker",
  version: 1,
  strip: { width: 100 },
  shapes: [{ id: "square", outline: [[0, 0], [40, 0], [40, 40], [0, 40]] }],
  pieces: Array.from({ length: count }, (_, k) => ({ id: `p${k}`, shape: "square", at: [50 * k, (k % 3) * 10] })),
});
