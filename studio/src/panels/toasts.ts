import { el } from "../dom";
import { t } from "../i18n";
import { icon } from "./icons";

const SHORT = 4000;
const LONG = 12_000;

/** Short messages at the foot of the page. Errors stay longer and can be closed. */
export class Toasts {
  readonly root = el("div", { class: "toasts", role: "status", aria: { live: "polite" } });

  info(message: string): void {
    this.add(el("div", { class: "toast" }, message), SHORT);
  }

  error(title: string, message: string, hint?: string | null): void {
    const close = el("button", { type: "button", class: "quiet", title: t("close") }, icon("cancel"));
    const toast = el(
      "div",
      { class: "toast wrong", role: "alert" },
      el("div", {}, el("strong", {}, title), el("p", {}, message), hint ? el("p", { class: "hint" }, hint) : null),
      close,
    );
    close.addEventListener("click", () => toast.remove());
    this.add(toast, LONG);
  }

  private add(toast: HTMLElement, lasting: number): void {
    this.root.append(toast);
    while (this.root.children.length > 3) this.root.firstElementChild?.remove();
    setTimeout(() => toast.remove(), lasting);
  }
}
