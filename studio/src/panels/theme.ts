import { el, fill } from "../dom";
import { localised, t } from "../i18n";
import { icon } from "./icons";

type Theme = "auto" | "light" | "dark";

const KEY = "pforms.theme";
const NEXT: Record<Theme, Theme> = { auto: "light", light: "dark", dark: "auto" };
const NAMES = { auto: "themeAuto", light: "themeLight", dark: "themeDark" } as const;

function chosen(): Theme {
  const kept = localStorage.getItem(KEY);
  return kept === "light" || kept === "dark" ? kept : "auto";
}

function wear(theme: Theme): void {
  document.documentElement.dataset["theme"] = theme;
  localStorage.setItem(KEY, theme);
}

/** A button that goes round: as the system, light, dark. */
export function themeButton(changed: () => void): HTMLButtonElement {
  const button = el("button", { type: "button", class: "quiet" });
  const show = (): void => {
    const theme = chosen();
    fill(button, icon(theme));
    button.title = `${t("theme")}: ${t(NAMES[theme])}`;
    button.setAttribute("aria-label", button.title);
  };
  button.dataset["action"] = "theme";
  button.addEventListener("click", () => {
    wear(NEXT[chosen()]);
    show();
    changed();
  });
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
  wear(chosen());
  localised(show);
  return button;
}
