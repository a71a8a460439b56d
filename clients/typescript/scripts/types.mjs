// Turns the JSON Schemas in the daemon's description into TypeScript types.

const open = "Record<string, unknown>";
export const nameOf = (schema) => schema.$ref.split("/").pop();
const isObject = (schema) => schema.properties !== undefined;
const comment = (text, indent) => (text ? `${indent}/** ${text} */\n` : "");

/** The type expression of a schema. */
export function type(schema, indent = "") {
  const one = (each) => type(each, indent);
  if (schema.$ref) return nameOf(schema);
  if (schema.allOf) return one(schema.allOf[0]);
  if (isObject(schema)) return object(fieldsOf(schema), indent);
  const alternatives = schema.anyOf ?? schema.oneOf ?? (Array.isArray(schema.type) ? schema.type.map((type) => ({ type })) : undefined);
  if (alternatives) return alternatives.map(one).join(" | ");
  if (schema.enum) return schema.enum.map((word) => JSON.stringify(word)).join(" | ");
  if ("const" in schema) return JSON.stringify(schema.const);
  if (schema.type === "array") {
    const isPair = schema.minItems === 2 && schema.maxItems === 2;
    return isPair ? `[${one(schema.items)}, ${one(schema.items)}]` : `Array<${one(schema.items)}>`;
  }
  return { object: open, integer: "number" }[schema.type] ?? schema.type;
}

/** The fields of an object schema, in the form in which OpenRPC lists the parameters of a method. */
export const fieldsOf = (schema) =>
  Object.entries(schema.properties).map(([name, field]) => ({
    name,
    description: field.description,
    required: (schema.required ?? []).includes(name),
    schema: field,
  }));

export function object(fields, indent) {
  if (fields.length === 0) return "Record<string, never>";
  const inner = `${indent}  `;
  const key = (name) => (/^\w+$/.test(name) ? name : JSON.stringify(name));
  const lines = fields.map(
    ({ name, description, required, schema }) =>
      `${comment(description, inner)}${inner}${key(name)}${required ? "" : "?"}: ${type(schema, inner)};\n`,
  );
  return `{\n${lines.join("")}${indent}}`;
}

/** The declaration of a named type. */
export const declaration = (name, schema) => `${comment(schema.description, "")}export type ${name} = ${type(schema)};\n`;

/** The names of all types that a part of the description refers to. */
export function references(part) {
  if (typeof part !== "object" || part === null) return [];
  const inner = Object.values(part).flatMap(references);
  return typeof part.$ref === "string" && part.$ref.startsWith("#/components/schemas/") ? [nameOf(part), ...inner] : inner;
}
