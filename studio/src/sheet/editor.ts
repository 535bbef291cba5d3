import { el, fill } from "../dom";
import { COLOURED_LENGTH, references, tokens } from "./tokens";

/** A place to underline. */
export interface Mark {
  from: number;
  to: number;
}

export interface EditorEvents {
  /** The text or the caret changed. */
  change(): void;
  key(event: KeyboardEvent): void;
  focus(): void;
  blur(to: EventTarget | null): void;
}

/** One text field whose text is coloured and underlined: a mirror behind a transparent text area. */
export class Editor {
  readonly area = el("textarea", {
    rows: 1,
    spellcheck: false,
    autocapitalize: "off",
    autocomplete: "off",
    class: "editor-area",
  });
  private readonly mirror = el("pre", { class: "editor-mirror", aria: { hidden: "true" } });
  readonly root = el("div", { class: "editor" }, this.mirror, this.area);
  private marks: Mark[] = [];

  constructor(events: EditorEvents) {
    this.area.setAttribute("autocorrect", "off");
    this.area.addEventListener("input", () => {
      this.marks = [];
      this.paint();
      events.change();
    });
    this.area.addEventListener("keydown", (event) => events.key(event));
    this.area.addEventListener("keyup", (event) => {
      if (event.key.startsWith("Arrow") || event.key === "Home" || event.key === "End") events.change();
    });
    this.area.addEventListener("click", () => events.change());
    this.area.addEventListener("focus", () => {
      this.open();
      events.focus();
    });
    this.area.addEventListener("blur", (event) => events.blur(event.relatedTarget));
    this.area.addEventListener("scroll", () => this.alignMirror());
  }

  get text(): string {
    return this.area.value;
  }

  get caret(): number {
    return this.area.selectionStart;
  }

  setText(text: string, caret = text.length): void {
    if (this.area.value !== text) this.area.value = text;
    this.area.setSelectionRange(caret, caret);
    this.marks = [];
    this.paint();
  }

  /** Replaces a part of the text and puts the caret behind it. */
  splice(from: number, to: number, text: string, caret = from + text.length): void {
    const all = this.text;
    this.setText(all.slice(0, from) + text + all.slice(to), caret);
  }

  setMarks(marks: Mark[]): void {
    this.marks = marks;
    this.paint();
  }

  private paint(): void {
    const text = this.text;
    fill(this.mirror, ...this.pieces(text), "\n");
    // Only a field in use opens up; asking for its height costs a layout of the page.
    if (document.activeElement === this.area) this.open();
  }

  /** Makes the field as high as its text. */
  private open(): void {
    this.area.style.height = "0";
    this.area.style.height = `${this.area.scrollHeight}px`;
    this.alignMirror();
  }

  private alignMirror(): void {
    this.mirror.scrollTop = this.area.scrollTop;
  }

  private pieces(text: string): Node[] {
    if (text.length > COLOURED_LENGTH || !text.startsWith("=")) return this.plain(text);
    const order = references(text);
    return tokens(text).map((token) => {
      const piece = text.slice(token.from, token.to);
      const span = el("span", { class: `t-${token.kind}` }, piece);
      if (token.kind === "reference") {
        span.dataset["read"] = String(order.indexOf(piece.replaceAll("$", "").toUpperCase()) % 6);
      }
      if (this.marks.some((mark) => token.from < mark.to && token.to > mark.from)) span.classList.add("wrong");
      return span;
    });
  }

  /** Uncoloured text, with the first mark underlined. */
  private plain(text: string): Node[] {
    const mark = this.marks[0];
    if (!mark || text.length > COLOURED_LENGTH) return [document.createTextNode(text)];
    return [
      document.createTextNode(text.slice(0, mark.from)),
      el("span", { class: "wrong" }, text.slice(mark.from, mark.to)),
      document.createTextNode(text.slice(mark.to)),
    ];
  }
}
