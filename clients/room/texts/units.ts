import { preferences, type Preferences } from "../base/preferences";

const MILLIMETRES: Record<string, number> = { mm: 1, cm: 10, m: 1000, in: 25.4, inch: 25.4, yd: 914.4 };
const DIGITS: Record<Preferences["unit"], number> = { mm: 1, cm: 2, in: 2, yd: 3 };

let markerUnit = "mm";
/** Sets the marker's unit, in which lengths are given to the functions below. */
export function measureIn(unit: string): void {
  markerUnit = unit;
}

const isKnown = (unit: string) => unit in MILLIMETRES;

/** The length of the displayed unit in the marker's unit. A marker in an unknown unit is displayed in that unit. */
export function unitOf({ unit }: { unit: string }): number {
  return isKnown(unit) ? MILLIMETRES[preferences.value.unit]! / MILLIMETRES[unit]! : 1;
}
export const unitName = (): string => (isKnown(markerUnit) ? preferences.value.unit : markerUnit);

/** A millimetre in the marker's unit; 1 if that is unknown. */
export const millimetre = (): number => (isKnown(markerUnit) ? 1 / MILLIMETRES[markerUnit]! : 1);

/** A length of the marker in metres, for prices. Undefined if the marker's unit is unknown. */
export const metres = (length: number): number | undefined =>
  isKnown(markerUnit) ? (length * MILLIMETRES[markerUnit]!) / 1000 : undefined;

const locale = (): string => {
  const { decimal, language } = preferences.value;
  return (decimal === "auto" ? language === "de" : decimal === "comma") ? "de-DE" : "en-GB";
};

const formats = new Map<string, Intl.NumberFormat>();
export function numberText(value: number, digits: number, least = digits): string {
  const key = `${locale()} ${digits} ${least}`;
  const known = formats.get(key);
  const format = known ?? new Intl.NumberFormat(locale(), { maximumFractionDigits: digits, minimumFractionDigits: least });
  if (!known) formats.set(key, format);
  return format.format(value === 0 ? 0 : value).replace("-", "−");
}

export interface LengthStyle {
  unit?: boolean;
  digits?: number;
  significant?: boolean;
}
/** A length of the marker in the displayed unit. */
export function lengthText(length: number, { unit = true, digits, significant = false }: LengthStyle = {}): string {
  const own = !isKnown(markerUnit);
  const value = length / unitOf({ unit: markerUnit });
  const places = significant || own ? Math.max(0, Math.min(6, 3 - Math.floor(Math.log10(Math.abs(value) || 1)))) : (digits ?? DIGITS[preferences.value.unit]);
  const text = numberText(value, places, significant ? 0 : places);
  return unit ? `${text} ${unitName()}` : text;
}

export function areaText(area: number): string {
  const square = area / unitOf({ unit: markerUnit }) ** 2;
  const millimetres = unitName() === "mm";
  return millimetres ? `${numberText(square / 100, 1)} cm²` : `${numberText(square, 1)} ${unitName()}²`;
}

export const percentText = (part: number, digits = 2): string => `${numberText(part * 100, digits)} %`;

/** What the user typed, with a decimal point or a comma. */
export function parseNumber(text: string): number | undefined {
  const value = Number(text.trim().replace(/\s/g, "").replace(",", "."));
  return text.trim() !== "" && Number.isFinite(value) ? value : undefined;
}
/** A length that the user typed in the displayed unit, in the marker's. */
export const parseLength = (text: string): number | undefined => {
  const value = parseNumber(text);
  return value === undefined ? undefined : value * unitOf({ unit: markerUnit });
};
