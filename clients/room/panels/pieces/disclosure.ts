import { h, setText } from "../../base/dom";
import type { TextName } from "../../texts/texts";
import { worded } from "../controls";

/** Fields that are shown when their heading is pressed, with a short summary beside the heading. */
export function disclosure(id: string, title: TextName, ...rows: HTMLElement[]): { box: HTMLDetailsElement; tell(text: string): void } {
  const name = h("span");
  worded(name, title);
  const brief = h("span", { class: "brief" });
  const box = h("details", { id, class: "disclosure" }, h("summary", {}, name, brief), ...rows);
  return { box, tell: (text) => setText(brief, text) };
}
