import { fill, h } from "../base/dom";
import { prefer, preferences } from "../base/preferences";
import { follow } from "../base/signal";
import { smallestOf } from "../engine/fits";
import type { Insight } from "../engine/insight";
import { pricesOf } from "../engine/prices";
import type { Desk } from "../session/desk";
import { say, wording } from "../texts/texts";
import { areaText, lengthText, numberText, parseNumber } from "../texts/units";
import type { Scene } from "../view/scene";
import { moneyText } from "./header";
import { heading, note, row } from "./controls";
import { drawPrices } from "./price_list";

/** The panel that shows what determines the length, what each rule costs, the free cloth, and the cost of the cloth. */
export function buildLengthPanel(host: HTMLElement, desk: Desk, scene: Scene, insight: Insight): void {
  const why = h("div", { id: "why" });
  const cloth = h("div", { id: "cloth" });
  const money = h("div", { id: "money" });
  const number = (value: number, take: (value: number) => void) => {
    const field = h("input", { type: "text", inputmode: "decimal", size: 6, value: String(value), onchange: () => {
      const typed = parseNumber(field.value);
      if (typed !== undefined && typed >= 0) take(typed);
    } });
    return field;
  };
  const currency: HTMLInputElement = h("input", { type: "text", size: 4, maxlength: 6, value: preferences.value.currency, onchange: () => prefer({ currency: currency.value.slice(0, 6) }) });
  const toggle = (signal: Insight["chainShown"], name: "showChain" | "showRegions") => {
    const box: HTMLInputElement = h("input", { type: "checkbox", onchange: () => (signal.value = box.checked) });
    signal.follow((on) => (box.checked = on));
    return row(name, box);
  };
  fill(
    host,
    heading("whyLength"),
    note("chainHelp"),
    toggle(insight.chainShown, "showChain"),
    why,
    heading("freeCloth"),
    toggle(insight.regionsShown, "showRegions"),
    cloth,
    heading("money"),
    row("price", number(preferences.value.price, (price) => prefer({ price }))),
    row("plies", number(preferences.value.plies, (plies) => prefer({ plies: Math.round(plies) }))),
    row("currency", currency),
    money,
  );
  follow([insight.chain, desk.figures, wording], () => drawWhy(why, desk, scene, insight));
  follow([insight.regions, insight.fits, insight.regionsShown, wording], () => drawCloth(cloth, desk, insight));
  follow([desk.figures, wording, preferences], () => {
    const { length } = desk.figures.value;
    const saved = (desk.opening?.figures.length ?? length) - length;
    const { plies } = preferences.value;
    const line = (name: string, value: string) => [h("dt", {}, name), h("dd", {}, value)];
    fill(money, h("dl", { class: "facts" }, ...line(say("perPly"), moneyText(length)), ...line(say("gain"), moneyText(saved, plies) && say("inPlies", { money: moneyText(saved, plies), plies }))));
  });
}

function drawWhy(host: HTMLElement, desk: Desk, scene: Scene, insight: Insight): void {
  const chain = insight.chain.value;
  const marker = desk.marker.value;
  if (!chain || !marker) return fill(host);
  const loaded = chain.contacts.filter(({ worth }) => worth >= 0.004);
  const tilts = chain.tilts.filter(({ piece }) => (marker.byId.get(piece)?.shape.tiltLimit ?? 0) > 0).slice(0, 6);
  const rows = tilts.map(({ piece, perDegree }) => {
    const name = marker.byId.get(piece)?.shape.name ?? piece;
    const turn = perDegree > 0 ? "↺" : "↻";
    return h("button", { type: "button", class: "line-button", onclick: () => scene.select([piece]) }, h("span", {}, name), h("span", { class: "option-detail" }, `${turn} 1°: −${lengthText(Math.abs(perDegree))}`));
  });
  fill(host, h("p", { class: "note" }, say("chainOf", { count: numberText(loaded.length, 0) })), drawPrices(pricesOf(chain, marker), marker.unit, scene), rows.length > 0 && h("p", { class: "note" }, say("bestTilts")), ...rows);
}

function drawCloth(host: HTMLElement, desk: Desk, insight: Insight): void {
  const regions = insight.regions.value?.regions;
  const marker = desk.marker.value;
  if (!regions || !marker || !insight.regionsShown.value) return fill(host);
  const piece = smallestOf(marker)?.shape.label ?? "–";
  const area = areaText(regions.reduce((sum, region) => sum + region.area, 0));
  const fits = insight.fits.value.size;
  fill(host, h("p", { class: "note" }, say("freeSummary", { count: numberText(regions.length, 0), area, piece, fits: numberText(fits, 0) })));
}
