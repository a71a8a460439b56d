// A class of WebSockets: Node's own (22 or later), or that of the package ws, from npm or, by NODE_PATH, from Debian.
import { createRequire } from "node:module";

export const Socket = globalThis.WebSocket ?? createRequire(import.meta.url)("ws");
