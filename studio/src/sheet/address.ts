/** Places in the sheet: `column` and `row` count from 0, `B3` is column 1, row 2. */
export interface Place {
  column: number;
  row: number;
}

/** A rectangle of cells, both corners included. */
export interface Block {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** `0 → A`, `25 → Z`, `26 → AA`. */
export function columnName(column: number): string {
  let name = "";
  for (let n = column + 1; n > 0; n = Math.floor((n - 1) / 26)) {
    name = String.fromCharCode(65 + ((n - 1) % 26)) + name;
  }
  return name;
}

export function addressOf(place: Place): string {
  return columnName(place.column) + String(place.row + 1);
}

/** The place an address names, or null when it is none. */
export function placeOf(address: string): Place | null {
  const match = /^\$?([A-Za-z]{1,3})\$?([1-9]\d{0,6})$/.exec(address.trim());
  if (!match) return null;
  const letters = match[1]!.toUpperCase();
  let column = 0;
  for (const letter of letters) column = column * 26 + letter.charCodeAt(0) - 64;
  return { column: column - 1, row: Number(match[2]) - 1 };
}

export function blockOf(a: Place, b: Place): Block {
  return {
    left: Math.min(a.column, b.column),
    right: Math.max(a.column, b.column),
    top: Math.min(a.row, b.row),
    bottom: Math.max(a.row, b.row),
  };
}

export function inBlock(block: Block, place: Place): boolean {
  const across = place.column >= block.left && place.column <= block.right;
  return across && place.row >= block.top && place.row <= block.bottom;
}

export function areaOf(block: Block): number {
  return (block.right - block.left + 1) * (block.bottom - block.top + 1);
}

/** The last column and row a sheet can have. */
export const LAST: Place = { column: 18_277, row: 999_999 };

/** Row by row. */
export function* placesIn(block: Block): Generator<Place> {
  for (let row = block.top; row <= block.bottom; row++) {
    for (let column = block.left; column <= block.right; column++) yield { column, row };
  }
}

/** `A1` for one cell, `A1:B3` for more. */
export function blockName(block: Block): string {
  const first = addressOf({ column: block.left, row: block.top });
  const last = addressOf({ column: block.right, row: block.bottom });
  return first === last ? first : `${first}:${last}`;
}
