import { Signal } from "../base/signal";
import { preferences } from "../base/preferences";
import { english, type TextName, type Texts } from "./english";
import { german } from "./german";

export type { TextName };

const tables: Record<"en" | "de", Texts> = { en: english, de: german };
const table = (): Texts => tables[preferences.value.language];

/** The text in the user's language, with the names in braces replaced by values. */
export function say(name: TextName, values: Record<string, string | number> = {}): string {
  return table()[name].replace(/\{(\w+)\}/g, (_, key: string) => String(values[key] ?? ""));
}

/** Changes when texts must be updated, because the language, a unit or the decimal sign has changed. */
export const wording = new Signal("");
preferences.follow(({ language, unit, decimal, currency, price, plies }) => {
  document.documentElement.lang = language;
  wording.value = [language, unit, decimal, currency, price, plies].join(" ");
});
