// Icons of 20 by 20, drawn with lines of the same width.
import { icon } from "../base/dom";

const drawings = {
  undo: ["M7 5 3.500 8.500 7 12", "M4 8.500h7a4.500 4.500 0 0 1 0 9H8"],
  redo: ["M13 5l3.500 3.500L13 12", "M16 8.500H9a4.500 4.500 0 0 0 0 9h3"],
  settings: ["M3 6h8M15 6h2M3 14h2M9 14h8", "M13 4a2 2 0 1 0 0 4 2 2 0 0 0 0-4Z", "M7 12a2 2 0 1 0 0 4 2 2 0 0 0 0-4Z"],
  help: ["M10 2.500a7.500 7.500 0 1 0 0 15 7.500 7.500 0 0 0 0-15Z", "M7.800 7.800a2.200 2.200 0 1 1 3.200 2c-.7.4-1 .8-1 1.600", "M10 14v.1"],
  fit: ["M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4"],
  zoomIn: ["M10 5v10M5 10h10"],
  zoomOut: ["M5 10h10"],
  select: ["M5 3l10 7-4.500 1L8 16Z"],
  ruler: ["M2.500 13.500 13.500 2.500l4 4-11 11Z", "M6 10l1.500 1.500M8.500 7.500 10 9M11 5l1.500 1.500"],
  gap: ["M10 3v14", "M7 7l-3 3 3 3M13 7l3 3-3 3"],
  gravity: ["M4 16 15 5", "M8.500 4.500H15.500V11.500"],
  chain: ["M3 14l4-5 4 3 6-7", "M3 14v.1M7 9v.1M11 12v.1M17 5v.1"],
  regions: ["M3 4h14v12H3Z", "M3 9l5-5M3 14 13 4M6 16 17 5M12 16l5-5"],
  push: ["M3 10h7", "M7.500 7 10.500 10l-3 3", "M12.500 5v10M16 6.500v7"],
  place: ["M3 10h5", "M11 3v14", "M8 7v9"],
  fits: ["M3 6V3h3M9 3h2M14 3h3v3M17 9v2M17 14v3h-3M11 17H9M6 17H3v-3M3 11V9", "M7 7h6v6H7Z"],
  close: ["M5 5l10 10M15 5 5 15"],
  down: ["M6 8l4 4 4-4"],
  lock: ["M5.500 9h9v7h-9Z", "M7 9V6.500a3 3 0 0 1 6 0V9"],
  flip: ["M10 3v14", "M7.500 6 3 14h4.500ZM12.500 6l4.500 8h-4.500Z"],
  rotate: ["M15.500 10a5.500 5.500 0 1 1-1.800-4.100", "M14.500 2.500v4h-4"],
  group: ["M3 3h6v6H3ZM11 11h6v6h-6Z", "M9 9l2 2"],
};
export type IconName = keyof typeof drawings;

export const drawn = (name: IconName): SVGSVGElement => icon(...drawings[name]);
