import type { Language } from "../engine/protocol";
import { type Phrase, TABLE } from "./table";

export type { Phrase } from "./table";

let current: Language = "en";
const listeners = new Set<() => void>();

/** The language a browser asks for, English when it is none of ours. */
export function preferredLanguage(tags: readonly string[]): Language {
  for (const tag of tags) {
    const code = tag.slice(0, 2).toLowerCase();
    if (code === "fr" || code === "en") return code;
  }
  return "en";
}

export function language(): Language {
  return current;
}

export function setLanguage(next: Language): void {
  current = next;
  document.documentElement.lang = next;
  for (const listener of listeners) listener();
}

/** The phrase in the current language, with `{name}` filled in. */
export function t(phrase: Phrase, values: Record<string, string> = {}): string {
  return TABLE[phrase][current].replace(/\{(\w+)\}/g, (whole, name: string) => values[name] ?? whole);
}

/** Runs now, and again whenever the language changes. */
export function localised(write: () => void): void {
  listeners.add(write);
  write();
}
