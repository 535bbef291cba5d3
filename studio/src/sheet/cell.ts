import { el, fill } from "../dom";
import type { CellInfo, Sort } from "../engine/protocol";
import { t } from "../i18n";

/** Values that are read as they stand; the others are shown by their kind and their source. */
const PLAIN: ReadonlySet<Sort> = new Set<Sort>(["number", "text", "boolean", "empty"]);

/** Longest text put into a cell: what does not fit the column cannot be seen anyway. */
const SHOWN = 120;

/** Writes one cell of the table; `costs` tells whether there is room for what it cost. */
export function paintCell(
  cell: HTMLTableCellElement,
  info: CellInfo | undefined,
  draft: string | null,
  costs: boolean,
): void {
  if (draft !== null) {
    cell.className = "draft";
    cell.title = "";
    fill(cell, el("span", { class: "text" }, draft.slice(0, SHOWN)));
    return;
  }
  if (!info) {
    cell.className = cell.title = "";
    fill(cell);
    return;
  }
  if (info.error) paintError(cell, info);
  else if (PLAIN.has(info.sort)) paintPlain(cell, info);
  else paintForm(cell, info);
  if (info.name) cell.prepend(el("span", { class: "cell-name" }, info.name));
  if (info.pending) {
    cell.classList.add("pending");
    cell.title = t("pending");
  }
  if (info.cost && costs) {
    const { time, bytes } = info.cost;
    cell.append(el("span", { class: "cell-cost" }, [time, bytes].filter(Boolean).join(" · ")));
  }
}

function paintPlain(cell: HTMLTableCellElement, info: CellInfo): void {
  cell.className = info.sort;
  cell.title = info.source.slice(0, SHOWN);
  fill(cell, el("span", { class: "text" }, info.text.slice(0, SHOWN)));
}

function paintForm(cell: HTMLTableCellElement, info: CellInfo): void {
  cell.className = "form";
  cell.title = `${info.kind}  ${info.text}`.slice(0, 3 * SHOWN);
  fill(
    cell,
    dot(info),
    el("span", { class: "kind" }, info.kind),
    el("span", { class: "text" }, info.source.slice(0, SHOWN)),
  );
}

function paintError(cell: HTMLTableCellElement, info: CellInfo): void {
  cell.className = "error";
  cell.title = [info.error?.message, info.error?.hint].filter(Boolean).join("\n");
  fill(
    cell,
    el("span", { class: "kind", aria: { hidden: "true" } }, "!"),
    el("span", { class: "text" }, (info.error?.message ?? "").slice(0, SHOWN)),
  );
}

function dot(info: CellInfo): HTMLElement | null {
  if (info.modes.length === 0) return null;
  const mark = el("span", { class: info.style ? "dot on" : "dot", title: t("toggleDraw", { address: info.address }) });
  if (info.style) {
    mark.style.setProperty("--dot", info.style.color);
    mark.append(el("span", { class: "hidden" }, t("drawn")));
  }
  return mark;
}
