import { el, show } from "../dom";
import { localised, type Phrase, t } from "../i18n";
import type { Store } from "../store";
import { icon } from "./icons";

/** A computation shows only when it takes longer than this, in milliseconds. */
const PATIENCE = 350;

/** The foot of the page: whether work is going on, whether the sheet is safe, costs on or off. */
export class StatusBar {
  private readonly state = el("span", { class: "state", role: "status" });
  private readonly count = el("span", { class: "muted" });
  private readonly stop = el("button", { type: "button", class: "stop" });
  private readonly busy = el("span", { class: "busy", hidden: true }, el("span", { class: "spinner" }), this.stop);
  private readonly costs = el("button", { type: "button", class: "quiet" }, icon("cost"));
  readonly root = el("footer", { class: "statusbar" }, this.busy, this.state, el("span", { class: "gap" }), this.count, this.costs);
  private phrase: Phrase = "ready";
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(store: Store, stop: () => void, costs: (on: boolean) => void) {
    this.stop.addEventListener("click", stop);
    this.costs.setAttribute("aria-pressed", "false");
    this.costs.addEventListener("click", () => {
      const on = this.costs.getAttribute("aria-pressed") !== "true";
      this.costs.setAttribute("aria-pressed", String(on));
      costs(on);
    });
    const tell = (): void => {
      const count = t("cells", { count: String(store.cells.size) });
      if (this.count.textContent !== count) this.count.textContent = count;
    };
    store.on("cells", tell);
    localised(() => {
      this.stop.textContent = `${t("computing")} ${t("stop")}`;
      this.costs.title = t("costs");
      this.costs.setAttribute("aria-label", t("costs"));
      this.say(this.phrase);
      tell();
    });
  }

  say(phrase: Phrase): void {
    this.phrase = phrase;
    this.state.textContent = t(phrase);
    this.state.dataset["phrase"] = phrase;
  }

  /** Number of calls under way. */
  setBusy(count: number): void {
    if (count === 0) {
      if (this.timer) clearTimeout(this.timer);
      this.timer = null;
      show(this.busy, false);
    } else this.timer ??= setTimeout(() => show(this.busy, true), PATIENCE);
  }
}
