import type { CellInfo } from "../engine/protocol";
import { placeOf } from "./address";

const LEAST = 128;
const MOST = 300;
/** Width of a letter, and of everything else in a cell, in pixels. */
const LETTER = 7.3;
const FRAME = 30;
const BADGES = 66;

/** The width of each column: as its longest text wants it, within bounds. */
export function columnWidths(cells: Iterable<CellInfo>, columns: number): number[] {
  const widths = new Array<number>(columns).fill(LEAST);
  for (const cell of cells) {
    const column = placeOf(cell.address)?.column ?? columns;
    if (column >= columns) continue;
    const plain = cell.sort === "number" || cell.sort === "text";
    const letters = plain ? cell.text.length : cell.source.length;
    const wanted = Math.ceil(letters * LETTER + FRAME + (plain ? 0 : BADGES));
    widths[column] = Math.max(widths[column]!, Math.min(MOST, wanted));
  }
  return widths;
}
