import { keepDraft, keptDraft } from "../keep";
import type { Session } from "../session";
import { defaultStyle } from "../panels/styles";
import { addressOf, blockName, inBlock, LAST, type Place, placeOf } from "./address";
import { CLIP, fromClip, fromTable, toClip, toTable } from "./clipboard";
import { FormulaBar, type Leave } from "./formulabar";
import { Grid } from "./grid";
import { type GridAction, gridAction } from "./keys";
import { references } from "./tokens";

const STEPS: Record<Leave, [number, number]> = {
  stay: [0, 0],
  down: [0, 1],
  up: [0, -1],
  right: [1, 0],
  left: [-1, 0],
};

/** The table and its formula bar, working as one spreadsheet. */
export class Sheet {
  private readonly grid: Grid;
  readonly bar: FormulaBar;
  readonly root: HTMLElement;
  /** The cell whose text is being typed. */
  private edited = "A1";
  /** After Escape, Tab leaves the table instead of moving in it. */
  private leaving = false;

  constructor(private readonly session: Session) {
    const { store } = session;
    this.grid = new Grid(store, {
      pick: (place, extend) => this.pick(place, extend),
      edit: () => this.beginEdit(null),
      toggleDraw: (place) => void this.toggleDraw(place),
    });
    this.bar = new FormulaBar({
      assist: (text, caret) => session.ask("assist", text, caret),
      draft: (text) => this.drafted(text),
      commit: (text, leave) => void this.commit(text, leave),
      cancel: (back) => this.cancelled(back),
      goTo: (address) => this.goTo(address),
    });
    this.root = this.grid.root;
    this.listen();
    store.on("selection", () => this.showSelected());
    store.on("cells", (touched) => {
      if (!touched || touched.has(store.address) || touched.has(this.edited)) this.showSelected();
    });
  }

  focus(): void {
    this.grid.focus();
  }

  showCosts(on: boolean): void {
    this.grid.showCosts(on);
  }

  /** Takes up the text that was being typed when the page went away. */
  restoreDraft(): void {
    const draft = keptDraft();
    const place = draft && placeOf(draft.address);
    if (!draft || !place) return;
    this.session.store.select(place);
    this.beginEdit(draft.text);
  }

  /** Begins to type in the selected cell. */
  beginEdit(text: string | null): void {
    this.edited = this.session.store.address;
    this.bar.edit(text);
  }

  /** Draws a cell or stops drawing it. */
  async toggleDraw(place: Place): Promise<void> {
    const cell = this.session.store.cells.get(addressOf(place));
    if (!cell || cell.modes.length === 0) return;
    await this.session.setStyle(cell.address, cell.style ? null : defaultStyle(cell));
  }

  private listen(): void {
    const { table } = this.grid;
    table.addEventListener("keydown", (event) => this.key(event));
    table.addEventListener("copy", (event) => this.copy(event));
    table.addEventListener("cut", (event) => {
      this.copy(event);
      void this.clear();
    });
    table.addEventListener("paste", (event) => void this.paste(event));
  }

  private key(event: KeyboardEvent): void {
    if (event.key === "Tab" && this.leaving) return;
    this.leaving = false;
    const action = gridAction(event);
    if (!action || action.do === "copy" || action.do === "cut") return;
    event.preventDefault();
    this.act(action);
  }

  private act(action: GridAction): void {
    const { store } = this.session;
    switch (action.do) {
      case "move":
        this.move(action.columns, action.rows, action.extend, action.far);
        break;
      case "home":
        this.go({ column: 0, row: action.all ? 0 : store.focus.row }, false);
        break;
      case "edit":
        this.beginEdit(action.text);
        break;
      case "clear":
        void this.clear();
        break;
      case "undo":
      case "redo":
        void this.session.change(action.do);
        break;
      case "selectAll":
        this.selectAll();
        break;
      case "fill":
        void this.fillDown();
        break;
      case "toggleDraw":
        void this.toggleDraw(store.focus);
        break;
      case "leave":
        this.leaving = true;
        store.select(store.focus);
        break;
    }
  }

  private go(place: Place, extend: boolean): void {
    const column = Math.max(0, Math.min(place.column, LAST.column));
    const row = Math.max(0, Math.min(place.row, LAST.row));
    this.session.store.select({ column, row }, extend);
    this.grid.focus();
  }

  private move(columns: number, rows: number, extend: boolean, far: boolean): void {
    const from = this.session.store.focus;
    let place = { column: from.column + columns, row: from.row + rows };
    if (far) place = this.edge(from, columns, rows);
    this.go(place, extend);
  }

  /** Where a jump ends: the next filled cell in this direction, or the border of the sheet. */
  private edge(from: Place, columns: number, rows: number): Place {
    const { store } = this.session;
    const size = this.grid.size;
    let place = from;
    for (;;) {
      const next = { column: place.column + columns, row: place.row + rows };
      if (next.column < 0 || next.row < 0 || next.column >= size.columns || next.row >= size.rows) return place;
      place = next;
      if (store.cells.has(addressOf(place))) return place;
    }
  }

  private selectAll(): void {
    const { store } = this.session;
    const { columns, rows } = store.extent();
    store.select({ column: 0, row: 0 });
    store.select({ column: Math.max(0, columns - 1), row: Math.max(0, rows - 1) }, true);
    this.grid.focus();
  }

  private pick(place: Place, extend: boolean): void {
    const { store } = this.session;
    if (this.bar.editing) {
      if (!extend && this.bar.insertReference(addressOf(place))) return;
      if (!extend) this.bar.commit("stay");
    }
    store.select(place, extend);
    this.grid.focus();
  }

  private goTo(address: string): void {
    const place = placeOf(address) ?? this.named(address);
    if (place) this.go(place, false);
    else this.showSelected();
  }

  private named(name: string): Place | null {
    for (const cell of this.session.store.cells.values()) {
      if (cell.name?.toLowerCase() === name.trim().toLowerCase()) return placeOf(cell.address);
    }
    return null;
  }

  private drafted(text: string): void {
    keepDraft({ address: this.edited, text });
    this.grid.showDraft(this.edited, text);
    this.grid.outline(references(text));
  }

  private async commit(text: string, leave: Leave): Promise<void> {
    const { store } = this.session;
    const address = this.edited;
    const place = placeOf(address);
    const [columns, rows] = STEPS[leave];
    if (place && leave !== "stay") this.go({ column: place.column + columns, row: place.row + rows }, false);
    if (text !== (store.cells.get(address)?.source ?? "")) {
      const done = await this.session.change("set", [[address, text]]);
      if (!done) return;
    }
    keepDraft(null);
    this.grid.showDraft(null);
    this.showSelected();
  }

  private cancelled(back: boolean): void {
    keepDraft(null);
    this.grid.showDraft(null);
    this.showSelected();
    if (back) this.grid.focus();
  }

  private async clear(): Promise<void> {
    const emptied = this.filled().map(([address]): [string, string] => [address, ""]);
    if (emptied.length > 0) await this.session.change("set", emptied);
  }

  /** The selected cells that hold something, with their sources. */
  private filled(): [string, string][] {
    const { cells, block } = this.session.store;
    const selected = (address: string): boolean => {
      const place = placeOf(address);
      return place !== null && inBlock(block, place);
    };
    return [...cells.values()].filter((cell) => selected(cell.address)).map((cell) => [cell.address, cell.source]);
  }

  private copy(event: ClipboardEvent): void {
    const { store } = this.session;
    const source = (place: Place): string => store.cells.get(addressOf(place))?.source ?? "";
    event.clipboardData?.setData("text/plain", toTable(store.block, source));
    event.clipboardData?.setData(CLIP, JSON.stringify(toClip(store.block, this.filled())));
    event.preventDefault();
  }

  private async paste(event: ClipboardEvent): Promise<void> {
    event.preventDefault();
    const { block } = this.session.store;
    const corner = { column: block.left, row: block.top };
    const clip = fromClip(event.clipboardData?.getData(CLIP) ?? "");
    if (clip) await this.session.change("paste", clip, addressOf(corner));
    else {
      const entries = fromTable(event.clipboardData?.getData("text/plain") ?? "", corner);
      if (entries.length > 0) await this.session.change("set", entries);
    }
  }

  /** Copies the first row of the selection into the others. */
  private async fillDown(): Promise<void> {
    const { left, right, top, bottom } = this.session.store.block;
    for (let column = left; column <= right; column++) {
      const range = { left: column, right: column, top, bottom };
      await this.session.change("fill", addressOf({ column, row: top }), blockName(range));
    }
  }

  private showSelected(): void {
    const { store } = this.session;
    const cell = store.selected;
    if (!this.bar.editing) {
      this.edited = store.address;
      this.grid.outline(cell?.reads ?? []);
    }
    this.bar.show(this.bar.editing ? this.edited : blockName(store.block), cell?.source ?? "", cell?.error ?? null);
  }
}
