import { h } from "../base/dom";
import { Signal } from "../base/signal";
import { say, wording, type TextName } from "../texts/texts";

/** Tabs, with arrow keys to move between them. Returns the panels, and a signal with the name of the open one. */
export function buildTabs<T extends TextName>(host: HTMLElement, names: readonly T[]): { open: Signal<T>; panels: Record<T, HTMLElement> } {
  const open = new Signal<T>(names[0]!);
  const list = h("div", { role: "tablist", class: "tabs" });
  host.append(list);
  const panels = {} as Record<T, HTMLElement>;
  const buttons = names.map((name) => {
    const button = h("button", { type: "button", role: "tab", id: `tab-${name}`, "aria-controls": `panel-${name}`, onclick: () => (open.value = name) });
    const panel = h("div", { role: "tabpanel", id: `panel-${name}`, "aria-labelledby": `tab-${name}`, class: "tab-panel" });
    wording.follow(() => (button.textContent = say(name)));
    open.follow((current) => {
      button.setAttribute("aria-selected", String(current === name));
      button.tabIndex = current === name ? 0 : -1;
      panel.hidden = current !== name;
    });
    panels[name] = panel;
    list.append(button);
    host.append(panel);
    return button;
  });
  list.addEventListener("keydown", (event) => {
    const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (step === 0) return;
    const next = (names.indexOf(open.value) + step + names.length) % names.length;
    open.value = names[next]!;
    buttons[next]!.focus();
    event.preventDefault();
    event.stopPropagation();
  });
  return { open, panels };
}
