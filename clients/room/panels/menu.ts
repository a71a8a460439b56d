import { h } from "../base/dom";
import type { Desk } from "../session/desk";
import { examples, type Example } from "../session/examples";
import type { Library } from "../session/library";
import type { WRITTEN } from "../session/marker_files";
import { say, type TextName } from "../texts/texts";
import { lengthText, percentText } from "../texts/units";

export interface MarkerActions {
  openFile(): void;
  save(): void;
  saveAs(format: keyof typeof WRITTEN): void;
  print(): void;
  duplicate(): void;
  close(): void;
  show(markerId: string): void;
  example(example: Example): void;
}

const entry = (text: string, act: () => void, detail = "", current = false) =>
  h("button", { type: "button", role: "menuitem", class: "menu-entry", "aria-current": current ? "true" : null, onclick: act }, h("span", {}, text), h("span", { class: "menu-detail" }, detail));

/** The menu of markers and files, under the marker's name. */
export async function openMenu(from: HTMLElement, desk: Desk, library: Library, actions: MarkerActions): Promise<void> {
  document.querySelector("#marker-menu")?.remove();
  const close = () => {
    menu.remove();
    from.setAttribute("aria-expanded", "false");
    removeEventListener("pointerdown", outside, true);
  };
  const outside = (event: Event) => {
    if (!menu.contains(event.target as Node)) close();
  };
  const doing = (act: () => void) => () => {
    close();
    act();
  };
  const plain = (name: TextName, act: () => void) => entry(say(name), doing(act));
  const open = h("div", { class: "menu-group" });
  const stored = h("div", { class: "menu-group" });
  const tried = h("div", { class: "menu-group" });
  const menu = h(
    "div",
    { id: "marker-menu", role: "menu", class: "menu" },
    h("div", { class: "menu-group" }, plain("openFile", actions.openFile), plain("saveFile", actions.save), plain("saveSvg", () => actions.saveAs("svg")), plain("savePdf", () => actions.saveAs("pdf")), plain("saveDxf", () => actions.saveAs("dxf")), plain("saveCut", () => actions.saveAs("cut")), plain("saveHpgl", () => actions.saveAs("hpgl")), plain("print", actions.print), plain("duplicate", actions.duplicate), plain("storeMarker", library.store), plain("closeMarker", actions.close)),
    open,
    stored,
    tried,
  );
  menu.addEventListener("keydown", (event) => {
    const entries = [...menu.querySelectorAll<HTMLElement>("[role=menuitem]")];
    const at = entries.indexOf(document.activeElement as HTMLElement);
    if (event.key === "Escape") {
      close();
      from.focus();
    } else if (event.key === "ArrowDown") entries[(at + 1) % entries.length]?.focus();
    else if (event.key === "ArrowUp") entries[(at + entries.length - 1) % entries.length]?.focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  from.after(menu);
  from.setAttribute("aria-expanded", "true");
  menu.querySelector<HTMLElement>("[role=menuitem]")?.focus();
  addEventListener("pointerdown", outside, true);
  const client = await desk.link.ready();
  const [{ markers }, kept, known] = await Promise.all([client.call("marker.list", {}), library.newest(), examples()]);
  const detailOf = ({ pieces, length, utilisation }: { pieces: number; length: number; utilisation: number }) => `${pieces} · ${lengthText(length)} · ${percentText(utilisation, 1)}`;
  open.append(h("div", { class: "menu-title" }, say(desk.link.alone ? "inPage" : "onDaemon")));
  for (const one of markers.slice(0, 40)) {
    open.append(entry(one.name || one.markerId, doing(() => actions.show(one.markerId)), detailOf(one), one.markerId === desk.markerId));
  }
  if (kept.length > 0) stored.append(h("div", { class: "menu-title" }, say("inLibrary", { count: library.count.value })));
  for (const one of kept) stored.append(entry(one.name || one.id, doing(() => library.open(one.id)), detailOf(one)));
  tried.append(h("div", { class: "menu-title" }, say("exampleMarkers")));
  for (const one of known) tried.append(entry(one.name, doing(() => actions.example(one))));
}
