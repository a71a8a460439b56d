import { fill, h } from "../../base/dom";
import { follow, Signal } from "../../base/signal";
import type { Insight } from "../../engine/insight";
import type { Piece } from "../../marker/marker";
import type { Desk } from "../../session/desk";
import { say, wording } from "../../texts/texts";
import { areaText, lengthText, numberText } from "../../texts/units";
import { palette } from "../../view/palette";
import type { Scene } from "../../view/scene";
import type { Stage } from "../../view/stage";
import { choice, row, worded } from "../controls";

const ROW = 28; // pixels, as in the style sheet

type Order = "order" | "name" | "area" | "worth";

/**
 * The pieces as a listbox, which makes the marker accessible without the canvas. Only the visible rows are in the document, so
 * that a list of 20,000 pieces costs no more than one of 20.
 */
export function buildPieceList(host: HTMLElement, desk: Desk, scene: Scene, stage: Stage, insight: Insight): void {
  const order = new Signal<Order>("order");
  const list = h("div", { id: "pieces", role: "listbox", tabindex: 0, "aria-multiselectable": "true", class: "list" });
  worded(list, "listLabel", "aria-label");
  const sized = h("div", { class: "list-size" });
  list.append(sized);
  let sorted: Piece[] = [];
  let at = 0;
  const sorting = choice([["order", "sortOrder"], ["name", "sortName"], ["area", "sortArea"], ["worth", "sortWorth"]], "order", (chosen: Order) => (order.value = chosen));
  worded(sorting, "worthHelp", "title");
  host.append(row("sortBy", sorting), list);

  const sort = () => {
    const worth = insight.worth.value;
    const compare: Record<Order, (a: Piece, b: Piece) => number> = {
      order: (a, b) => a.index - b.index,
      name: (a, b) => a.shape.name.localeCompare(b.shape.name, undefined, { numeric: true }) || a.index - b.index,
      area: (a, b) => b.shape.area - a.shape.area || a.index - b.index,
      worth: (a, b) => (worth.get(b.id) ?? 0) - (worth.get(a.id) ?? 0) || a.index - b.index,
    };
    sorted = [...(desk.marker.value?.pieces ?? [])].sort(compare[order.value]);
    sized.style.height = `${sorted.length * ROW}px`;
    draw();
  };
  const draw = () => {
    const first = Math.max(0, Math.floor(list.scrollTop / ROW) - 4);
    const last = Math.min(sorted.length, first + Math.ceil((list.clientHeight || 400) / ROW) + 8);
    fill(sized, ...sorted.slice(first, last).map((piece, k) => rowOf(piece, first + k)));
    const current = sorted[at];
    if (current && at >= first && at < last) list.setAttribute("aria-activedescendant", `piece-${at}`);
    else list.removeAttribute("aria-activedescendant");
  };
  const rowOf = (piece: Piece, k: number): HTMLElement => {
    const { shape, pose } = piece;
    const swatch = h("span", { class: "swatch" });
    if (palette.value) swatch.style.background = scene.colouring.value.fillOf(piece, palette.value);
    const worth = insight.worth.value.get(piece.id) ?? 0;
    const detail = order.value === "area" ? areaText(shape.area) : order.value === "worth" ? numberText(worth, 2) : shape.size;
    const label = say("listRow", { name: shape.name, size: shape.size || "–", x: lengthText(pose.x), y: lengthText(pose.y) });
    const element = h("div", { role: "option", id: `piece-${k}`, class: k === at ? "option at" : "option", "aria-selected": String(scene.selection.value.has(piece.id)), "aria-setsize": sorted.length, "aria-posinset": k + 1, "aria-label": label, onclick: (event: MouseEvent) => pick(k, event.ctrlKey || event.metaKey) }, swatch, h("span", { class: "option-name" }, shape.name), h("span", { class: "option-detail" }, detail));
    element.style.top = `${k * ROW}px`;
    return element;
  };
  const pick = (k: number, adding: boolean) => {
    at = Math.max(0, Math.min(sorted.length - 1, k));
    const piece = sorted[at];
    if (!piece) return;
    const rest = new Set(adding ? scene.selection.value : []);
    adding && rest.has(piece.id) ? rest.delete(piece.id) : rest.add(piece.id);
    picking = true;
    scene.select(rest);
    picking = false;
    reveal();
  };
  // Adds all rows up to this one to the selection.
  const extend = (k: number) => {
    const to = Math.max(0, Math.min(sorted.length - 1, k));
    const added = sorted.slice(Math.min(at, to), Math.max(at, to) + 1).map(({ id }) => id);
    at = to;
    picking = true;
    scene.select([...scene.selection.value, ...added]);
    picking = false;
    reveal();
  };
  let picking = false;
  const reveal = () => {
    if (at * ROW < list.scrollTop) list.scrollTop = at * ROW;
    else if ((at + 1) * ROW > list.scrollTop + list.clientHeight) list.scrollTop = (at + 1) * ROW - list.clientHeight;
    draw();
  };
  list.addEventListener("scroll", draw);
  list.addEventListener("keydown", (event) => {
    const steps: Record<string, number> = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10, Home: -sorted.length, End: sorted.length };
    const step = steps[event.key];
    if (step !== undefined) event.shiftKey ? extend(at + step) : pick(at + step, false);
    else if (event.key === " " && event.ctrlKey) pick(at, true);
    else if (event.key === "Enter" || event.key === " ") stage.top.focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  scene.selection.follow((selection) => {
    const [only] = selection;
    const k = only === undefined || picking ? -1 : sorted.findIndex(({ id }) => id === only);
    if (k >= 0) {
      at = k;
      reveal();
    } else draw();
  });
  follow([desk.marker, order, insight.worth, scene.colouring, wording, palette], sort);
  desk.changed.follow(draw);
  new ResizeObserver(draw).observe(list);
}
