import type { MarkerDocument } from "../marker/document";

/** Reads a file that the user chose or dropped. Throws the parser's own words when it is not JSON. */
export async function readMarker(file: File): Promise<Record<string, unknown>> {
  const document: unknown = JSON.parse(await file.text());
  if (typeof document !== "object" || document === null || Array.isArray(document)) throw new Error(`${file.name}: not a marker`);
  return document as Record<string, unknown>;
}

/** Lets the user choose files. */
export function chooseFiles(): Promise<File[]> {
  return new Promise((resolve) => {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = ".json,application/json";
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

/** A name that every file system takes. */
export const fileName = (name: string, extension: string): string =>
  `${name.replace(/[^\p{L}\p{N}._ -]+/gu, "_").slice(0, 80) || "marker"}.${extension}`;

export const markerText = (document: MarkerDocument): string => JSON.stringify(document, null, 1) + "\n";
