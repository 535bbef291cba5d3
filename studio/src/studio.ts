import { el } from "./dom";
import type { EngineClient } from "./engine/client";
import { language, setLanguage } from "./i18n";
import { keptDraft } from "./keep";
import { Files } from "./panels/files";
import { Functions } from "./panels/functions";
import { Gallery } from "./panels/gallery";
import { Inspector } from "./panels/inspector";
import { Shortcuts } from "./panels/shortcuts";
import { splitter } from "./panels/splitter";
import { StatusBar } from "./panels/statusbar";
import { Toasts } from "./panels/toasts";
import { TopBar } from "./panels/topbar";
import { Session } from "./session";
import { Sheet } from "./sheet/sheet";
import { Store } from "./store";
import { Thumbnails } from "./view/thumbnails";
import { View } from "./view/view";
import { viewless } from "./view/viewless";

const EMPTY = "pfs = 1\n";

/** The whole page, put together. */
export class Studio {
  readonly root: HTMLElement;
  private readonly store = new Store();
  private readonly toasts = new Toasts();
  private readonly status: StatusBar;
  private readonly session: Session;
  private readonly sheet: Sheet;
  private readonly view: View | null;
  private readonly gallery: Gallery;
  private readonly thumbnails: Thumbnails;
  private readonly functions: Functions;
  private readonly shortcuts = new Shortcuts();
  private readonly files: Files;

  constructor(start: () => EngineClient) {
    const client = start();
    this.thumbnails = new Thumbnails(start);
    this.status = new StatusBar(
      this.store,
      () => void this.session.stop(),
      (on) => {
        this.root.classList.toggle("with-costs", on);
        this.sheet.showCosts(on);
      },
    );
    this.session = new Session(this.store, client, {
      error: (title, message, hint) => this.toasts.error(title, message, hint),
      info: (message) => this.toasts.info(message),
      kept: (phrase) => this.status.say(phrase),
    });
    client.onBusy = (count) => {
      this.status.setBusy(count);
      this.root.dataset["calls"] = String(count);
    };
    this.files = new Files(this.session, this.toasts);
    this.sheet = new Sheet(this.session);
    this.view = makeView(this.session);
    this.gallery = new Gallery({
      open: (figure) => void this.start(figure.text),
      reopen: (sheet) => void this.session.resume(sheet.snapshot, false).then(() => this.sheet.focus()),
      picture: (sheet) => this.thumbnails.picture(sheet),
    });
    this.functions = new Functions({
      catalogue: () => this.session.ask("catalogue"),
      use: (example) => this.sheet.beginEdit(example),
    });
    this.root = this.assemble(new Inspector(this.session));
    this.listen();
  }

  /** Opens what was kept from last time, else the first example. */
  async begin(kept: string | null, first: string): Promise<void> {
    if (language() !== "en") await this.session.ask("setLanguage", language());
    const restored = kept !== null && (await this.session.resume(kept, true));
    if (restored) this.status.say("restored");
    else await this.session.open(first);
    this.view?.recolor();
    if (keptDraft()) this.sheet.restoreDraft();
    else this.sheet.focus();
    this.root.dataset["ready"] = "";
  }

  /** Goes on with another sheet, the keyboard in its first cell. */
  private async start(text: string): Promise<void> {
    if (await this.session.open(text)) this.sheet.focus();
  }

  private assemble(inspector: Inspector): HTMLElement {
    const left = el("div", { class: "left" }, this.sheet.bar.root, this.sheet.root, inspector.root);
    const right = this.view?.root ?? viewless();
    return el(
      "div",
      { class: "studio" },
      this.topBar().root,
      el("main", { class: "work" }, left, splitter(left), right),
      this.status.root,
      this.toasts.root,
      this.gallery.root,
      this.functions.root,
      this.shortcuts.root,
      this.files.root,
    );
  }

  private topBar(): TopBar {
    return new TopBar(this.store, {
      blank: () => void this.start(EMPTY),
      open: () => this.files.choose(),
      save: () => void this.files.save(),
      export: (format) => void this.files.export(format),
      gallery: () => void this.gallery.show(),
      functions: () => void this.functions.show(),
      shortcuts: () => this.shortcuts.show(),
      undo: () => void this.session.change("undo"),
      redo: () => void this.session.change("redo"),
      language: () => void this.switchLanguage(),
      rename: (title) => void this.session.change("setTitle", title),
      theme: () => {
        this.view?.recolor();
        this.thumbnails.clear();
      },
    });
  }

  private async switchLanguage(): Promise<void> {
    const next = language() === "en" ? "fr" : "en";
    localStorage.setItem("pforms.language", next);
    const update = await this.session.ask("setLanguage", next);
    setLanguage(next);
    if (update) this.store.apply(update);
  }

  private listen(): void {
    document.addEventListener("keydown", (event) => {
      const command = event.ctrlKey || event.metaKey;
      if (event.key === "F6") this.nextPanel(event.shiftKey);
      else if (command && event.key.toLowerCase() === "s") void this.files.save();
      else if (command && event.key.toLowerCase() === "o") this.files.choose();
      else if (!this.historyKey(event)) return;
      event.preventDefault();
    });
  }

  /** Undo and redo work from anywhere except text fields, which have their own. */
  private historyKey(event: KeyboardEvent): boolean {
    const target = event.target as HTMLElement;
    if (event.defaultPrevented || /^(INPUT|TEXTAREA)$/.test(target.tagName)) return false;
    if (!event.ctrlKey && !event.metaKey) return false;
    const key = event.key.toLowerCase();
    if (key === "z") void this.session.change(event.shiftKey ? "redo" : "undo");
    else if (key === "y") void this.session.change("redo");
    else return false;
    return true;
  }

  /** Goes round: sheet, formula, style, view, top bar. */
  private nextPanel(back: boolean): void {
    const stops = [".grid td[tabindex='0']", ".editor-area", ".inspector input", ".view canvas", ".topbar button"]
      .map((selector) => this.root.querySelector<HTMLElement>(selector))
      .filter((stop) => stop !== null);
    const at = stops.findIndex((stop) => stop.closest("section, header, .sheet-scroll")?.contains(document.activeElement));
    stops.at((at + (back ? -1 : 1)) % stops.length)?.focus();
  }
}

/** A browser without WebGL still gets the sheet. */
function makeView(session: Session): View | null {
  try {
    return new View(session);
  } catch {
    return null;
  }
}

