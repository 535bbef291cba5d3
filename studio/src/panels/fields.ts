import { el } from "../dom";
import { type Phrase, t } from "../i18n";
import { PALETTE } from "./styles";

/** A box to tick, shown as a chip. `field` finds it again when the panel is written anew. */
export function check(field: string, label: string, on: boolean, set: (on: boolean) => void): HTMLElement {
  const input = el("input", { type: "checkbox", checked: on, data: { field } });
  input.addEventListener("change", () => set(input.checked));
  return el("label", { class: "chip" }, input, el("span", {}, label));
}

export interface Bounds {
  min: number;
  max: number;
  step: number;
}

/** A slider with the number beside it, which can also be typed. `set` is told whether more will come. */
export function slider(
  phrase: Phrase,
  value: number,
  { min, max, step }: Bounds,
  set: (value: number, moving: boolean) => void,
): HTMLElement {
  const limits = { min: String(Math.min(min, value)), max: String(Math.max(max, value)), step: String(step) };
  const range = el("input", { type: "range", ...limits, value: String(value), data: { field: phrase } });
  const number = el("input", { type: "number", step: String(step), min: limits.min, value: String(value) });
  number.setAttribute("aria-label", t(phrase));
  const take = (input: HTMLInputElement, moving = false): void => {
    if (Number.isFinite(input.valueAsNumber)) set(input.valueAsNumber, moving);
  };
  range.addEventListener("input", () => {
    number.value = range.value;
    take(range, true);
  });
  range.addEventListener("change", () => take(range));
  number.addEventListener("change", () => take(number));
  return el("label", { class: "slider" }, el("span", {}, t(phrase)), range, number);
}

/** The palette, and any other colour. */
export function colorField(value: string, set: (color: string) => void): HTMLElement {
  const other = el("input", { type: "color", value, title: t("color"), data: { field: "color" } });
  other.setAttribute("aria-label", t("color"));
  other.addEventListener("change", () => set(other.value));
  const swatches = PALETTE.map((color) => {
    const swatch = el("button", { type: "button", class: "swatch", title: color });
    swatch.style.setProperty("--swatch", color);
    swatch.setAttribute("aria-pressed", String(color === value.toLowerCase()));
    swatch.addEventListener("click", () => set(color));
    return swatch;
  });
  return el("div", { class: "colors" }, el("span", {}, t("color")), ...swatches, other);
}

/** The name by which formulas may call a cell. */
export function nameField(value: string, set: (name: string) => void): HTMLElement {
  const input = el("input", {
    type: "text",
    class: "name",
    value,
    size: 8,
    spellcheck: false,
    placeholder: t("name"),
    title: t("nameHelp"),
    data: { field: "name" },
  });
  input.setAttribute("aria-label", t("name"));
  input.addEventListener("change", () => set(input.value.trim()));
  return input;
}
