import { el, fill } from "../dom";
import type { Pole } from "../engine/protocol";
import { t } from "../i18n";

const NAMES = ["x", "y", "z"];

export interface PopupRequest {
  address: string;
  pole: Pole;
  /** Where to appear, in pixels of the view. */
  x: number;
  y: number;
  apply(texts: string[]): Promise<boolean>;
}

/** A small form to type the coordinates and the weight of a pole. */
export class PolePopup {
  readonly root = el("form", { class: "pole-popup", hidden: true, noValidate: true });
  private back: HTMLElement | null = null;

  constructor() {
    this.root.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      this.close();
    });
  }

  show(request: PopupRequest): void {
    const { pole } = request;
    this.back = document.activeElement as HTMLElement | null;
    const fields = pole.coordinates.map((text, axis) => field(NAMES[axis] ?? `x${axis + 1}`, text));
    fields.push(field(t("weight"), pole.weight));
    fill(
      this.root,
      el("div", { class: "popup-title" }, t("pole", { index: pole.index.join(", "), address: request.address })),
      ...fields.map(({ label }) => label),
      el("div", { class: "popup-buttons" }, this.closer(), el("button", { class: "primary", type: "submit" }, "OK")),
    );
    this.root.onsubmit = (event) => {
      event.preventDefault();
      void request.apply(fields.map(({ input }) => input.value)).then((done) => done && this.close());
    };
    this.root.setAttribute("aria-label", t("polesEdit"));
    this.root.hidden = false;
    this.place(request.x, request.y);
    fields[0]?.input.select();
  }

  close(): void {
    if (this.root.hidden) return;
    this.root.hidden = true;
    this.back?.focus();
  }

  private closer(): HTMLElement {
    const button = el("button", { type: "button", class: "quiet" }, t("abandon"));
    button.addEventListener("click", () => this.close());
    return button;
  }

  private place(x: number, y: number): void {
    const host = this.root.parentElement;
    if (!host) return;
    const left = Math.max(8, Math.min(x + 16, host.clientWidth - this.root.offsetWidth - 8));
    const top = Math.max(8, Math.min(y + 16, host.clientHeight - this.root.offsetHeight - 8));
    this.root.style.left = `${left}px`;
    this.root.style.top = `${top}px`;
  }
}

function field(name: string, value: string): { label: HTMLElement; input: HTMLInputElement } {
  const input = el("input", { type: "text", value, inputMode: "decimal", spellcheck: false, size: 9 });
  return { label: el("label", {}, el("span", {}, name), input), input };
}
