import { el } from "../dom";
import type { ExportFormat } from "../engine/protocol";
import { localised, type Phrase, t } from "../i18n";
import type { Store } from "../store";
import { icon, type IconName } from "./icons";
import { themeButton } from "./theme";

export interface TopEvents {
  blank(): void;
  open(): void;
  save(): void;
  export(format: ExportFormat): void;
  gallery(): void;
  functions(): void;
  shortcuts(): void;
  undo(): void;
  redo(): void;
  language(): void;
  rename(title: string): void;
  theme(): void;
}

const FORMATS: [ExportFormat, Phrase][] = [
  ["glb", "exportGlb"],
  ["obj", "exportObj"],
  ["stl", "exportStl"],
  ["pov", "exportPov"],
];

/** The bar at the top: the sheet's title and what can be done with the sheet as a whole. */
export class TopBar {
  readonly root: HTMLElement;

  constructor(store: Store, events: TopEvents) {
    const undo = action("undo", "undo", "undo", () => events.undo(), true);
    const redo = action("redo", "redo", "redo", () => events.redo(), true);
    store.on("history", () => {
      undo.disabled = !store.canUndo;
      redo.disabled = !store.canRedo;
    });
    this.root = el(
      "header",
      { class: "topbar" },
      el("div", { class: "brand", aria: { hidden: "true" } }, mark(), el("span", {}, "pforms")),
      title(store, (text) => events.rename(text)),
      el("nav", { class: "actions" }, undo, redo, divider(), ...files(events), divider(), ...tools(events)),
    );
  }
}

function files(events: TopEvents): HTMLElement[] {
  return [
    action("newSheet", "newSheetHelp", "blank", () => events.blank()),
    action("gallery", "galleryHelp", "gallery", () => events.gallery()),
    action("open", "openHelp", "open", () => events.open()),
    action("save", "saveHelp", "save", () => events.save()),
    exportMenu((format) => events.export(format)),
  ];
}

function tools(events: TopEvents): HTMLElement[] {
  const language = el("button", { type: "button", class: "quiet language" });
  language.addEventListener("click", () => events.language());
  localised(() => {
    language.textContent = t("language");
    language.title = t("languageHelp");
  });
  return [
    action("functions", "functionsHelp", "functions", () => events.functions()),
    action("shortcuts", "shortcuts", "keyboard", () => events.shortcuts(), true),
    language,
    themeButton(() => events.theme()),
  ];
}

function action(label: Phrase, help: Phrase, name: IconName, act: () => void, bare = false): HTMLButtonElement {
  const text = el("span", {});
  const button = el("button", { type: "button", class: "quiet" }, icon(name), bare ? null : text);
  button.dataset["action"] = label;
  button.addEventListener("click", act);
  localised(() => {
    text.textContent = t(label);
    button.title = t(help);
    if (bare) button.setAttribute("aria-label", t(help));
  });
  return button;
}

function exportMenu(act: (format: ExportFormat) => void): HTMLElement {
  const menu = el("div", { class: "menu", role: "menu", popover: "auto", id: "export-menu" });
  const button = action("export", "export", "export", () => menu.togglePopover());
  button.setAttribute("aria-haspopup", "menu");
  for (const [format, phrase] of FORMATS) {
    const help = el("span", { class: "menu-help" });
    const item = el("button", { type: "button", role: "menuitem" }, el("b", {}, format.toUpperCase()), help);
    item.dataset["format"] = format;
    item.addEventListener("click", () => {
      menu.hidePopover();
      act(format);
    });
    localised(() => (help.textContent = t(phrase)));
    menu.append(item);
  }
  menu.addEventListener("toggle", () => {
    const box = button.getBoundingClientRect();
    menu.style.left = `${Math.min(box.left, window.innerWidth - menu.offsetWidth - 8)}px`;
    menu.style.top = `${box.bottom + 6}px`;
  });
  return el("div", {}, button, menu);
}

function title(store: Store, rename: (title: string) => void): HTMLElement {
  const field = el("input", { class: "title", type: "text", spellcheck: false });
  const show = (): void => {
    field.value = store.title;
    document.title = `${store.title || t("untitled")} · pforms`;
  };
  field.addEventListener("change", () => rename(field.value.trim()));
  field.addEventListener("keydown", (event) => {
    if (event.key === "Enter") field.blur();
  });
  store.on("title", show);
  localised(() => {
    field.placeholder = t("untitled");
    field.setAttribute("aria-label", t("title"));
    show();
  });
  return field;
}

function divider(): HTMLElement {
  return el("span", { class: "divider", aria: { hidden: "true" } });
}

/** The mark: a quarter of a disc and its diagonal arc. */
function mark(): SVGSVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.innerHTML =
    '<path d="M3 21C3 9 11 3 21 3L21 21Z" fill="var(--gold)"/>' +
    '<path d="M3 21C12 20.5 20 14 21 3" fill="none" stroke="var(--red)" stroke-width="2.4" stroke-linecap="round"/>';
  return svg;
}
