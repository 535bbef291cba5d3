import { el, fill } from "../dom";
import { localised, t } from "../i18n";
import type { Store } from "../store";
import { addressOf, columnName, type Place, placeOf, placesIn } from "./address";
import { paintCell } from "./cell";
import { columnWidths } from "./widths";

const LEAST_COLUMNS = 12;
const LEAST_ROWS = 40;
const SPARE = 8;

/** What the grid reports to the rest of the sheet. */
export interface GridEvents {
  pick(place: Place, extend: boolean): void;
  edit(): void;
  toggleDraw(place: Place): void;
}

/** The table of cells. It shows what the store holds and reports the mouse; keys are the sheet's affair. */
export class Grid {
  readonly table = el("table", { class: "grid", role: "grid", aria: { multiselectable: "true" } });
  private readonly cells = new Map<string, HTMLTableCellElement>();
  private columns = 0;
  private rows = 0;
  private draft: { address: string; text: string } | null = null;
  private marked: HTMLTableCellElement[] = [];

  constructor(
    private readonly store: Store,
    private readonly events: GridEvents,
  ) {
    this.resize();
    store.on("cells", (touched) => this.refresh(touched));
    store.on("selection", () => this.showSelection());
    localised(() => {
      this.table.setAttribute("aria-label", t("sheet"));
      this.refresh(null);
    });
    this.listen();
  }

  get size(): { columns: number; rows: number } {
    return { columns: this.columns, rows: this.rows };
  }

  /** Gives the keyboard to the selected cell. */
  focus(): void {
    this.cellAt(this.store.focus)?.focus({ preventScroll: true });
  }

  /** Shows text being typed in place of the cell's own; null ends it. */
  showDraft(address: string | null, text = ""): void {
    const before = this.draft?.address;
    this.draft = address === null ? null : { address, text };
    if (before && before !== address) this.paint(before);
    if (address) this.paint(address);
  }

  /** Outlines the cells that a formula reads. */
  outline(addresses: readonly string[]): void {
    for (const cell of this.marked) delete cell.dataset["read"];
    this.marked = [];
    addresses.forEach((address, order) => {
      const cell = this.cells.get(address);
      if (!cell) return;
      cell.dataset["read"] = String(order % 6);
      this.marked.push(cell);
    });
  }

  private refresh(touched: ReadonlySet<string> | null): void {
    const { columns, rows } = this.store.extent();
    const grown = columns + 2 > this.columns || rows + SPARE > this.rows;
    if (touched && !grown) {
      for (const address of touched) this.paint(address);
      return;
    }
    this.resize();
    for (const address of this.store.cells.keys()) this.paint(address);
    this.showSelection();
  }

  private resize(): void {
    const { columns, rows } = this.store.extent();
    this.columns = Math.max(LEAST_COLUMNS, columns + 2, this.store.focus.column + 1);
    this.rows = Math.max(LEAST_ROWS, rows + SPARE, this.store.focus.row + 1);
    this.table.setAttribute("aria-colcount", String(this.columns + 1));
    this.table.setAttribute("aria-rowcount", String(this.rows + 1));
    this.cells.clear();
    const body = el("tbody");
    for (let row = 0; row < this.rows; row++) body.append(this.row(row));
    fill(this.table, this.columnWidths(), this.head(), body);
  }

  private columnWidths(): HTMLElement {
    const group = el("colgroup", {}, el("col", { class: "row-heads" }));
    const widths = columnWidths(this.store.cells.values(), this.columns);
    for (const width of widths) {
      const column = el("col");
      column.style.width = `${width}px`;
      group.append(column);
    }
    this.table.style.setProperty("--width", `${widths.reduce((sum, width) => sum + width, 0)}px`);
    return group;
  }

  private head(): HTMLElement {
    const row = el("tr", { aria: { rowindex: "1" } }, el("td", { class: "corner" }));
    for (let column = 0; column < this.columns; column++) {
      row.append(el("th", { scope: "col", data: { column: String(column) } }, columnName(column)));
    }
    return el("thead", {}, row);
  }

  private row(row: number): HTMLElement {
    const line = el("tr", { aria: { rowindex: String(row + 2) } });
    line.append(el("th", { scope: "row", data: { row: String(row) } }, String(row + 1)));
    for (let column = 0; column < this.columns; column++) {
      const address = addressOf({ column, row });
      const cell = el("td", {
        role: "gridcell",
        tabIndex: -1,
        data: { address },
        aria: { colindex: String(column + 2) },
      });
      this.cells.set(address, cell);
      line.append(cell);
    }
    return line;
  }

  private paint(address: string): void {
    const cell = this.cells.get(address);
    if (!cell) return;
    const draft = this.draft?.address === address ? this.draft.text : null;
    paintCell(cell, this.store.cells.get(address), draft);
  }

  private cellAt(place: Place): HTMLTableCellElement | undefined {
    return this.cells.get(addressOf(place));
  }

  private showSelection(): void {
    const { focus, block } = this.store;
    if (focus.column >= this.columns || focus.row >= this.rows) {
      this.resize();
      for (const address of this.store.cells.keys()) this.paint(address);
    }
    for (const cell of this.table.querySelectorAll<HTMLElement>("td[aria-selected], th[data-active]")) {
      cell.removeAttribute("aria-selected");
      cell.removeAttribute("data-active");
      cell.removeAttribute("data-focus");
      if (cell.tabIndex === 0) cell.tabIndex = -1;
    }
    const right = Math.min(block.right, this.columns - 1);
    const bottom = Math.min(block.bottom, this.rows - 1);
    for (const place of placesIn({ ...block, right, bottom })) {
      this.cellAt(place)?.setAttribute("aria-selected", "true");
    }
    const cell = this.cellAt(focus);
    if (!cell) return;
    cell.tabIndex = 0;
    cell.dataset["focus"] = "";
    cell.scrollIntoView({ block: "nearest", inline: "nearest" });
    this.table.querySelector(`th[data-column="${focus.column}"]`)?.setAttribute("data-active", "");
    this.table.querySelector(`th[data-row="${focus.row}"]`)?.setAttribute("data-active", "");
  }

  private listen(): void {
    this.table.addEventListener("mousedown", (event) => {
      const place = placeUnder(event);
      if (!place || event.button !== 0) return;
      event.preventDefault();
      if ((event.target as Element).closest(".dot")) this.events.toggleDraw(place);
      else this.events.pick(place, event.shiftKey);
    });
    this.table.addEventListener("mouseover", (event) => {
      const place = placeUnder(event);
      if (place && event.buttons === 1) this.events.pick(place, true);
    });
    this.table.addEventListener("dblclick", (event) => {
      if (placeUnder(event)) this.events.edit();
    });
  }
}

function placeUnder(event: MouseEvent): Place | null {
  const cell = (event.target as Element).closest<HTMLElement>("td[data-address]");
  return cell ? placeOf(cell.dataset["address"] ?? "") : null;
}

