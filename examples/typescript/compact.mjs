// Shortens a marker: selvaged & node compact.mjs MARKER.json [PORT]
import { readFileSync } from "node:fs";
import { Client } from "selvage-client";
import { overLines } from "selvage-client/lines";

const [file, port = "7171"] = process.argv.slice(2);
const client = await Client.open(overLines({ host: "127.0.0.1", port: Number(port) }));
const { markerId } = await client.call("marker.open", { marker: JSON.parse(readFileSync(file, "utf8")) });
const run = client.start("motion.compact", { markerId });
for await (const { round, length } of run.progress) console.log(`round ${round}: ${length}`);
const { lengthBefore, lengthAfter, valid } = await run.result;
console.log(`${lengthBefore} -> ${lengthAfter}, valid: ${valid}`);
client.close();
