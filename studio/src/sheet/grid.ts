import { el, fill } from "../dom";
import { localised, t } from "../i18n";
import type { Store } from "../store";
import { addressOf, columnName, inBlock, type Place, placeOf } from "./address";
import { paintCell } from "./cell";
import { columnWidths } from "./widths";
import { Layout, scrolledTo, type Seen, type Window } from "./window";

const LEAST_COLUMNS = 12;
const LEAST_ROWS = 40;
const SPARE = 8;
/** Width of the row numbers and height of the column letters, in pixels, as in the style sheet. */
const HEADS = { width: 40, height: 26 };
const ROW = 32;
const TALL_ROW = 46;

/** What the grid reports to the rest of the sheet. */
export interface GridEvents {
  pick(place: Place, extend: boolean): void;
  edit(): void;
  toggleDraw(place: Place): void;
}

/** The table of cells. It lays out what is seen, shows what the store holds, and reports the mouse. */
export class Grid {
  readonly table = el("table", {
    class: "grid",
    role: "grid",
    tabIndex: -1,
    aria: { multiselectable: "true" },
  });
  private readonly extent = el("div", { class: "grid-extent" }, this.table);
  readonly root = el("div", { class: "sheet-scroll" }, this.extent);
  private readonly cells = new Map<string, HTMLTableCellElement>();
  private layout = new Layout([], 0, ROW);
  private window: Window = { left: 0, top: 0, columns: 0, rows: 0 };
  private draft: { address: string; text: string } | null = null;
  private outlined: readonly string[] = [];
  private tall = false;

  constructor(
    private readonly store: Store,
    private readonly events: GridEvents,
  ) {
    store.on("cells", (touched) => this.refresh(touched));
    store.on("selection", () => this.follow());
    this.root.addEventListener("scroll", () => this.scrolled());
    new ResizeObserver(() => this.scrolled()).observe(this.root);
    localised(() => {
      this.table.setAttribute("aria-label", t("sheet"));
      this.refresh(null);
    });
    this.listen();
  }

  get size(): { columns: number; rows: number } {
    return this.layout;
  }

  /** Gives the keyboard to the selected cell, or to the table while that cell is out of sight. */
  focus(): void {
    const cell = this.cells.get(this.store.address) ?? this.table;
    cell.focus({ preventScroll: true });
  }

  /** Makes room for the costs under the values, or takes it back. */
  showCosts(on: boolean): void {
    this.tall = on;
    this.refresh(null);
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
    for (const address of this.outlined) delete this.cells.get(address)?.dataset["read"];
    this.outlined = addresses;
    this.showOutlines();
  }

  private showOutlines(): void {
    this.outlined.forEach((address, order) => {
      const cell = this.cells.get(address);
      if (cell) cell.dataset["read"] = String(order % 6);
    });
  }

  private refresh(touched: ReadonlySet<string> | null): void {
    if (touched && !this.grownBy(touched)) for (const address of touched) this.paint(address);
    else this.measure();
  }

  /** Whether one of these cells is so near to the border of the table that it must grow. */
  private grownBy(touched: ReadonlySet<string>): boolean {
    for (const address of touched) {
      const place = placeOf(address);
      if (place && (place.column + 2 >= this.layout.columns || place.row + SPARE >= this.layout.rows)) return this.grown();
    }
    return false;
  }

  /** Whether what is filled or selected has come near the border of the table. */
  private grown(): boolean {
    const { columns, rows } = this.wanted();
    return columns > this.layout.columns || rows > this.layout.rows;
  }

  private wanted(): { columns: number; rows: number } {
    const { columns, rows } = this.store.extent();
    const { focus } = this.store;
    return {
      columns: Math.max(LEAST_COLUMNS, columns + 2, focus.column + 1),
      rows: Math.max(LEAST_ROWS, rows + SPARE, focus.row + 1),
    };
  }

  /** Finds out how large the sheet is, and lays out what is seen of it. */
  private measure(): void {
    const { columns, rows } = this.wanted();
    const widths = columnWidths(this.store.cells.values(), columns);
    this.layout = new Layout(widths, rows, this.tall ? TALL_ROW : ROW);
    this.extent.style.width = `${HEADS.width + this.layout.width}px`;
    this.extent.style.height = `${HEADS.height + this.layout.height}px`;
    this.table.setAttribute("aria-colcount", String(columns + 1));
    this.table.setAttribute("aria-rowcount", String(rows + 1));
    this.layOut();
  }

  private seen(): Seen {
    const { scrollLeft, scrollTop, clientWidth, clientHeight } = this.root;
    return {
      x: scrollLeft,
      y: scrollTop,
      width: Math.max(0, clientWidth - HEADS.width),
      height: Math.max(0, clientHeight - HEADS.height),
    };
  }

  private scrolled(): void {
    const seen = this.seen();
    const reached = { ...seen, x: Math.min(seen.x, this.layout.width), y: Math.min(seen.y, this.layout.height) };
    if (!this.layout.covers(this.window, reached)) this.layOut();
  }

  /** Makes the cells of the window anew. */
  private layOut(): void {
    const focused = this.table.contains(document.activeElement);
    this.window = this.layout.windowOn(this.seen());
    const { left, top, rows } = this.window;
    this.cells.clear();
    const body = el("tbody");
    for (let row = top; row < top + rows; row++) body.append(this.row(row));
    fill(this.table, this.columnGroup(), this.head(), body);
    this.table.style.left = `${this.layout.x(left)}px`;
    this.table.style.top = `${this.layout.y(top)}px`;
    for (const address of this.cells.keys()) this.paint(address);
    this.showSelection();
    this.showOutlines();
    if (focused) this.focus();
  }

  private columnGroup(): HTMLElement {
    const group = el("colgroup", {}, el("col", { class: "row-heads" }));
    const { left, columns } = this.window;
    for (let column = left; column < left + columns; column++) {
      const col = el("col");
      col.style.width = `${this.layout.x(column + 1) - this.layout.x(column)}px`;
      group.append(col);
    }
    const width = this.layout.x(left + columns) - this.layout.x(left);
    this.table.style.width = `${HEADS.width + width}px`;
    return group;
  }

  private head(): HTMLElement {
    const row = el("tr", { aria: { rowindex: "1" } }, el("td", { class: "corner" }));
    const { left, columns } = this.window;
    for (let column = left; column < left + columns; column++) {
      row.append(el("th", { scope: "col", data: { column: String(column) } }, columnName(column)));
    }
    return el("thead", {}, row);
  }

  private row(row: number): HTMLElement {
    const line = el("tr", { aria: { rowindex: String(row + 2) } });
    line.append(el("th", { scope: "row", data: { row: String(row) } }, String(row + 1)));
    const { left, columns } = this.window;
    for (let column = left; column < left + columns; column++) {
      const address = addressOf({ column, row });
      const place = { colindex: String(column + 2) };
      const cell = el("td", { role: "gridcell", tabIndex: -1, data: { address }, aria: place });
      this.cells.set(address, cell);
      line.append(cell);
    }
    return line;
  }

  private paint(address: string): void {
    const cell = this.cells.get(address);
    if (!cell) return;
    const draft = this.draft?.address === address ? this.draft.text : null;
    paintCell(cell, this.store.cells.get(address), draft, this.tall);
  }

  /** Brings the selected cell into sight and marks it. */
  private follow(): void {
    if (this.grown()) this.measure();
    const { column, row } = this.store.focus;
    const { layout, root } = this;
    const { width, height } = this.seen();
    const x = scrolledTo(root.scrollLeft, width, layout.x(column), layout.x(column + 1));
    const y = scrolledTo(root.scrollTop, height, layout.y(row), layout.y(row + 1));
    if (width > 0 && x !== root.scrollLeft) root.scrollLeft = x;
    if (height > 0 && y !== root.scrollTop) root.scrollTop = y;
    this.scrolled();
    this.showSelection();
  }

  private showSelection(): void {
    const { focus, block } = this.store;
    for (const marked of this.table.querySelectorAll<HTMLElement>("td[aria-selected], td[data-focus], th[data-active]")) {
      for (const mark of ["aria-selected", "data-active", "data-focus"]) marked.removeAttribute(mark);
      if (marked.tabIndex === 0) marked.tabIndex = -1;
    }
    for (const [address, cell] of this.cells) {
      const place = placeOf(address);
      if (place && inBlock(block, place)) cell.setAttribute("aria-selected", "true");
    }
    const cell = this.cells.get(addressOf(focus));
    if (!cell) return;
    cell.tabIndex = 0;
    cell.dataset["focus"] = "";
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
