import { fill, h, setText } from "../base/dom";
import { preferences } from "../base/preferences";
import { follow } from "../base/signal";
import type { Engine } from "../engine/engine";
import type { Commands } from "../input/commands";
import type { Desk } from "../session/desk";
import { say, wording, type TextName } from "../texts/texts";
import { lengthText, metres, numberText, percentText } from "../texts/units";
import { iconButton, worded } from "./controls";
import { drawn } from "./icons";

function figure(name: TextName, id: string): { box: HTMLElement; value: HTMLElement; side: HTMLElement } {
  const label = h("span", { class: "figure-name" });
  worded(label, name);
  const value = h("span", { class: "figure-value", id });
  const side = h("span", { class: "figure-side" });
  return { box: h("div", { class: "figure" }, label, h("span", { class: "figure-line" }, value, side)), value, side };
}

/** The cost of a length of cloth, in one ply or in all plies. */
export function moneyText(length: number, plies = 1): string {
  const { price, currency } = preferences.value;
  const cloth = metres(length);
  return cloth === undefined || price === 0 ? "" : `${numberText(cloth * price * plies, 2)} ${currency}`.trim();
}

/** The upper bar: the marker's name, undo and redo, and the figures that are always visible. */
export function buildHeader(host: HTMLElement, desk: Desk, engine: Engine, commands: Commands, actions: { menu(from: HTMLElement): void; settings(): void; help(): void }): void {
  const name = h("span", { id: "marker-name" });
  const menu: HTMLButtonElement = h("button", { type: "button", class: "marker-button", id: "menu", "aria-haspopup": "menu", onclick: () => actions.menu(menu) }, name, drawn("down"));
  worded(menu, "markers", "title");
  const undo = iconButton("undo", "undo", () => void commands.undo());
  const redo = iconButton("redo", "redo", () => void commands.redo());
  const length = figure("length", "length");
  const use = figure("utilisation", "utilisation");
  const gain = figure("gain", "gain");
  const right = h("div", { class: "header-right" }, iconButton("settings", "settings", actions.settings), iconButton("help", "help", actions.help));
  const brand = h("h1", { class: "brand" }, "Selvage");
  fill(host, brand, menu, undo, redo, h("div", { class: "figures" }, length.box, use.box, gain.box), right);

  follow([desk.figures, desk.marker, engine.preview, wording], () => {
    const { marker, figures, opening } = desk;
    const seen = engine.preview.value ?? figures.value;
    setText(name, marker.value?.name || desk.markerId || "…");
    document.title = marker.value?.name ? `${marker.value.name} · Selvage` : "Selvage";
    if (!marker.value) return;
    host.dataset["preview"] = engine.preview.value ? "yes" : "";
    setText(length.value, lengthText(seen.length));
    setText(length.side, figures.value.valid ? "" : say("notValid"));
    setText(use.value, percentText(seen.utilisation));
    // The lengths of markers with different numbers of pieces cannot be compared.
    const alike = opening?.poses.size === (engine.preview.value?.poses.size ?? marker.value.pieces.length);
    const saved = opening && alike ? opening.figures.length - seen.length : 0;
    setText(gain.value, !alike ? "–" : `${saved > 0 ? "−" : saved < 0 ? "+" : ""}${lengthText(Math.abs(saved))}`);
    gain.box.dataset["sign"] = saved > 1e-9 ? "gain" : saved < -1e-9 ? "loss" : "";
    const money = Math.abs(saved) > 1e-9 ? moneyText(Math.abs(saved), preferences.value.plies) : "";
    setText(gain.side, money && say("inPlies", { money, plies: preferences.value.plies }));
  });
}
