import { fill, h, setText } from "../base/dom";
import { follow, Signal } from "../base/signal";
import type { Desk } from "../session/desk";
import { say, wording } from "../texts/texts";
import { lengthText, numberText, percentText } from "../texts/units";

/** The line at the bottom: the connection, the revision, the number of pieces, and a warning if the daemon does not save markers. */
export function buildStatus(host: HTMLElement, desk: Desk, keepsNothing: Signal<boolean>, legend: HTMLElement): void {
  const { link } = desk;
  const dot = h("span", { class: "dot" });
  const state = h("span", { id: "link-state" });
  const marker = h("span");
  const warning = h("span", { class: "warning", id: "keeps-nothing" });
  fill(host, h("span", { class: "link" }, dot, state), marker, warning, legend);
  follow([link.state, wording], () => {
    const { value } = link.state;
    host.dataset["state"] = value;
    const text = link.alone && value !== "connecting" ? "inThisPage" : value === "open" ? "connected" : value === "token" ? "connecting" : value;
    setText(state, say(text));
  });
  follow([desk.marker, desk.figures, wording], () => {
    const { value } = desk.marker;
    if (!value) return;
    const width = `${say("width")} ${lengthText(value.width)}`;
    setText(marker, `${say("countedPieces", { count: numberText(value.pieces.filter(({ rules }) => !rules.zone).length, 0) })} · ${width} · ${say("revisionIs", { revision: desk.figures.value.revision })}`);
  });
  follow([keepsNothing, wording], () => {
    warning.hidden = !keepsNothing.value;
    setText(warning, say(link.alone ? "keptInPage" : "inMemory"));
  });
}

/** Shows short messages over the canvas, which disappear by themselves. */
export function messageDisplay(host: HTMLElement): (text: string) => void {
  let timer = 0;
  return (text) => {
    setText(host, text);
    host.dataset["shown"] = "yes";
    clearTimeout(timer);
    timer = window.setTimeout(() => (host.dataset["shown"] = ""), 2500 + text.length * 45);
  };
}

/** Announces the figures to assistive technology once they have stopped changing. */
export function announceFigures(live: HTMLElement, desk: Desk): void {
  let timer = 0;
  desk.figures.follow(({ revision, length, utilisation }) => {
    if (revision === 0) return;
    clearTimeout(timer);
    timer = window.setTimeout(() => setText(live, say("announce", { length: lengthText(length), utilisation: percentText(utilisation) })), 700);
  });
}
