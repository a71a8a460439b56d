import { Signal } from "./signal";

export interface Preferences {
  language: "en" | "de";
  unit: "mm" | "cm" | "in" | "yd";
  decimal: "auto" | "point" | "comma";
  theme: "system" | "light" | "dark";
  colourBy: "size" | "bundle" | "shape" | "none";
  dragMode: "push" | "place";
  price: number; // per metre of cloth
  plies: number;
  currency: string;
  middle: boolean; // draw a line in the middle of the cloth's width
  labels: boolean;
}

const KEY = "selvage-room";
const german = navigator.language.toLowerCase().startsWith("de");
const defaults: Preferences = {
  language: german ? "de" : "en",
  unit: "mm",
  decimal: "auto",
  theme: "system",
  colourBy: "size",
  dragMode: "push",
  price: 8,
  plies: 60,
  currency: "€",
  middle: false,
  labels: true,
};

function load(): Preferences {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? "{}") as Partial<Preferences>;
    const known = Object.entries(kept).filter(([name, value]) => typeof value === typeof defaults[name as keyof Preferences]);
    return { ...defaults, ...Object.fromEntries(known) };
  } catch {
    return { ...defaults }; // storage is forbidden, or its content is not ours
  }
}

/** The user's choices, stored in this browser. */
export const preferences = new Signal<Preferences>(load());

export function prefer(change: Partial<Preferences>): void {
  preferences.value = { ...preferences.value, ...change };
  try {
    localStorage.setItem(KEY, JSON.stringify(preferences.value));
  } catch {
    // Without storage, the choice lasts as long as the page.
  }
}
