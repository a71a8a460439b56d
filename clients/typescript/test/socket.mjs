// A WebSocket class: that of Node (22 or later), or that of the package ws, from npm or, with NODE_PATH, from Debian.
import { createRequire } from "node:module";

export const Socket = globalThis.WebSocket ?? createRequire(import.meta.url)("ws");
