import { Signal } from "../base/signal";
import type { Preferences } from "../base/preferences";
import type { Piece } from "../marker/marker";

// Paul Tol's "light" scheme (Technical note SRON/EPS/TN/09-002): colour-blind people can distinguish its fills under dark text.
const HUES = ["#77aadd", "#eedd88", "#ee8866", "#44bb99", "#ffaabb", "#bbcc33", "#99ddff", "#aaaa00", "#c5a3d9"];

/** The colours of drawings, from the style sheet's custom properties, which differ by theme. */
export interface Palette {
  cloth: string;
  selvedge: string;
  grid: string;
  ink: string;
  faint: string;
  line: string;
  accent: string;
  onAccent: string;
  chain: string;
  fault: string;
  gain: string;
  region: string;
  other: string;
  halo: string;
  fills: string[];
  plain: string;
  contrast: boolean;
}

// Mixes a hue with the background colour of the theme.
function mixed(hue: string, paper: [number, number, number], part: number): string {
  const channel = (k: number) => parseInt(hue.slice(1 + 2 * k, 3 + 2 * k), 16);
  return `rgb(${paper.map((value, k) => Math.round(channel(k) * part + value * (1 - part))).join(" ")})`;
}

export function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  const colour = (name: string) => style.getPropertyValue(`--${name}`).trim();
  const dark = colour("scheme") === "dark";
  const paper: [number, number, number] = dark ? [22, 27, 34] : [255, 255, 255];
  return {
    cloth: colour("cloth"),
    selvedge: colour("selvedge"),
    grid: colour("grid"),
    ink: colour("piece-ink"),
    faint: colour("faint"),
    line: colour("piece-line"),
    accent: colour("accent"),
    onAccent: colour("on-accent"),
    chain: colour("chain"),
    fault: colour("fault"),
    gain: colour("gain"),
    region: colour("region"),
    other: colour("other"),
    halo: colour("halo"),
    fills: HUES.map((hue) => mixed(hue, paper, dark ? 0.5 : 0.62)),
    plain: colour("piece"),
    contrast: matchMedia("(prefers-contrast: more)").matches || matchMedia("(forced-colors: active)").matches,
  };
}

export const palette = new Signal<Palette | undefined>(undefined);

/** The colours of pieces: pieces of the same size, bundle or shape have the same colour. Zones have no colour. */
export class Colouring {
  private readonly places = new Map<string, number>();

  constructor(
    readonly by: Preferences["colourBy"],
    pieces: readonly Piece[],
  ) {
    const names = [...new Set(pieces.filter(({ rules }) => !rules.zone).map((piece) => this.nameOf(piece)))];
    names.sort((a, b) => a.localeCompare(b, undefined, { numeric: true }));
    names.forEach((name, place) => this.places.set(name, place));
  }

  nameOf({ shape, bundle }: Piece): string {
    if (this.by === "none") return "";
    return (this.by === "bundle" ? bundle : this.by === "size" ? shape.size : shape.name) || shape.id;
  }

  /** The names and their colours, for a legend. */
  legend(colours: Palette): Array<{ name: string; fill: string }> {
    return [...this.places].map(([name, place]) => ({ name, fill: colours.fills[place % colours.fills.length]! }));
  }

  fillOf(piece: Piece, colours: Palette): string {
    if (this.by === "none") return colours.plain;
    return colours.fills[(this.places.get(this.nameOf(piece)) ?? 0) % colours.fills.length]!;
  }
}
