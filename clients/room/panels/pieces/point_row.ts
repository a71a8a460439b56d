import type { Point } from "../../../typescript/src/index";
import { h } from "../../base/dom";
import type { TextName } from "../../texts/texts";
import { lengthField, showLength, worded } from "../controls";

/** Two fields for the coordinates of a point, along and across. `set` receives a function from the previous point to the new one. */
export function pointRow(id: string, title: TextName, set: (change: (known: Point) => Point) => void): { row: HTMLElement; show(point: Point | undefined): void } {
  const along = lengthField((x) => set(([, y]) => [x!, y]), { id: `${id}-along`, least: -Infinity });
  const across = lengthField((y) => set(([x]) => [x, y!]), { id: `${id}-across`, least: -Infinity });
  worded(along, "pointAlong", "aria-label");
  worded(across, "pointAcross", "aria-label");
  const text = h("span", { id: `${id}-title` });
  worded(text, title);
  const row = h("div", { class: "row", role: "group", "aria-labelledby": `${id}-title` }, text, h("span", { class: "with-unit" }, along, across));
  const show = (point: Point | undefined) => {
    row.hidden = !point;
    if (!point) return;
    showLength(along, point[0]);
    showLength(across, point[1]);
  };
  return { row, show };
}
