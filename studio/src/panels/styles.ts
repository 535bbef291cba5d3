import type { CellInfo, DrawMode, Style } from "../engine/protocol";

/** Quiet colours that stand apart from one another, on light and on dark ground. */
export const PALETTE = [
  "#e8b84a",
  "#d9573f",
  "#3f8f6b",
  "#3c7fb1",
  "#8a63a8",
  "#d98b9a",
  "#8aa35a",
  "#c9c4b8",
] as const;

/** How a cell is drawn when it is switched on: its most usual way, in a colour of its own. */
export function defaultStyle(cell: CellInfo): Style {
  const mode: DrawMode = cell.modes[0] ?? "points";
  return {
    draw: [mode],
    shading: "smooth",
    color: PALETTE[hash(cell.address) % PALETTE.length] ?? PALETTE[0],
    opacity: mode === "surface" || mode === "envelope" ? 0.9 : 1,
    fineness: 5,
    radius: 0.012,
    count: 5,
    axis: 0,
    length: 0.1,
  };
}

function hash(text: string): number {
  let sum = 0;
  for (const letter of text) sum = sum * 31 + letter.charCodeAt(0);
  return sum;
}
