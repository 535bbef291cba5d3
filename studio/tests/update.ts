import type { Update } from "../src/engine/protocol";

/** An answer of the kernel that changes nothing but what is given. */
export function update(part: Partial<Update> = {}): Update {
  return {
    title: "",
    cells: [],
    removed: [],
    drawings: [],
    hidden: [],
    poles: [],
    camera: null,
    notes: null,
    canUndo: false,
    canRedo: false,
    whole: false,
    pending: 0,
    undrawn: [],
    ...part,
  };
}
