import { el } from "../dom";
import { localised, t } from "../i18n";

const LEAST = 300;
const STEP = 24;
const KEY = "pforms.split";

/** The bar between sheet and view; dragged, or moved with the arrow keys. */
export function splitter(left: HTMLElement): HTMLElement {
  const bar = el("div", { class: "splitter", role: "separator", tabIndex: 0, aria: { orientation: "vertical" } });
  const set = (width: number): void => {
    const most = Math.max(LEAST, window.innerWidth - LEAST);
    const bounded = Math.round(Math.max(LEAST, Math.min(most, width)));
    left.style.setProperty("--left", `${bounded}px`);
    bar.setAttribute("aria-valuenow", String(bounded));
    localStorage.setItem(KEY, String(bounded));
  };
  const kept = Number(localStorage.getItem(KEY));
  if (kept >= LEAST) set(kept);
  bar.addEventListener("pointerdown", (event) => bar.setPointerCapture(event.pointerId));
  bar.addEventListener("pointermove", (event) => {
    if (bar.hasPointerCapture(event.pointerId)) set(event.clientX);
  });
  bar.addEventListener("keydown", (event) => {
    const step = event.key === "ArrowLeft" ? -STEP : event.key === "ArrowRight" ? STEP : 0;
    if (step === 0) return;
    event.preventDefault();
    set(left.offsetWidth + step);
  });
  localised(() => bar.setAttribute("aria-label", t("resize")));
  return bar;
}
