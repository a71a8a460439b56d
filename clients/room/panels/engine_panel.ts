import type { Accuracy } from "../../typescript/src/index";
import { fill, h, setText } from "../base/dom";
import { follow } from "../base/signal";
import type { Engine } from "../engine/engine";
import type { Result } from "../engine/result";
import type { Desk } from "../session/desk";
import type { Library } from "../session/library";
import { say, wording, type TextName } from "../texts/texts";
import { lengthText, numberText, parseLength, percentText, unitName } from "../texts/units";
import type { Scene } from "../view/scene";
import type { Stage } from "../view/stage";
import { heading, note, row, textButton, worded } from "./controls";
import { drawCurve } from "./curve";

/** The panel with the motions, the motion in progress, and the results kept for comparison. */
export function buildEnginePanel(host: HTMLElement, desk: Desk, engine: Engine, library: Library, scene: Scene, stage: Stage): void {
  const compact = (accuracy: Accuracy, title: TextName) => textButton(title, () => void engine.start("motion.compact", { accuracy }, say("compact")));
  const standard = compact("standard", "standard");
  standard.classList.add("primary");
  const fine = textButton("fine", () => void engine.search({ kind: "fine" }, `${say("compact")}, ${say("fine").toLowerCase()}`));
  worded(fine, "fineHelp", "title");
  const distance = h("input", { type: "text", inputmode: "decimal", value: "5", size: 5, id: "float-distance" });
  const unit = h("span", { class: "unit" });
  wording.follow(() => setText(unit, unitName()));
  const motion = (title: TextName, help: TextName, act: () => void) => {
    const button = textButton(title, act);
    worded(button, help, "title");
    return button;
  };
  const relax = motion("relax", "relaxHelp", () => {
    const [piece] = scene.selected();
    if (piece) void engine.start("motion.relax", { piece: piece.id, tilts: 21 }, say("relax"));
  });
  scene.selection.follow((selection) => (relax.disabled = selection.size !== 1));
  const float = motion("float", "floatHelp", () => {
    const width = parseLength(distance.value);
    if (width) void engine.start("motion.float", { distance: width, edges: true }, say("float"));
  });
  const separate = motion("separate", "separateHelp", () => void engine.start("motion.separate", { grow: 0.1 }, say("separate")));
  const tilt = motion("tilt", "tiltHelp", () => void engine.start("motion.tilt", { accuracy: "standard" }, say("tilt")));
  const nest = motion("nest", "nestHelp", () => void engine.search({ kind: "nest" }, say("nest")));
  const fillGaps = motion("fillGaps", "fillGapsHelp", () => void engine.search({ kind: "fillGaps" }, say("fillGaps")));
  const remake = motion("fromLibrary", "fromLibraryHelp", () => void engine.remake());
  library.count.follow((count) => (remake.hidden = count === 0));
  const exactly = motion("exactly", "exactlyHelp", () => {
    const among = stage.chosen();
    const all = among.length === (desk.marker.value?.pieces.length ?? 0);
    const title = all ? say("exactly") : say("exactlyOf", { count: numberText(among.length, 0) });
    if (among.length > 0) void engine.search(all ? { kind: "compactExactly" } : { kind: "compactExactly", among: among.map(({ id }) => id) }, title);
  });
  const keep = textButton("keepRevision", () => engine.keepBeside());
  worded(keep, "keepRevisionHelp", "title");
  const progress = h("div", { id: "progress", class: "card", hidden: true });
  const beside = h("div", { id: "beside" });
  fill(
    host,
    heading("compact"),
    note("compactHelp"),
    h("div", { class: "segments" }, compact("draft", "draft"), standard, fine, exactly),
    progress,
    h("div", { class: "pair" }, nest, fillGaps, remake, tilt, separate, relax, float),
    row("gapWidth", h("span", { class: "with-unit" }, distance, unit)),
    heading("beside"),
    keep,
    beside,
  );
  engine.preview.follow((result) => (keep.hidden = result !== undefined));
  buildProgress(progress, engine);
  follow([engine.run, wording], () => {
    for (const button of host.querySelectorAll<HTMLButtonElement>(".segments button, .pair button")) {
      if (button !== relax) button.disabled = engine.run.value !== undefined;
    }
  });
  follow([engine.beside, engine.compared, desk.figures, wording], () => drawBeside(beside, desk, engine));
}

/** Moves the keyboard focus to the marker when the focused element disappears. */
function leave(host: HTMLElement): void {
  if (host.contains(document.activeElement)) document.getElementById("top")?.focus();
}

function buildProgress(host: HTMLElement, engine: Engine): void {
  const title = h("span", { class: "card-title" });
  const stop = textButton("stop", () => engine.run.value?.stop(), "danger");
  const curve = h("div", { class: "curve-host" });
  host.append(h("div", { class: "card-head" }, title, stop), curve);
  let since = 0;
  follow([engine.run, wording], () => {
    const run = engine.run.value;
    if (!run) leave(host);
    host.hidden = !run;
    if (!run) return;
    setText(title, run.stopping ? say("stopping", { length: lengthText(run.best ?? 0) }) : run.round > 0 ? say("running", { what: run.title, round: numberText(run.round, 0) }) : say("starting", { what: run.title }));
    const now = performance.now();
    if (now - since < 80 && run.curve.length > 2) return;
    since = now;
    drawCurve(curve, run.curve);
  });
}

function drawBeside(host: HTMLElement, desk: Desk, engine: Engine): void {
  const compare = (result: Result | "opening") => {
    const on = engine.compared.value === result;
    return textButton("compare", () => (engine.compared.value = on ? undefined : result), on ? "on" : "");
  };
  const opening = desk.opening?.figures;
  const cards = engine.beside.value.map((result) => {
    const stale = result.markerKey === desk.markerKey && result.base !== desk.figures.value.revision;
    const take = textButton("take", () => void engine.take(result));
    take.disabled = result.markerKey !== desk.markerKey;
    return h(
      "div",
      { class: "card" },
      h("div", { class: "card-head" }, h("span", { class: "card-title" }, result.title), h("strong", {}, lengthText(result.length))),
      h("p", { class: "note" }, `${percentText(result.utilisation)}${result.seconds === undefined ? "" : ` · ${numberText(result.seconds, 1)} s · ${say("basedOn", { revision: result.base })}`}`),
      stale && h("p", { class: "note" }, say("changedMeanwhile")),
      h("div", { class: "buttons" }, take, compare(result), textButton("drop", () => engine.drop(result))),
    );
  });
  const first = opening && h("div", { class: "card" }, h("div", { class: "card-head" }, h("span", { class: "card-title" }, say("compareOpening")), h("strong", {}, lengthText(opening.length))), h("div", { class: "buttons" }, compare("opening")));
  fill(host, ...(cards.length > 0 ? cards : [h("p", { class: "note" }, say("besideNone"))]), first ?? null);
}

/** The bar over the canvas for the previewed result, with buttons for what can be done with it. */
export function buildOffer(host: HTMLElement, desk: Desk, engine: Engine): void {
  const take = textButton("take", () => void engine.take(), "primary");
  const title = h("span", { class: "offer-title" });
  const gain = h("strong", { id: "offer-gain" });
  const more = h("span", { class: "offer-more" });
  const keys = (key: string) => h("kbd", {}, key);
  const keep = textButton("keepBeside", () => engine.keepBeside());
  const drop = textButton("drop", () => engine.drop());
  fill(host, title, gain, more, h("span", { class: "buttons" }, take, keys("↵"), keep, keys("K"), drop, keys("Esc")));
  follow([engine.preview, desk.figures, wording], () => {
    const result = engine.preview.value;
    if (!result) leave(host);
    host.dataset["shown"] = result ? "yes" : "";
    host.inert = !result;
    if (!result) return;
    setText(title, result.title);
    const saved = result.before - result.length;
    const lacksPieces = (desk.marker.value?.unplaced.length ?? 0) > 0;
    setText(gain, lacksPieces ? lengthText(result.length) : `${saved > 0 ? "−" : saved < 0 ? "+" : "±"}${lengthText(Math.abs(saved))}`);
    const stale = result.base !== desk.figures.value.revision;
    setText(more, stale ? say("changedMeanwhile") : `${lengthText(result.length)} · ${percentText(result.utilisation)} · ${numberText(result.seconds ?? 0, 2)} s`);
  });
}
