/** What a key means while a cell (not its text) has the focus. */
export type GridAction =
  | { do: "move"; columns: number; rows: number; extend: boolean; far: boolean }
  | { do: "home"; all: boolean }
  | { do: "edit"; text: string | null }
  | { do: "clear" }
  | { do: "undo" | "redo" | "copy" | "cut" | "selectAll" | "fill" | "toggleDraw" | "leave" };

/** The part of a `KeyboardEvent` that matters. */
export interface Stroke {
  key: string;
  ctrlKey: boolean;
  metaKey: boolean;
  shiftKey: boolean;
  altKey: boolean;
}

const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** The action of a key stroke, or null when the sheet has no use for it. */
export function gridAction(stroke: Stroke): GridAction | null {
  const command = stroke.ctrlKey || stroke.metaKey;
  const arrow = ARROWS[stroke.key];
  if (arrow && !stroke.altKey) {
    return { do: "move", columns: arrow[0], rows: arrow[1], extend: stroke.shiftKey, far: command };
  }
  if (command) return commandAction(stroke);
  if (stroke.altKey) return null;
  return plainAction(stroke);
}

function commandAction(stroke: Stroke): GridAction | null {
  switch (stroke.key.toLowerCase()) {
    case "z":
      return { do: stroke.shiftKey ? "redo" : "undo" };
    case "y":
      return { do: "redo" };
    case "c":
      return { do: "copy" };
    case "x":
      return { do: "cut" };
    case "a":
      return { do: "selectAll" };
    case "d":
      return { do: "fill" };
    case "enter":
      return { do: "toggleDraw" };
    case "home":
      return { do: "home", all: true };
    default:
      return null;
  }
}

function plainAction(stroke: Stroke): GridAction | null {
  const step = (columns: number, rows: number): GridAction => ({
    do: "move",
    columns,
    rows,
    extend: stroke.shiftKey && stroke.key.startsWith("Page"),
    far: false,
  });
  switch (stroke.key) {
    case "Enter":
      return stroke.shiftKey ? step(0, -1) : { do: "edit", text: null };
    case "F2":
      return { do: "edit", text: null };
    case "Tab":
      return step(stroke.shiftKey ? -1 : 1, 0);
    case "Escape":
      return { do: "leave" };
    case "Delete":
    case "Backspace":
      return { do: "clear" };
    case "Home":
      return { do: "home", all: false };
    case "PageDown":
      return step(0, 20);
    case "PageUp":
      return step(0, -20);
    default:
      return stroke.key.length === 1 ? { do: "edit", text: stroke.key } : null;
  }
}
