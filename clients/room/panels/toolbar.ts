import { fill, h } from "../base/dom";
import { prefer, preferences } from "../base/preferences";
import { follow } from "../base/signal";
import type { Insight } from "../engine/insight";
import { tool, type Tool } from "../input/tools";
import { say, wording, type TextName } from "../texts/texts";
import { palette } from "../view/palette";
import type { Scene } from "../view/scene";
import type { Stage } from "../view/stage";
import { iconButton, worded } from "./controls";
import { drawn, type IconName } from "./icons";

/** The toolbar with tools and views at the left edge of the canvas. */
export function buildToolbar(host: HTMLElement, stage: Stage, insight: Insight): void {
  worded(host, "tools", "aria-label");
  const tools: Array<[Tool, IconName, TextName]> = [["select", "select", "toolSelect"], ["ruler", "ruler", "toolRuler"], ["gap", "gap", "toolGap"], ["gravity", "gravity", "toolGravity"]];
  const buttons = tools.map(([name, picture, title]) => {
    const button = iconButton(picture, title, () => (tool.value = name));
    tool.follow((chosen) => button.setAttribute("aria-pressed", String(chosen === name)));
    return button;
  });
  const mode = h("button", { type: "button", class: "icon-button", id: "drag-mode", onclick: () => prefer({ dragMode: preferences.value.dragMode === "push" ? "place" : "push" }) });
  follow([preferences, wording], () => {
    const pushes = preferences.value.dragMode === "push";
    const title = say(pushes ? "pushes" : "slides");
    fill(mode, drawn(pushes ? "push" : "place"));
    mode.title = title;
    mode.setAttribute("aria-label", title);
  });
  const view = (signal: Insight["chainShown"], picture: IconName, title: TextName) => {
    const button = iconButton(picture, title, () => (signal.value = !signal.value));
    signal.follow((on) => button.setAttribute("aria-pressed", String(on)));
    return button;
  };
  const gap = () => h("span", { class: "tool-gap" });
  fill(
    host,
    ...buttons,
    mode,
    gap(),
    view(insight.chainShown, "chain", "showChain"),
    view(insight.regionsShown, "regions", "showRegions"),
    gap(),
    iconButton("fit", "fit", () => stage.fit()),
    iconButton("zoomIn", "zoomIn", () => stage.zoom(1.25)),
    iconButton("zoomOut", "zoomOut", () => stage.zoom(0.8)),
  );
}

/** The legend of the colours of sizes, bundles or shapes; hidden if there are too many to tell apart. */
export function buildLegend(host: HTMLElement, scene: Scene): void {
  follow([scene.colouring, palette, wording], () => {
    const names = palette.value ? scene.colouring.value.legend(palette.value) : [];
    host.hidden = names.length < 2 || names.length > 9 || scene.colouring.value.by === "none";
    fill(
      host,
      ...names.map(({ name, fill: colour }) => {
        const swatch = h("span", { class: "swatch" });
        swatch.style.background = colour;
        return h("span", { class: "legend-entry" }, swatch, name);
      }),
    );
  });
}
