import { el } from "../dom";
import { type Phrase, t } from "../i18n";
import { Dialog } from "./dialog";

const KEYS: [string[], Phrase][] = [
  [["←", "↑", "→", "↓"], "keyMove"],
  [["Enter", "F2"], "keyEdit"],
  [["Enter", "Tab"], "keyAccept"],
  [["Esc"], "keyEscape"],
  [["Del"], "keyDelete"],
  [["Ctrl Z", "Ctrl Y"], "keyUndo"],
  [["Ctrl C", "Ctrl X", "Ctrl V"], "keyCopy"],
  [["Ctrl D"], "keyFill"],
  [["Ctrl Enter"], "keyDraw"],
  [["Tab"], "keyComplete"],
  [["F6"], "keyPanels"],
  [["←", "↑", "+", "−", "F"], "keyView"],
  [["[", "]", "Enter"], "keyPole"],
  [["Shift"], "keyDrag"],
];

/** Keys that are called differently from one language to the other. */
const NAMES: Record<string, Phrase> = {
  Enter: "nameEnter",
  "Ctrl Enter": "nameCtrlEnter",
  Esc: "nameEscape",
  Del: "nameDelete",
  Shift: "nameShift",
};

function nameOf(key: string): string {
  const phrase = NAMES[key];
  return phrase ? t(phrase) : key;
}

/** What the keys do. */
export class Shortcuts {
  private readonly dialog = new Dialog("shortcuts", "shortcuts");
  readonly root = this.dialog.root;

  show(): void {
    const rows = KEYS.map(([keys, phrase]) =>
      el("tr", {}, el("th", { scope: "row" }, ...keys.map((key) => el("kbd", {}, nameOf(key)))), el("td", {}, t(phrase))),
    );
    this.dialog.show(el("table", {}, el("tbody", {}, ...rows)));
  }
}
