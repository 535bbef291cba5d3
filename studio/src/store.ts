import { addressOf, type Block, blockOf, type Place, placeOf } from "./sheet/address";
import type { Address, Camera, CellInfo, Drawing, Note, Poles, Undrawn, Update } from "./engine/protocol";
import { redrawn } from "./engine/redraw";

export interface Topics {
  /** Cells whose contents changed; null when all did. */
  cells: ReadonlySet<Address> | null;
  drawings: ReadonlySet<Address> | null;
  poles: undefined;
  selection: undefined;
  history: undefined;
  title: undefined;
  camera: Camera;
}

/** While a pole is dragged, the sheet is read anew this often, in milliseconds: nobody reads sixty numbers a second. */
export const READING = 100;

type Listener<K extends keyof Topics> = (value: Topics[K]) => void;

/** What the page knows of the sheet: a copy of what the kernel last said, and the selection. */
export class Store {
  readonly cells = new Map<Address, CellInfo>();
  readonly drawings = new Map<Address, Drawing>();
  readonly poles = new Map<Address, Poles>();
  readonly undrawn = new Map<Address, Undrawn>();
  /** Number of cells still to be computed. */
  pending = 0;
  notes: Note[] = [];
  title = "";
  canUndo = false;
  canRedo = false;
  anchor: Place = { column: 0, row: 0 };
  focus: Place = { column: 0, row: 0 };
  private readonly listeners = new Map<keyof Topics, Set<Listener<never>>>();
  /** Cells whose readers have not been told yet. */
  private unread = new Set<Address>();
  private reading: ReturnType<typeof setTimeout> | null = null;

  on<K extends keyof Topics>(topic: K, listener: Listener<K>): void {
    const known = this.listeners.get(topic) ?? new Set();
    known.add(listener as Listener<never>);
    this.listeners.set(topic, known);
  }

  private tell<K extends keyof Topics>(topic: K, value: Topics[K]): void {
    for (const listener of this.listeners.get(topic) ?? []) (listener as Listener<K>)(value);
  }

  get address(): Address {
    return addressOf(this.focus);
  }

  get selected(): CellInfo | undefined {
    return this.cells.get(this.address);
  }

  get block(): Block {
    return blockOf(this.anchor, this.focus);
  }

  /** Moves the selection; `anchor` stays where it is when the selection is extended. */
  select(focus: Place, extend = false): void {
    this.focus = focus;
    if (!extend) this.anchor = focus;
    this.tell("selection", undefined);
  }

  /**
   * Takes in what the kernel says has changed.
   *
   * `live`: one of many changes that follow each other, as in a drag. Pictures and poles follow each of them;
   * who writes texts is told every [`READING`] milliseconds, and at the end.
   */
  apply(update: Update, live = false): void {
    if (update.whole) {
      this.cells.clear();
      this.drawings.clear();
      this.poles.clear();
      this.undrawn.clear();
    }
    const touched = this.applyCells(update);
    const drawn = this.applyDrawings(update);
    const held = this.applyPoles(update);
    this.applyHeader(update);
    if (update.whole || update.notes) this.read(update.whole ? null : touched);
    else this.readLater(touched, live);
    if (update.whole || drawn.size > 0) this.tell("drawings", update.whole ? null : drawn);
    if (update.whole || held) this.tell("poles", undefined);
    if (update.camera) this.tell("camera", update.camera);
  }

  private readLater(touched: ReadonlySet<Address>, live: boolean): void {
    for (const address of touched) this.unread.add(address);
    if (!live) this.read(this.unread);
    else this.reading ??= setTimeout(() => this.read(this.unread), READING);
  }

  /** Tells who writes texts; null: all of them. */
  private read(touched: ReadonlySet<Address> | null): void {
    if (this.reading) clearTimeout(this.reading);
    this.reading = null;
    const all = touched && new Set([...this.unread, ...touched]);
    this.unread = new Set();
    this.tell("cells", all);
    this.tell("history", undefined);
  }

  private applyCells(update: Update): Set<Address> {
    const touched = new Set<Address>(update.removed);
    for (const address of update.removed) this.cells.delete(address);
    for (const cell of update.cells) {
      this.cells.set(cell.address, cell);
      touched.add(cell.address);
    }
    return touched;
  }

  /** The poles of a cell that was computed are those that came with it, or none. Did any change? */
  private applyPoles(update: Update): boolean {
    const nets = new Map(update.poles.map((net) => [net.address, net]));
    let changed = nets.size > 0;
    for (const address of [...update.removed, ...update.cells.map((cell) => cell.address)]) {
      if (!nets.has(address) && this.poles.delete(address)) changed = true;
    }
    for (const [address, net] of nets) this.poles.set(address, net);
    return changed;
  }

  private applyDrawings(update: Update): Set<Address> {
    const drawn = new Set<Address>();
    for (const address of [...update.hidden, ...update.removed]) {
      this.undrawn.delete(address);
      if (this.drawings.delete(address)) drawn.add(address);
    }
    for (const drawing of update.drawings) {
      this.drawings.set(drawing.address, redrawn(drawing, this.drawings.get(drawing.address)));
      this.undrawn.delete(drawing.address);
      drawn.add(drawing.address);
    }
    for (const trouble of update.undrawn) this.undrawn.set(trouble.address, trouble);
    return drawn;
  }

  private applyHeader(update: Update): void {
    if (update.title !== this.title || update.whole) {
      this.title = update.title;
      this.tell("title", undefined);
    }
    if (update.notes) this.notes = update.notes;
    this.pending = update.pending;
    this.canUndo = update.canUndo;
    this.canRedo = update.canRedo;
  }

  /** The size of the filled part of the sheet. */
  extent(): { columns: number; rows: number } {
    let columns = 0;
    let rows = 0;
    for (const address of this.cells.keys()) {
      const place = placeOf(address);
      if (!place) continue;
      columns = Math.max(columns, place.column + 1);
      rows = Math.max(rows, place.row + 1);
    }
    return { columns, rows };
  }
}
