import { el } from "../dom";
import { localised, t } from "../i18n";

/** What stands in place of the view when the browser has no WebGL 2. */
export function viewless(): HTMLElement {
  const message = el("p", { class: "nothing" });
  localised(() => (message.textContent = t("noWebgl")));
  return el("section", { class: "view" }, message);
}
