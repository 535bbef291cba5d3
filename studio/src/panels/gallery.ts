import { el } from "../dom";
import { language, t } from "../i18n";
import { forget, type KeptSheet, keptSheets } from "../keep";
import { Dialog } from "./dialog";
import { type Figure, figureOf, groups } from "./figures";
import { icon } from "./icons";
import type { Pictured } from "../view/thumbnails";

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
  /** The address of a small picture of a sheet. */
  picture(sheet: Pictured): Promise<string | null>;
}

interface Waiting {
  image: HTMLImageElement;
  sheet: Pictured;
}

/** Sheets to start from: the figures of the book, and one's own earlier sheets. */
export class Gallery {
  private readonly dialog = new Dialog("gallery", "gallery");
  readonly root = this.dialog.root;

  private waiting: Waiting[] = [];

  constructor(private readonly events: GalleryEvents) {}

  async show(): Promise<void> {
    const kept = await keptSheets().catch(() => []);
    const parts: HTMLElement[] = [];
    this.waiting = [];
    if (kept.length > 0) {
      parts.push(el("h3", {}, t("yours")), el("ul", { class: "cards" }, ...kept.map((one) => this.own(one))));
    }
    for (const [chapter, figures] of groups(FIGURES)) {
      const heading = chapter === null ? t("groupExamples") : t("groupChapter", { n: String(chapter) });
      parts.push(el("h3", {}, heading), el("ul", { class: "cards" }, ...figures.map((one) => this.card(one))));
    }
    this.dialog.show(...(parts.length > 0 ? parts : [el("p", {}, t("galleryEmpty"))]));
    await this.paint();
  }

  /** Fills in the pictures one after another while the gallery is open, those in sight before the others. */
  private async paint(): Promise<void> {
    const { waiting } = this;
    while (waiting.length > 0 && this.root.open && waiting === this.waiting) {
      const inSight = waiting.findIndex(({ image }) => this.shows(image));
      const [{ image, sheet }] = waiting.splice(Math.max(inSight, 0), 1) as [Waiting];
      const address = await this.events.picture(sheet);
      if (address) image.src = address;
    }
  }

  private shows(image: HTMLImageElement): boolean {
    const frame = this.root.getBoundingClientRect();
    const { top, bottom } = image.getBoundingClientRect();
    return bottom > frame.top && top < frame.bottom;
  }

  private image(sheet: Pictured): HTMLImageElement {
    const image = el("img", { class: "card-picture", alt: "" });
    this.waiting.push({ image, sheet });
    return image;
  }

  private card(one: Figure): HTMLElement {
    const button = el(
      "button",
      { type: "button", class: "card" },
      this.image({ method: "open", text: one.text }),
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
      this.image({ method: "resume", text: sheet.snapshot }),
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
