import { el, fill } from "../dom";
import type { Assistance, CellError } from "../engine/protocol";
import { localised, t } from "../i18n";
import { icon } from "../panels/icons";
import { Completion } from "./completion";
import { Editor } from "./editor";

/** Where the selection goes after the text was accepted. */
export type Leave = "stay" | "down" | "up" | "right" | "left";

export interface BarEvents {
  assist(text: string, caret: number): Promise<Assistance | null>;
  /** Typing began or went on. */
  draft(text: string): void;
  commit(text: string, leave: Leave): void;
  /** `back`: the keyboard returns to the sheet. */
  cancel(back: boolean): void;
  goTo(address: string): void;
}

/** The bar above the sheet: address, formula, completion, help, and what is wrong. */
export class FormulaBar {
  private readonly address = el("input", { class: "address", type: "text", spellcheck: false, size: 6 });
  private readonly message = el("div", { class: "bar-message", role: "status", hidden: true });
  private readonly completion = new Completion((index) => this.take(index));
  readonly editor: Editor;
  readonly root: HTMLElement;
  /** True from the first key stroke until the text is accepted or abandoned. */
  editing = false;
  private original = "";
  private asked = 0;
  /** The help that was asked for last, on its way. */
  private assisting: Promise<void> = Promise.resolve();

  constructor(private readonly events: BarEvents) {
    this.editor = new Editor({
      change: () => this.changed(),
      key: (event) => this.key(event),
      focus: () => this.begin(),
      blur: (to) => this.left(to),
    });
    const accept = this.button("accept", () => this.commit("stay"));
    const cancel = this.button("cancel", () => this.cancel());
    this.root = el(
      "section",
      { class: "bar" },
      el("div", { class: "bar-line" }, this.address, cancel, accept, this.editor.root),
      this.completion.root,
      this.message,
    );
    this.describe();
    this.address.addEventListener("keydown", (event) => {
      if (event.key === "Enter") this.events.goTo(this.address.value);
    });
  }

  /** Shows a cell that is not being edited. */
  show(address: string, source: string, error: CellError | null): void {
    this.address.value = address;
    const label = t("formula", { address });
    if (this.editor.area.getAttribute("aria-label") !== label) this.editor.area.setAttribute("aria-label", label);
    if (this.editing) return;
    this.original = source;
    this.editor.setText(source);
    this.completion.hide();
    this.showError(error);
  }

  /** Starts editing: with new text, or with what is there when `text` is null. */
  edit(text: string | null): void {
    this.editing = true;
    this.editor.area.focus();
    if (text !== null) this.editor.setText(text);
    else this.editor.setText(this.editor.text);
    this.changed();
  }

  /** Puts a cell's address at the caret, as when a cell is clicked while a formula is typed. */
  insertReference(reference: string): boolean {
    const before = this.editor.text.slice(0, this.editor.caret);
    if (!this.editing || !/^=(.*[-+*/^(\[,;:=<>|\s])?$/s.test(before)) return false;
    this.editor.splice(this.editor.caret, this.editor.caret, reference);
    this.editor.area.focus();
    this.changed();
    return true;
  }

  private button(kind: "accept" | "cancel", act: () => void): HTMLButtonElement {
    const button = el("button", { class: `quiet ${kind}`, type: "button", tabIndex: -1 }, icon(kind));
    button.addEventListener("mousedown", (event) => event.preventDefault());
    button.addEventListener("click", act);
    localised(() => {
      button.title = t(kind);
      button.setAttribute("aria-label", t(kind));
    });
    return button;
  }

  private describe(): void {
    const { area } = this.editor;
    area.setAttribute("role", "combobox");
    area.setAttribute("aria-autocomplete", "list");
    area.setAttribute("aria-controls", this.completion.id);
    localised(() => {
      area.placeholder = t("formulaEmpty");
      this.address.title = t("goTo");
      this.address.setAttribute("aria-label", t("cellAddress"));
    });
  }

  private begin(): void {
    if (this.editing) return;
    this.editing = true;
    this.events.draft(this.editor.text);
  }

  private changed(): void {
    if (!this.editing) return;
    this.events.draft(this.editor.text);
    this.assisting = this.assist();
  }

  private async assist(): Promise<void> {
    const ask = ++this.asked;
    const answer = await this.events.assist(this.editor.text, this.editor.caret);
    if (!answer || ask !== this.asked || !this.editing) return;
    this.completion.show(answer);
    this.editor.setMarks(answer.diagnostics);
    const first = answer.diagnostics[0];
    if (first && !answer.call && answer.proposals.length === 0) this.say(first.message, first.hint, true);
    else this.say("", null, false);
    this.reflect();
  }

  private reflect(): void {
    const { area } = this.editor;
    area.setAttribute("aria-expanded", String(this.completion.open));
    const id = this.completion.activeId;
    if (id) area.setAttribute("aria-activedescendant", id);
    else area.removeAttribute("aria-activedescendant");
  }

  private key(event: KeyboardEvent): void {
    if (event.isComposing || (this.completion.open && this.completionKey(event))) return;
    const leave: Record<string, Leave> = {
      Enter: event.shiftKey ? "up" : "down",
      Tab: event.shiftKey ? "left" : "right",
    };
    const target = leave[event.key];
    if (event.key === "Enter" && event.altKey) {
      event.preventDefault();
      this.editor.splice(this.editor.caret, this.editor.area.selectionEnd, "\n");
      this.changed();
    } else if (target) {
      event.preventDefault();
      this.commit(target);
    } else if (event.key === "Escape") {
      event.preventDefault();
      this.cancel();
    }
  }

  private completionKey(event: KeyboardEvent): boolean {
    switch (event.key) {
      case "ArrowDown":
        this.completion.move(1);
        break;
      case "ArrowUp":
        this.completion.move(-1);
        break;
      case "Tab":
        // What is shown may belong to the text of a moment ago.
        void this.assisting.then(() => this.take(this.completion.activeIndex));
        break;
      case "Escape":
        this.completion.hide();
        break;
      default:
        return false;
    }
    event.preventDefault();
    this.reflect();
    return true;
  }

  private take(index: number): void {
    const taken = this.completion.taken(index);
    if (!taken) return;
    this.editor.splice(taken.from, taken.to, taken.insert);
    this.completion.hide();
    this.changed();
  }

  commit(leave: Leave): void {
    this.end();
    this.events.commit(this.editor.text, leave);
  }

  private cancel(): void {
    this.end();
    this.editor.setText(this.original);
    this.events.cancel(true);
  }

  /** Going elsewhere on the page accepts what was typed, as spreadsheets do; leaving the window does not. */
  private left(to: EventTarget | null): void {
    if (!this.editing || !to || this.root.contains(to as Node)) return;
    if (this.editor.text !== this.original) {
      this.commit("stay");
      return;
    }
    this.end();
    this.events.cancel(false);
  }

  private end(): void {
    this.editing = false;
    this.asked += 1;
    this.completion.hide();
    this.say("", null, false);
    this.reflect();
  }

  private showError(error: CellError | null): void {
    if (!error) {
      this.say("", null, false);
      return;
    }
    if (error.from !== null && error.to !== null) this.editor.setMarks([{ from: error.from, to: error.to }]);
    const origin = error.origin ? ` (${t("errorFrom", { address: error.origin })})` : "";
    this.say(error.message + origin, error.hint, true);
  }

  private say(message: string, hint: string | null, wrong: boolean): void {
    if (message === "" && this.message.hidden) return;
    this.message.hidden = message === "";
    this.message.classList.toggle("wrong", wrong);
    fill(this.message, el("span", {}, message), hint ? el("span", { class: "hint" }, hint) : null);
  }
}
