/** The part of a sheet that is laid out: cells from `left`, `top`, so many columns and rows. */
export interface Window {
  left: number;
  top: number;
  columns: number;
  rows: number;
}

/** What a scrolled container shows, in pixels. */
export interface Seen {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Columns and rows laid out beyond what is seen, so that a little scrolling lays out nothing. */
const MARGIN_COLUMNS = 4;
const MARGIN_ROWS = 16;

/** Where columns and rows lie, in pixels. A sheet may have a million rows; only some are laid out. */
export class Layout {
  /** The left edge of each column, and the right edge of the last. */
  private readonly edges: number[];

  constructor(
    widths: readonly number[],
    readonly rows: number,
    readonly rowHeight: number,
  ) {
    this.edges = [0];
    for (const width of widths) this.edges.push(this.edges.at(-1)! + width);
  }

  get columns(): number {
    return this.edges.length - 1;
  }

  get width(): number {
    return this.edges.at(-1)!;
  }

  get height(): number {
    return this.rows * this.rowHeight;
  }

  x(column: number): number {
    return this.edges[Math.min(column, this.columns)]!;
  }

  y(row: number): number {
    return row * this.rowHeight;
  }

  /** The column at a place. */
  columnAt(x: number): number {
    let [low, high] = [0, Math.max(0, this.columns - 1)];
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (this.edges[middle]! <= x) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** The cells that are seen, with a margin. */
  windowOn(seen: Seen): Window {
    const left = Math.max(0, this.columnAt(seen.x) - MARGIN_COLUMNS);
    const right = Math.min(this.columns, this.columnAt(seen.x + seen.width) + 1 + MARGIN_COLUMNS);
    const top = Math.max(0, Math.floor(seen.y / this.rowHeight) - MARGIN_ROWS);
    const bottom = Math.min(this.rows, Math.ceil((seen.y + seen.height) / this.rowHeight) + MARGIN_ROWS);
    return { left, top, columns: Math.max(0, right - left), rows: Math.max(0, bottom - top) };
  }

  /** Whether all that is seen lies in a window. */
  covers(window: Window, seen: Seen): boolean {
    const right = this.x(window.left + window.columns);
    const bottom = this.y(window.top + window.rows);
    return (
      this.x(window.left) <= seen.x &&
      this.y(window.top) <= seen.y &&
      (right >= seen.x + seen.width || right >= this.width) &&
      (bottom >= seen.y + seen.height || bottom >= this.height)
    );
  }
}

/** The scroll position nearest to `at` that shows the stretch from `start` to `end`. */
export function scrolledTo(at: number, size: number, start: number, end: number): number {
  if (start < at) return start;
  return end > at + size ? Math.min(start, end - size) : at;
}
