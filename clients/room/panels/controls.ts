import { h } from "../base/dom";
import { say, wording, type TextName } from "../texts/texts";
import { lengthText, parseLength, unitName } from "../texts/units";
import { drawn, type IconName } from "./icons";

// Panels are rebuilt with every revision, so subscriptions to the language must not keep their elements in memory.
const endings = new FinalizationRegistry<() => void>((end) => end());

/** Keeps a text or an attribute of an element in the user's language, as long as the element exists. */
export function worded(element: Element, name: TextName, attribute?: string): void {
  const reference = new WeakRef(element);
  const end = wording.follow(() => {
    if (attribute) reference.deref()?.setAttribute(attribute, say(name));
    else reference.deref()?.replaceChildren(say(name));
  });
  endings.register(element, end);
}

/** A button with an icon; its name is both its tooltip and its accessible name. */
export function iconButton(name: IconName, title: TextName, act: () => void): HTMLButtonElement {
  const button = h("button", { class: "icon-button", type: "button", onclick: act }, drawn(name));
  worded(button, title, "title");
  worded(button, title, "aria-label");
  return button;
}

export function textButton(title: TextName, act: () => void, style = ""): HTMLButtonElement {
  const button = h("button", { type: "button", class: `button ${style}`, onclick: act });
  worded(button, title);
  return button;
}

/** The lengths that a field accepts. */
interface LengthField {
  id?: string;
  least?: number;
  /** Whether the field may be empty, which means that there is no such length. */
  mayBeEmpty?: boolean;
}

/** A field for a length in the user's unit. An invalid text stays in the field, and a message says what is allowed. */
export function lengthField(take: (length: number | undefined) => void, { id, least = 0, mayBeEmpty = false }: LengthField = {}): HTMLInputElement {
  const field: HTMLInputElement = h("input", { type: "text", inputmode: "decimal", size: 5, id, oninput: () => field.setCustomValidity(""), onchange: () => {
    const length = parseLength(field.value);
    const empty = mayBeEmpty && field.value.trim() === "";
    if (empty || (length !== undefined && length >= least)) return take(length);
    field.setCustomValidity(say(least < 0 ? "notANumber" : "notALength", { unit: unitName() }));
    field.reportValidity();
  } });
  return field;
}

/** Shows a length in its field, unless the field is being edited. */
export function showLength(field: HTMLInputElement, length: number | undefined): void {
  if (document.activeElement === field) return;
  field.setCustomValidity("");
  field.value = length === undefined ? "" : lengthText(length, { unit: false });
}

/** A labelled field in a row. */
export function row(title: TextName, control: HTMLElement): HTMLElement {
  const text = h("span");
  worded(text, title);
  return h("label", { class: "row" }, text, control);
}

export function choice<T extends string>(options: ReadonlyArray<readonly [T, TextName]>, value: T, choose: (value: T) => void): HTMLSelectElement {
  const select: HTMLSelectElement = h("select", { onchange: () => choose(select.value as T) });
  for (const [name, text] of options) {
    const option = h("option", { value: name });
    worded(option, text);
    select.append(option);
  }
  select.value = value;
  return select;
}

export function heading(title: TextName): HTMLElement {
  const element = h("h2");
  worded(element, title);
  return element;
}

/** A paragraph whose text follows the language. */
export function note(title: TextName): HTMLElement {
  const element = h("p", { class: "note" });
  worded(element, title);
  return element;
}
