import { el, fill } from "../dom";
import type { CellInfo, DrawMode, Note, Style } from "../engine/protocol";
import { localised, type Phrase, t } from "../i18n";
import type { Session } from "../session";
import { check, colorField, nameField, slider } from "./fields";
import { defaultStyle } from "./styles";

const KNOBS = {
  opacity: { min: 0.05, max: 1, step: 0.05 },
  fineness: { min: 0, max: 8, step: 1 },
  radius: { min: 0.002, max: 0.08, step: 0.001 },
  count: { min: 2, max: 24, step: 1 },
  axis: { min: 0, max: 2, step: 1 },
  length: { min: 0.02, max: 1, step: 0.02 },
} as const;

type Knob = keyof typeof KNOBS;

/** What can be seen and set of the selected cell: notes, value, style, cost. */
export class Inspector {
  readonly root = el("section", { class: "inspector" });
  private shown = "";
  private turning = false;
  /** What changes in every frame of a drag is written in place. */
  private readonly value = el("span", { class: "value" });
  private readonly costs = el("span", { class: "costs" });

  constructor(private readonly session: Session) {
    const { store } = session;
    store.on("selection", () => this.show());
    store.on("cells", (touched) => {
      if (!touched || touched.size === 0 || touched.has(store.address)) this.show();
    });
    localised(() => {
      this.root.setAttribute("aria-label", t("style"));
      this.shown = "";
      fill(this.costs);
      this.show();
    });
  }

  /** Writes the panel anew, unless only readings have changed: a field in use must not lose the focus. */
  private show(): void {
    if (this.turning) return;
    const { store } = this.session;
    const cell = store.selected;
    const note = noteOn(store.notes, store.address);
    this.read(cell);
    const state = JSON.stringify([store.address, frame(cell), note, store.undrawn.get(store.address) ?? null]);
    if (state === this.shown) return;
    const focused = (document.activeElement as HTMLElement | null)?.dataset["field"];
    this.shown = state;
    fill(
      this.root,
      this.header(cell),
      note ? el("p", { class: "note" }, note) : null,
      cell ? this.styleOf(cell) : null,
    );
    if (focused) this.root.querySelector<HTMLElement>(`[data-field="${focused}"]`)?.focus();
  }

  /** Writes what the cell is worth and what it cost. */
  private read(cell: CellInfo | undefined): void {
    const { value, costs } = this;
    const text = cell && !cell.error ? withoutKind(cell) : "";
    if (value.textContent !== text) value.textContent = text;
    value.title = cell && !cell.error ? cell.text : "";
    costs.title = t("cost");
    const parts = costsOf(cell);
    const before = [...costs.children].map((part) => part.textContent);
    if (parts.some(([, part], at) => part !== before[at]) || parts.length !== before.length) {
      fill(costs, ...parts.map(([phrase, part]) => el("span", { title: t(phrase) }, part)));
    }
  }

  private header(cell: CellInfo | undefined): HTMLElement {
    const { address } = this.session.store;
    return el(
      "header",
      {},
      el("h2", {}, address),
      cell ? el("span", { class: cell.error ? "kind wrong" : "kind" }, cell.kind) : el("span", { class: "muted" }, t("emptyCell")),
      this.value,
      cell ? nameField(cell.name ?? "", (name) => void this.session.change("setName", address, name || undefined)) : null,
      cell?.cost ? this.costs : null,
    );
  }

  private styleOf(cell: CellInfo): HTMLElement | null {
    if (cell.modes.length === 0) return cell.error ? null : el("p", { class: "muted" }, t("styleNone"));
    const style = cell.style;
    const shown = check("show", t("show"), style !== null, (on) => this.send(cell, on ? defaultStyle(cell) : null));
    shown.classList.add("switch");
    const ways = el("div", { class: "ways" }, shown, ...cell.modes.map((mode) => this.way(cell, mode)));
    const trouble = this.session.store.undrawn.get(cell.address);
    return el(
      "div",
      { class: "style" },
      ways,
      trouble ? el("p", { class: "trouble" }, t("notDrawn", { message: trouble.message })) : null,
      style ? this.details(cell, style) : null,
    );
  }

  private way(cell: CellInfo, mode: DrawMode): HTMLElement {
    const on = cell.style?.draw.includes(mode) ?? false;
    return check(mode, t(mode), on, (next) => {
      const base = cell.style ?? { ...defaultStyle(cell), draw: [] };
      const draw = next ? [...base.draw, mode] : base.draw.filter((other) => other !== mode);
      this.send(cell, draw.length > 0 ? { ...base, draw } : null);
    });
  }

  private details(cell: CellInfo, style: Style): HTMLElement {
    const set = (part: Partial<Style>): void => this.send(cell, { ...style, ...part });
    const has = (...modes: DrawMode[]): boolean => modes.some((mode) => style.draw.includes(mode));
    const fineness = Array.isArray(style.fineness) ? Math.max(...style.fineness) : style.fineness;
    const knob = (key: Knob, value: number): HTMLElement =>
      slider(key, value, KNOBS[key], (next, moving) => this.turn(cell, { ...style, [key]: next }, moving));
    return el(
      "div",
      { class: "details" },
      colorField(style.color, (color) => set({ color })),
      knob("opacity", style.opacity),
      knob("fineness", fineness),
      has("points", "curve", "fibres", "net", "poles", "normals") ? knob("radius", style.radius) : null,
      has("sheets", "fibres") ? knob("count", style.count) : null,
      has("sheets", "fibres") ? knob("axis", style.axis) : null,
      has("normals") ? knob("length", style.length) : null,
      has("surface", "envelope", "sheets") ? shading(style.shading, (value) => set({ shading: value })) : null,
    );
  }

  /** The picture follows the slider; the panel is left alone until it is let go. */
  private turn(cell: CellInfo, style: Style, moving: boolean): void {
    this.turning = moving;
    if (moving) this.session.styleLive(cell.address, style);
    else void this.session.endStyle(cell.address, style);
  }

  private send(cell: CellInfo, style: Style | null): void {
    void this.session.setStyle(cell.address, style);
  }
}

/** The remark on a cell, else the one on the sheet as a whole. */
function noteOn(notes: readonly Note[], address: string): string {
  const note = notes.find((one) => one.cell === address) ?? notes.find((one) => one.cell === null);
  return note?.text ?? "";
}

/** The value in short, without the kind that stands beside it. */
function withoutKind(cell: CellInfo): string {
  const beginning = `${cell.kind} · `;
  return cell.text.startsWith(beginning) ? cell.text.slice(beginning.length) : cell.text;
}

/** All of a cell that the panel shows, its readings apart. */
function frame(cell: CellInfo | undefined): unknown[] | null {
  if (!cell) return null;
  return [cell.kind, cell.error, cell.name, cell.style, cell.modes, cell.cost !== null];
}

function costsOf(cell: CellInfo | undefined): [Phrase, string][] {
  const parts: [Phrase, string][] = [
    ["time", cell?.cost?.time ?? ""],
    ["orders", cell?.cost?.orders ?? ""],
    ["bytes", cell?.cost?.bytes ?? ""],
  ];
  return parts.filter(([, text]) => text !== "");
}

function shading(now: Style["shading"], set: (value: Style["shading"]) => void): HTMLElement {
  return check("smooth", t("smooth"), now === "smooth", (on) => set(on ? "smooth" : "flat"));
}
