import type { Clip } from "../engine/protocol";
import { addressOf, areaOf, type Block, blockName, type Place } from "./address";

/** Larger blocks are copied for ourselves only: other programs would get mostly empty cells. */
const TABLE_CELLS = 100_000;

/** Our own kind of clipboard contents: formulas pasted from it follow their new place. */
export const CLIP = "application/x-pforms-cells";

export function toClip(block: Block, cells: [string, string][]): Clip {
  return { range: blockName(block), cells };
}

/** Reads what [`toClip`] made; null for anything else. */
export function fromClip(text: string): Clip | null {
  try {
    const clip = JSON.parse(text) as Partial<Clip> | null;
    return typeof clip?.range === "string" && Array.isArray(clip.cells) ? (clip as Clip) : null;
  } catch {
    return null;
  }
}

/** Sources as other spreadsheets expect them: tabs between columns, line ends between rows. Empty for huge blocks. */
export function toTable(block: Block, sourceAt: (place: Place) => string): string {
  if (areaOf(block) > TABLE_CELLS) return "";
  const rows: string[] = [];
  for (let row = block.top; row <= block.bottom; row++) {
    const fields: string[] = [];
    for (let column = block.left; column <= block.right; column++) {
      fields.push(quoted(sourceAt({ column, row })));
    }
    rows.push(fields.join("\t"));
  }
  return rows.join("\n");
}

/** The cells that a pasted table fills, from its top left corner. */
export function fromTable(text: string, corner: Place): [string, string][] {
  const entries: [string, string][] = [];
  parseTable(text).forEach((fields, row) => {
    fields.forEach((field, column) => {
      const place = { column: corner.column + column, row: corner.row + row };
      entries.push([addressOf(place), field]);
    });
  });
  return entries;
}

function quoted(field: string): string {
  return /[\t\n\r]/.test(field) || field.startsWith('"') ? `"${field.replaceAll('"', '""')}"` : field;
}

/** Reads tab-separated text; a field in quotes may hold tabs and line ends. */
export function parseTable(text: string): string[][] {
  const rows: string[][] = [[]];
  let at = 0;
  while (at <= text.length) {
    const [field, end] = text[at] === '"' ? quotedField(text, at) : plainField(text, at);
    rows[rows.length - 1]!.push(field);
    if (end >= text.length) break;
    if (text[end] === "\t") at = end + 1;
    else {
      at = end + (text.startsWith("\r\n", end) ? 2 : 1);
      if (at >= text.length) break;
      rows.push([]);
    }
  }
  return rows;
}

function plainField(text: string, start: number): [string, number] {
  let end = start;
  while (end < text.length && !"\t\n\r".includes(text[end]!)) end++;
  return [text.slice(start, end), end];
}

function quotedField(text: string, start: number): [string, number] {
  let field = "";
  let at = start + 1;
  while (at < text.length) {
    if (text[at] === '"' && text[at + 1] === '"') {
      field += '"';
      at += 2;
    } else if (text[at] === '"') {
      const after = text[at + 1];
      if (after === undefined || "\t\n\r".includes(after)) return [field, at + 1];
      break;
    } else field += text[at++];
  }
  return plainField(text, start);
}
