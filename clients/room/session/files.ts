import type { MarkerDocument } from "../marker/document";
import { say } from "../texts/texts";
import { decode, type Decoded } from "./encoding";

/** A file to open: a marker document or the text of a trade file; for a pattern also its rule table and an order for it. */
export interface Opened {
  name: string;
  marker: Record<string, unknown> | string;
  rules?: string;
  order?: string;
  /** What the user should know about how these files were read. */
  notes: string[];
}

/**
 * Reads files that the user chose or dropped together. Each is a marker, a pattern or a cut file, except for a rule table (.rul)
 * and an order (.csv), which belong to the other files. Throws the parser's error if a document is not valid JSON.
 */
export async function readFiles(files: readonly File[]): Promise<Opened[]> {
  const ending = (file: File, name: string) => file.name.toLowerCase().endsWith(name);
  const besides = files.length > 1 ? { rules: files.find((file) => ending(file, ".rul")), order: files.find((file) => ending(file, ".csv")) } : {};
  const [readRules, readOrder] = await Promise.all([besides.rules && decodedOf(besides.rules), besides.order && decodedOf(besides.order)]);
  const texts = { ...(readRules && { rules: readRules.text }), ...(readOrder && { order: readOrder.text }) };
  const notesBeside = [...encodingNotes(readRules, besides.rules), ...encodingNotes(readOrder, besides.order)];
  const opened = files.filter((file) => file !== besides.rules && file !== besides.order);
  return Promise.all(
    opened.map(async (file): Promise<Opened> => {
      const decoded = await decodedOf(file);
      const { text } = decoded;
      const notes = encodingNotes(decoded);
      if (!ending(file, ".json") && !text.trimStart().startsWith("{")) return { name: file.name, marker: text, ...texts, notes: [...notes, ...notesBeside] };
      const document: unknown = JSON.parse(text);
      if (typeof document !== "object" || document === null || Array.isArray(document)) throw new Error(`${file.name}: not a marker`);
      return { name: file.name, marker: document as Record<string, unknown>, notes };
    }),
  );
}

async function decodedOf(file: File): Promise<Decoded> {
  return decode(await file.arrayBuffer());
}

// The note that the command line makes; `beside` is a file that was read for another one.
function encodingNotes(decoded: Decoded | undefined, beside?: File): string[] {
  if (decoded?.readAs === undefined) return [];
  const note = say("readAs", { encoding: decoded.readAs });
  return [beside ? `${beside.name}: ${note}` : note];
}

/** Lets the user choose files. */
export function chooseFiles(): Promise<File[]> {
  return new Promise((resolve) => {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = ".json,.dxf,.rul,.csv,.cut,.plt,.hpgl,.svg,.xml,.txt";
    input.multiple = true;
    input.addEventListener("change", () => resolve([...(input.files ?? [])]));
    input.addEventListener("cancel", () => resolve([]));
    input.click();
  });
}

/** Downloads a text as a file. */
export function saveText(name: string, text: string, type: string): void {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** A file name that is valid on every file system. */
export const fileName = (name: string, extension: string): string =>
  `${name.replace(/[^\p{L}\p{N}._ -]+/gu, "_").slice(0, 80) || "marker"}.${extension}`;

export const markerText = (document: MarkerDocument): string => JSON.stringify(document, null, 1) + "\n";
