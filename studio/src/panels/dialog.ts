import { el, fill } from "../dom";
import { localised, type Phrase, t } from "../i18n";
import { icon } from "./icons";

/** A window over the page with a title and a close button; Escape and a click outside close it. */
export class Dialog {
  readonly body = el("div", { class: "dialog-body" });
  private readonly heading = el("h2", {});
  readonly root: HTMLDialogElement;

  constructor(title: Phrase, kind: string) {
    const close = el("button", { type: "button", class: "quiet" }, icon("cancel"));
    this.root = el("dialog", { class: `dialog ${kind}` }, el("header", {}, this.heading, close), this.body);
    close.addEventListener("click", () => this.close());
    this.root.addEventListener("mousedown", (event) => {
      if (event.target === this.root) this.close();
    });
    localised(() => {
      this.heading.textContent = t(title);
      close.setAttribute("aria-label", t("close"));
      this.root.setAttribute("aria-label", t(title));
    });
  }

  show(...content: (Node | null)[]): void {
    fill(this.body, ...content);
    if (!this.root.open) this.root.showModal();
  }

  close(): void {
    this.root.close();
  }
}
