import { el } from "../dom";
import type { ViewName } from "../engine/protocol";
import { localised, type Phrase, t } from "../i18n";
import { icon, type IconName } from "../panels/icons";

const VIEWS: ViewName[] = ["OX", "OY", "OZ", "AXO", "PERSPECTIVE"];

export interface ToolEvents {
  look(view: ViewName): void;
  fit(): void;
  axes(on: boolean): void;
  handles(on: boolean): void;
  snap(on: boolean): void;
  /** Whether the axis z stands upright. */
  upright(on: boolean): void;
}

/** The small controls that float over the view. */
export class ViewTools {
  private readonly buttons = new Map<ViewName, HTMLButtonElement>();
  private readonly upright: HTMLButtonElement;
  readonly root: HTMLElement;

  constructor(events: ToolEvents) {
    const views = el("div", { class: "segmented", role: "group" });
    for (const view of VIEWS) {
      const button = el("button", { type: "button" });
      button.addEventListener("click", () => events.look(view));
      localised(() => {
        button.textContent = view === "PERSPECTIVE" ? t("viewPERSPECTIVEshort") : view;
        button.title = t(`view${view}`);
      });
      this.buttons.set(view, button);
      views.append(button);
    }
    this.upright = toggle("upright", "upright", false, (on) => events.upright(on));
    const fit = plain("fit", "fit", () => events.fit());
    this.root = el(
      "div",
      { class: "view-tools" },
      views,
      el(
        "div",
        { class: "segmented" },
        fit,
        this.upright,
        toggle("axes", "axes", true, (on) => events.axes(on)),
        toggle("handles", "handles", true, (on) => events.handles(on)),
        toggle("snap", "snap", false, (on) => events.snap(on)),
      ),
    );
  }

  showUpright(on: boolean): void {
    this.upright.setAttribute("aria-pressed", String(on));
  }

  /** Marks the view that is on. */
  show(view: ViewName): void {
    for (const [name, button] of this.buttons) button.setAttribute("aria-pressed", String(name === view));
  }
}

function plain(phrase: Phrase, name: IconName, act: () => void): HTMLButtonElement {
  const button = el("button", { type: "button", class: "with-icon" }, icon(name));
  button.addEventListener("click", act);
  localised(() => {
    button.title = t(phrase);
    button.setAttribute("aria-label", t(phrase));
  });
  return button;
}

function toggle(phrase: Phrase, name: IconName, on: boolean, act: (on: boolean) => void): HTMLButtonElement {
  const button = plain(phrase, name, () => {
    const next = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(next));
    act(next);
  });
  button.setAttribute("aria-pressed", String(on));
  return button;
}
