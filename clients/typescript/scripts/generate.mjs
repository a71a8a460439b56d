// The types of all calls, made of what the daemon tells about itself: node scripts/generate.mjs SELVAGED > src/methods.ts
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

/** The OpenRPC document of this program. */
export function discover(selvaged) {
  const folder = mkdtempSync(join(tmpdir(), "selvage-"));
  try {
    const file = join(folder, "discover.json");
    writeFileSync(file, JSON.stringify({ jsonrpc: "2.0", id: 1, method: "rpc.discover" }));
    return JSON.parse(execFileSync(selvaged, ["--check", file, "--log-level", "off"], { encoding: "utf8" })).result;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** A JSON Schema as a type expression. */
function type(schema) {
  if (schema.$ref) return schema.$ref.split("/").pop();
  if (schema.allOf) return type(schema.allOf[0]);
  if (schema.anyOf) return schema.anyOf.map(type).join(" | ");
  if (schema.enum) return schema.enum.map((word) => JSON.stringify(word)).join(" | ");
  if ("const" in schema) return JSON.stringify(schema.const);
  if (schema.type === "array") {
    const one = type(schema.items);
    return schema.maxItems === 2 ? `[${one}, ${one}]` : `Array<${one}>`;
  }
  if (schema.type === "object") return schema.properties ? object(fieldsOf(schema), "  ") : "Record<string, unknown>";
  return schema.type === "integer" ? "number" : schema.type;
}

const fieldsOf = (schema) =>
  Object.entries(schema.properties).map(([name, field]) => ({
    name,
    description: field.description,
    required: schema.required.includes(name),
    schema: field,
  }));

function object(fields, indent) {
  if (fields.length === 0) return "Record<string, never>";
  const key = (name) => (/^\w+$/.test(name) ? name : JSON.stringify(name));
  const lines = fields.map(
    (field) =>
      `${indent}  /** ${field.description} */\n${indent}  ${key(field.name)}${field.required ? "" : "?"}: ${type(field.schema)};\n`,
  );
  return `{\n${lines.join("")}${indent}}`;
}

/** The text of src/methods.ts. */
export function generate(document) {
  const types = Object.entries(document.components.schemas).map(([name, schema]) => {
    const body = schema.properties ? object(fieldsOf(schema), "") : type(schema);
    return `/** ${schema.description} */\nexport type ${name} = ${body};\n`;
  });
  const methods = document.methods.map(
    (method) =>
      `  /** ${method.summary} */\n  ${JSON.stringify(method.name)}: {\n    params: ${object(method.params, "    ")};\n` +
      `    result: ${object(fieldsOf(method.result.schema), "    ")};\n  };\n`,
  );
  const notifications = document["x-notifications"].map(
    (told) => `  /** ${told.summary} */\n  ${JSON.stringify(told.name)}: ${object(told.params, "  ")};\n`,
  );
  const taking = (param) =>
    document.methods
      .filter((method) => method.params.some(({ name }) => name === param))
      .map(({ name }) => `  ${JSON.stringify(name)},\n`)
      .join("");
  return [
    "// Made by scripts/generate.mjs of the daemon's own description; do not edit.\n",
    ...types,
    `/** Every method: what it takes and what it answers. */\nexport interface Methods {\n${methods.join("")}}\n`,
    `/** What the daemon sends unasked. */\nexport interface Notifications {\n${notifications.join("")}}\n`,
    `/** Methods that take an opId: a retry does nothing twice. */\nexport const retriable: ReadonlySet<string> = new Set([\n${taking("opId")}]);\n`,
  ].join("\n");
}

if (process.argv[1] === fileURLToPath(import.meta.url)) process.stdout.write(generate(discover(process.argv[2])));
