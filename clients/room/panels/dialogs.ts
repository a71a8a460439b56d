import { fill, h } from "../base/dom";
import { prefer, preferences } from "../base/preferences";
import type { Link } from "../session/link";
import { say, type TextName } from "../texts/texts";
import { choice, row, textButton, worded } from "./controls";

function dialog(title: TextName, ...body: HTMLElement[]): HTMLDialogElement {
  const heading = h("h2", { id: "dialog-title" });
  worded(heading, title);
  const element = h("dialog", { "aria-labelledby": "dialog-title" }, heading, ...body);
  element.addEventListener("close", () => element.remove());
  element.addEventListener("click", (event) => event.target === element && element.close());
  document.body.append(element);
  element.showModal();
  return element;
}

export function openSettings(): void {
  const { language, unit, decimal, theme, colourBy } = preferences.value;
  const check = (name: "middle" | "labels") => {
    const box: HTMLInputElement = h("input", { type: "checkbox", onchange: () => prefer({ [name]: box.checked }) });
    box.checked = preferences.value[name];
    return box;
  };
  const languages: HTMLSelectElement = h("select", { onchange: () => prefer({ language: languages.value as "en" | "de" }) }, h("option", { value: "en", lang: "en" }, "English"), h("option", { value: "de", lang: "de" }, "Deutsch"));
  languages.value = language;
  const units: HTMLSelectElement = h("select", { onchange: () => prefer({ unit: units.value as typeof unit }) }, ...["mm", "cm", "in", "yd"].map((name) => h("option", { value: name }, name)));
  units.value = unit;
  const close = textButton("done", () => opened.close(), "primary");
  const opened = dialog(
    "settings",
    row("language", languages),
    row("unit", units),
    row("decimal", choice([["auto", "decimalAuto"], ["point", "decimalPoint"], ["comma", "decimalComma"]], decimal, (chosen) => prefer({ decimal: chosen }))),
    row("theme", choice([["system", "themeSystem"], ["light", "themeLight"], ["dark", "themeDark"]], theme, (chosen) => prefer({ theme: chosen }))),
    row("colourBy", choice([["size", "bySize"], ["bundle", "byBundle"], ["shape", "byShape"], ["none", "byNone"]], colourBy, (chosen) => prefer({ colourBy: chosen }))),
    row("labels", check("labels")),
    row("middle", check("middle")),
    h("div", { class: "buttons end" }, close),
  );
}

const KEYS: TextName[] = ["keysDrag", "keysShiftDrag", "keysBand", "keysPan", "keysWheel", "keysTilt", "keysBump", "keysNudge", "keysShoot", "keysTurn", "keysLock", "keysTakeOff", "keysUndo", "keysEngine", "keysViews", "keysTab"];

export function openHelp(): void {
  const lines = KEYS.map((name) => {
    const [keys, ...does] = say(name).split(": ");
    return h("div", { class: "key-line" }, h("span", { class: "key-names" }, keys ?? ""), h("span", {}, does.join(": ")));
  });
  const close = textButton("done", () => opened.close(), "primary");
  const opened = dialog("help", h("div", { class: "keys" }, ...lines), h("div", { class: "buttons end" }, close));
}

/** Shows a dialogue for the token while the daemon requires one. */
export function askForToken(link: Link): void {
  let opened: HTMLDialogElement | undefined;
  let tried = false;
  link.state.follow((state) => {
    if (state !== "token") {
      if (state === "open") opened?.close();
      return;
    }
    opened?.close();
    const field = h("input", { type: "password", autocomplete: "current-password", id: "token", size: 32 });
    worded(field, "tokenTitle", "aria-label");
    const wrong = h("p", { class: "note fault" });
    if (tried) fill(wrong, say("tokenWrong"));
    const help = h("p", { class: "note" });
    worded(help, "tokenHelp");
    const form = h("form", { onsubmit: (event: Event) => {
      event.preventDefault();
      tried = true;
      link.giveToken(field.value);
    } }, field, wrong, h("div", { class: "buttons end" }, h("button", { type: "submit", class: "button primary" }, say("enter"))));
    opened = dialog("tokenTitle", help, form);
    opened.addEventListener("cancel", (event) => event.preventDefault());
    field.focus();
  });
}
