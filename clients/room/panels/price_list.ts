import { h } from "../base/dom";
import { preferences } from "../base/preferences";
import type { Price } from "../engine/prices";
import { say } from "../texts/texts";
import { lengthText, unitName, unitOf } from "../texts/units";
import type { Scene } from "../view/scene";
import { moneyText } from "./header";

const MOST = 12; // number of rows

/** A table of the price of each rule: the length, and the money in all plies, for each unit by which the rule were relaxed. */
export function drawPrices(prices: readonly Price[], unit: string, scene: Scene): HTMLElement {
  const by = unitOf({ unit });
  const { plies } = preferences.value;
  const rowOf = ({ text, name, way, piece, worth }: Price): HTMLElement => {
    const label = [say(text), way, name].filter((part) => part !== "").join(" ");
    const named = piece === undefined ? label : h("button", { type: "button", class: "link-button", title: label, onclick: () => scene.select([piece]) }, label);
    return h("tr", {}, h("th", { scope: "row" }, named), h("td", {}, lengthText(worth * by, { digits: 2 })), h("td", {}, moneyText(worth * by, plies)));
  };
  const heads = [say("priceRule"), say("pricePer", { unit: `1 ${unitName()}` }), plies > 1 ? say("priceIn", { plies }) : say("perPly")];
  return h(
    "div",
    { id: "prices" },
    h("p", { class: "note" }, say("pricesHelp")),
    h("table", { class: "prices" }, h("thead", {}, h("tr", {}, ...heads.map((head) => h("th", { scope: "col" }, head)))), h("tbody", {}, ...prices.slice(0, MOST).map(rowOf))),
    prices.length > MOST && h("p", { class: "note" }, say("pricesMore", { count: prices.length - MOST })),
  );
}
