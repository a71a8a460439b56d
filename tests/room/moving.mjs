// The moving picture of the README: a drag that pushes its neighbours, and the compaction after it, from the daemon's own answers.
// moving.mjs FILE
import { writeFileSync } from "node:fs";
import net from "node:net";
import { example, startDaemon } from "./visit.mjs";

const FILLS = { 38: "#abc8e9", 42: "#f4ebb5" };
const MOVES = 36;
const SECONDS = 9;

/** Calls over a line connection, to which a drag session can belong. */
function lines(port) {
  const socket = net.connect(port, "127.0.0.1").setEncoding("utf8");
  const pending = new Map();
  let rest = "";
  let ids = 0;
  socket.on("data", (text) => {
    const whole = (rest + text).split("\n");
    rest = whole.pop();
    for (const { id, result, error } of whole.map((line) => JSON.parse(line))) error ? pending.get(id).reject(new Error(error.message)) : pending.get(id).resolve(result);
  });
  const call = (method, params) => new Promise((resolve, reject) => {
    pending.set(++ids, { resolve, reject });
    socket.write(JSON.stringify({ jsonrpc: "2.0", id: ids, method, params }) + "\n");
  });
  return { call, end: () => socket.end() };
}

/** The positions after each move of the drag, and then after the compaction. */
async function frames(port) {
  const { call, end } = lines(port);
  const { markerId, length } = await call("marker.open", { marker: example("jeans_02g") });
  const { marker } = await call("marker.get", { markerId });
  const start = Object.fromEntries(marker.pieces.map(({ id, at }) => [id, at]));
  const shown = [{ at: { ...start }, length }];
  const take = (placements, now) => shown.push({ at: { ...start, ...Object.fromEntries(placements.map(({ id, at }) => [id, at])) }, length: now });
  const { dragId, at } = await call("drag.begin", { markerId, piece: "12", mode: "push" });
  for (let k = 1; k <= MOVES; ++k) {
    const part = 0.5 - 0.5 * Math.cos((Math.PI * k) / MOVES);
    const answer = await call("drag.move", { dragId, to: [at[0] + 110 * part, at[1] + 30 * Math.sin(Math.PI * part)] });
    take(answer.placements, answer.length);
  }
  await call("drag.end", { dragId, markerId });
  const compacted = await call("motion.compact", { markerId });
  const before = shown.at(-1).at;
  shown.push({ at: { ...before, ...Object.fromEntries(compacted.placements.map(({ id, at: to }) => [id, to])) }, length: compacted.lengthAfter });
  end();
  return { marker, shown };
}

const short = (value) => Math.round(value * 10) / 10;

function picture({ marker, shown }) {
  const { width } = marker.strip;
  const shapes = new Map(marker.shapes.map((shape) => [shape.id, shape]));
  // The drag takes half of the time, the compaction a tenth; in between, and at the end, nothing moves.
  const times = shown.map((_, k) => (k < shown.length - 1 ? 0.06 + (0.44 * k) / (shown.length - 2) : 0.72));
  const keys = [0, ...times.slice(0, -1), 0.62, times.at(-1), 1].map((time) => Math.round(time * 1000) / 1000).join(";");
  const values = (of) => [of(shown[0]), ...shown.slice(0, -1).map(of), of(shown.at(-2)), of(shown.at(-1)), of(shown.at(-1))];
  const animated = (attribute, of, more = "") => {
    const all = values(of);
    return new Set(all).size === 1 ? "" : `<${more ? "animateTransform" : "animate"} attributeName="${attribute}" ${more} dur="${SECONDS}s" repeatCount="indefinite" keyTimes="${keys}" values="${all.join(";")}"/>`;
  };
  const pieces = marker.pieces.map(({ id, shape, rotation = 0, tilt = 0 }) => {
    const { outline, attributes } = shapes.get(shape);
    const at = ({ at: places }) => `${short(places[id][0])} ${short(places[id][1])}`;
    const path = outline.map(([x, y]) => `${short(x)} ${short(y)}`).join("L");
    const edge = id === "12" ? ' stroke="#0b6b48" stroke-width="7"' : "";
    return `<g transform="translate(${at(shown[0])})">${animated("transform", at, 'type="translate"')}<path transform="rotate(${rotation + tilt})" fill="${FILLS[attributes.size]}" d="M${path}Z"${edge}/></g>`;
  });
  const end = ({ length }) => String(short(length));
  const line = `<line y1="-20" y2="${width + 20}" x1="${end(shown[0])}" x2="${end(shown[0])}" stroke="#0b6b48" stroke-width="5" stroke-dasharray="24 14">${animated("x1", end)}${animated("x2", end)}</line>`;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="-30 -30 ${Math.ceil(shown[0].length) + 160} ${width + 60}" width="960">`,
    `<rect x="-30" y="-30" width="100%" height="100%" fill="#f3f4f1"/>`,
    `<g transform="matrix(1 0 0 -1 0 ${width})" stroke="#3c4a40" stroke-width="3"><rect width="${Math.ceil(shown[0].length) + 130}" height="${width}" fill="#fdfdfb" stroke="none"/>`,
    ...pieces,
    line,
    "</g></svg>",
  ].join("\n") + "\n";
}

const daemon = await startDaemon();
writeFileSync(process.argv[2], picture(await frames(daemon.port)));
await daemon.stop();
