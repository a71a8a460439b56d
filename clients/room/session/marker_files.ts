import { putInAddress } from "./address";
import type { Desk } from "./desk";
import { example, examples, type Example } from "./examples";
import { chooseFiles, fileName, markerText, readFiles, saveText } from "./files";
import { errorText } from "./messages";
import { say } from "../texts/texts";

/** The formats in which markers can be saved; all of them are text. */
export const WRITTEN = {
  svg: { ending: "svg", type: "image/svg+xml" },
  pdf: { ending: "pdf", type: "application/pdf" },
  dxf: { ending: "dxf", type: "image/vnd.dxf" },
  cut: { ending: "cut", type: "text/plain" },
  hpgl: { ending: "plt", type: "application/vnd.hp-HPGL" },
} as const;

/** Opens markers from files chosen in a dialogue or dropped on the page, and saves and prints markers. */
export class MarkerFiles {
  constructor(
    private readonly desk: Desk,
    private readonly showMessage: (text: string) => void,
    private readonly dropzone: HTMLElement,
  ) {
    addEventListener("dragover", (event) => {
      event.preventDefault();
      dropzone.textContent = say("dropFiles");
      dropzone.hidden = false;
    });
    addEventListener("dragleave", (event) => event.relatedTarget === null && (this.dropzone.hidden = true));
    addEventListener("drop", (event) => {
      event.preventDefault();
      this.dropzone.hidden = true;
      void this.openAll([...(event.dataTransfer?.files ?? [])]);
    });
  }

  /** Shows the marker named in the address, or the first open one, or else an example, so that there always is a marker. */
  async openFirst(markerId: string): Promise<void> {
    const client = await this.desk.link.ready();
    const { markers } = await client.call("marker.list", {});
    const named = markers.find((marker) => marker.markerId === markerId);
    const shown = named ?? markers[0];
    const [first] = shown ? [] : await examples();
    if (shown) await this.trying(() => this.desk.show(shown.markerId));
    else if (first) await this.trying(async () => void (await this.desk.open(await example(first.file))));
    if (markerId && !named) this.showMessage(say("linkGone", { marker: markerId }));
  }

  /** Shows the marker that the user has put into the address; if it is not open, says so and keeps what is shown. */
  async openNamed(markerId: string): Promise<void> {
    putInAddress(this.desk.markerId); // until the marker is shown
    if (!markerId || markerId === this.desk.markerId) return;
    const client = await this.desk.link.ready();
    const { markers } = await client.call("marker.list", {});
    if (markers.some((marker) => marker.markerId === markerId)) await this.trying(() => this.desk.show(markerId));
    else this.showMessage(say("linkGone", { marker: markerId }));
  }

  openFile = (): void => void chooseFiles().then((files) => this.openAll(files));

  private async openAll(files: File[]): Promise<void> {
    await this.trying(async () => {
      for (const { name, marker, notes: ofFiles, ...besides } of await readFiles(files)) {
        const { pieces, unplaced = 0, notes } = await this.desk.open(marker, besides);
        const all = [...ofFiles, ...notes.map(({ text }) => text)];
        const [first] = all;
        const values = { name, pieces: pieces + unplaced, count: all.length, note: first ?? "" };
        this.showMessage(say(first === undefined ? "opened" : "openedNotes", values));
      }
    });
  }

  show = (markerId: string): void => void this.trying(() => this.desk.show(markerId));
  example = ({ file }: Example): void => void this.trying(async () => void (await this.desk.open(await example(file))));

  duplicate = (): void =>
    void this.trying(async () => {
      const document = this.desk.marker.value?.toDocument();
      if (document) await this.desk.open({ ...document, name: `${document.name ?? ""} 2`.trim() });
    });

  save = (): void => {
    const marker = this.desk.marker.value;
    if (marker) saveText(fileName(marker.name, "json"), markerText(marker.toDocument()), "application/json");
  };

  /** Saves the marker in a format that the daemon writes for printers, cutters, plotters and other programs. */
  saveAs = (format: keyof typeof WRITTEN): void =>
    void this.trying(async () => {
      const { ending, type } = WRITTEN[format];
      const name = fileName(this.desk.marker.value?.name ?? "", ending);
      const { marker, notes = [] } = await this.written(format);
      saveText(name, String(marker), type);
      const [first] = notes;
      if (first) this.showMessage(say("savedNotes", { name, count: notes.length, note: first.text }));
    });

  private async written(format: keyof typeof WRITTEN) {
    const client = await this.desk.link.ready();
    return client.call("marker.get", { markerId: this.desk.markerId, format });
  }

  print = (): void =>
    void this.trying(async () => {
      const url = URL.createObjectURL(new Blob([String((await this.written("svg")).marker)], { type: "image/svg+xml" }));
      const picture = document.createElement("img");
      picture.id = "print";
      picture.alt = this.desk.marker.value?.name ?? "";
      picture.src = url;
      document.body.append(picture);
      await picture.decode();
      print();
      picture.remove();
      URL.revokeObjectURL(url);
    });

  close = (): void =>
    void this.trying(async () => {
      const client = await this.desk.link.ready();
      await client.call("marker.close", { markerId: this.desk.markerId });
      this.desk.markerId = "";
      await this.openFirst("");
    });

  private async trying(act: () => Promise<void>): Promise<void> {
    try {
      await act();
    } catch (error) {
      this.showMessage(errorText(error));
    }
  }
}
