import { el } from "../dom";
import { language, t } from "../i18n";
import { forget, type KeptSheet, keptSheets } from "../keep";
import { Dialog } from "./dialog";
import { type Figure, figureOf, groups } from "./figures";
import { icon } from "./icons";

const FILES = import.meta.glob<string>("../../../cases/sheets/*.pfs", {
  query: "?raw",
  import: "default",
  eager: true,
});

const FIGURES = Object.entries(FILES).map(([path, text]) => figureOf(path, text));

/** The sheet of a figure by its name, or undefined. */
export function figure(name: string): Figure | undefined {
  return FIGURES.find((one) => one.name === name);
}

export interface GalleryEvents {
  open(figure: Figure): void;
  reopen(sheet: KeptSheet): void;
}

/** Sheets to start from: the figures of the book, and one's own earlier sheets. */
export class Gallery {
  private readonly dialog = new Dialog("gallery", "gallery");
  readonly root = this.dialog.root;

  constructor(private readonly events: GalleryEvents) {}

  async show(): Promise<void> {
    const kept = await keptSheets().catch(() => []);
    const parts: HTMLElement[] = [];
    for (const [chapter, figures] of groups(FIGURES)) {
      const heading = chapter === null ? t("groupExamples") : t("groupChapter", { n: String(chapter) });
      parts.push(el("h3", {}, heading), el("ul", { class: "cards" }, ...figures.map((one) => this.card(one))));
    }
    if (kept.length > 0) {
      parts.splice(0, 0, el("h3", {}, t("yours")), el("ul", { class: "cards" }, ...kept.map((one) => this.own(one))));
    }
    this.dialog.show(...(parts.length > 0 ? parts : [el("p", {}, t("galleryEmpty"))]));
  }

  private card(one: Figure): HTMLElement {
    const button = el(
      "button",
      { type: "button", class: "card" },
      el("span", { class: "card-title" }, one.titles[language()]),
      el("span", { class: "card-name" }, one.name),
    );
    button.dataset["figure"] = one.name;
    button.addEventListener("click", () => {
      this.dialog.close();
      this.events.open(one);
    });
    return el("li", {}, button);
  }

  private own(sheet: KeptSheet): HTMLElement {
    const when = new Date(sheet.at).toLocaleString(language(), { dateStyle: "medium", timeStyle: "short" });
    const button = el(
      "button",
      { type: "button", class: "card" },
      el("span", { class: "card-title" }, sheet.title || t("untitled")),
      el("span", { class: "card-name" }, when),
    );
    button.addEventListener("click", () => {
      this.dialog.close();
      this.events.reopen(sheet);
    });
    const drop = el("button", { type: "button", class: "quiet drop", title: t("forget") }, icon("cancel"));
    drop.setAttribute("aria-label", t("forget"));
    const item = el("li", {}, button, drop);
    drop.addEventListener("click", () => void forget(sheet.id).then(() => item.remove()));
    return item;
  }
}
