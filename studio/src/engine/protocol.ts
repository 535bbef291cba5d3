/**
 * What the studio may ask of the kernel, and what comes back.
 *
 * Every number a person can read arrives here as text made by Rust; typed arrays are for the graphics card only.
 * `bindings/wasm` implements these calls; `worker.ts` passes them through.
 */

export type Address = string;
export type Language = "en" | "fr";
export type DrawMode = "points" | "curve" | "surface" | "envelope" | "sheets" | "fibres" | "net" | "poles" | "normals";
export type ViewName = "OX" | "OY" | "OZ" | "AXO" | "PERSPECTIVE";
export type ExportFormat = "glb" | "obj" | "stl" | "pov";

/** How a cell is drawn. */
export interface Style {
  draw: DrawMode[];
  shading: "flat" | "smooth";
  /** `#rrggbb` */
  color: string;
  /** 0 … 1 */
  opacity: number;
  /** Each window is halved this many times; one number for all axes, or one per axis. */
  fineness: number | number[];
  /** Of points, curves and fibres, in the units of the sheet. */
  radius: number;
  /** Number of sheets or fibres per direction. */
  count: number;
  /** The axis that sheets lie across and fibres run along. */
  axis: number;
  /** Of normals. */
  length: number;
}

/** Why a cell has no value; `from`…`to` is the place in the cell's own source, in UTF-16 units. */
export interface CellError {
  message: string;
  hint: string | null;
  from: number | null;
  to: number | null;
  /** The cell where the error began, when it is another one. */
  origin: Address | null;
}

/** What a cell costs, ready to be shown. */
export interface Cost {
  time: string;
  orders: string;
  bytes: string;
}

/** What a value is, in no language: a page may rely on it. */
export type Sort = "empty" | "number" | "boolean" | "text" | "form" | "mesh" | "list" | "record" | "error";

export interface CellInfo {
  address: Address;
  /** As the person types it, in the current language's number style. */
  source: string;
  /** The value in short. */
  text: string;
  /** `pS33`, `number`, `text`, `list`, … in the current language. */
  kind: string;
  sort: Sort;
  error: CellError | null;
  cost: Cost | null;
  name: string | null;
  /** Absent when the cell is not drawn. */
  style: Style | null;
  /** The drawing ways that suit the value; empty when there is nothing to draw. */
  modes: DrawMode[];
  /** Cells that the formula reads. */
  reads: Address[];
  /** Not computed yet: the rest tells what it was. */
  pending: boolean;
}

/** A pole of a literal cell, which can be dragged. */
export interface Pole {
  index: number[];
  /** Null for a direction (weight 0): there is no place to put a handle. */
  position: [number, number, number] | null;
  /** Coordinates as texts, and the weight. */
  coordinates: string[];
  weight: string;
}

/** The control net of a literal cell. */
export interface Poles {
  address: Address;
  orders: number[];
  poles: Pole[];
}

/** Triangles: three numbers for each vertex, three vertices for each triangle. */
export interface MeshBuffers {
  positions: Float32Array;
  normals: Float32Array;
  indices: Uint32Array;
}

/** Points, drawn as spheres. */
export interface BallBuffers {
  positions: Float32Array;
  radius: number;
}

/** Plain buffers of a drawn cell; coordinates are the book's (y up, z away). */
export interface Drawing {
  address: Address;
  color: [number, number, number];
  opacity: number;
  meshes: MeshBuffers[];
  points: BallBuffers[];
}

/** A drawing as it travels: what is null is as it was when the cell was drawn last. */
export interface Redrawing {
  address: Address;
  color: [number, number, number];
  opacity: number;
  shape: {
    meshes: (Omit<MeshBuffers, "indices"> & { indices: Uint32Array | null })[];
    points: BallBuffers[];
  } | null;
}

/** Where the viewer stands; what is absent is fitted to the forms. */
export interface Camera {
  view?: ViewName;
  /** The axis that stands upright, `y` when absent. */
  up?: "y" | "z";
  position?: [number, number, number] | null;
  target?: [number, number, number] | null;
  /** Without perspective the picture shows `1 / zoom` across. */
  zoom?: number | null;
}

export interface Note {
  /** The cell it is about, or null for the whole sheet. */
  cell: Address | null;
  text: string;
}

/** What changed. */
export interface Update {
  title: string;
  cells: CellInfo[];
  removed: Address[];
  drawings: Redrawing[];
  hidden: Address[];
  poles: Poles[];
  camera: Camera | null;
  /** Remarks of the author, in the current language; null when they did not change. */
  notes: Note[] | null;
  canUndo: boolean;
  canRedo: boolean;
  /** True when the whole sheet was replaced: forget everything known before. */
  whole: boolean;
  /** Number of cells still to be computed: ask to `proceed`. */
  pending: number;
  /** Cells that are shown but cannot be drawn. */
  undrawn: Undrawn[];
}

/** Why a cell that is shown has no picture. */
export interface Undrawn {
  address: Address;
  message: string;
  hint: string | null;
}

/** Copied cells on their way to another place. */
export interface Clip {
  /** `A1:B3` */
  range: string;
  cells: [Address, string][];
}

export interface Parameter {
  name: string;
  help: string;
  /** Kind, unit, range and default in words. */
  detail: string;
  optional: boolean;
  variadic: boolean;
}

/** One operator, in one language. */
export interface Operator {
  name: string;
  aliases: string[];
  group: string;
  summary: string;
  help: string;
  signature: string;
  parameters: Parameter[];
  example: string;
}

export interface Diagnostic {
  message: string;
  hint: string | null;
  from: number;
  to: number;
}

/** What the formula bar needs at a caret: proposals, the call around the caret, and what is wrong. */
export interface Assistance {
  proposals: { name: string; insert: string; summary: string; signature: string }[];
  from: number;
  to: number;
  call: { operator: Operator; argument: number } | null;
  diagnostics: Diagnostic[];
}

export interface Exported {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}

export type Gesture = "begin" | "during" | "end";

/** The calls themselves. Each either answers or fails with a `Failure`. */
export interface Engine {
  open(pfs: string): Update;
  /** The sheet as a `.pfs` text. */
  save(): string;
  /** The sheet with its history, to be kept and given to `resume`. */
  snapshot(): string;
  resume(snapshot: string): Update;
  set(entries: [Address, string][]): Update;
  /** References in the copied formulas follow. */
  paste(clip: Clip, to: Address): Update;
  /** Copies one cell into a range. */
  fill(from: Address, range: string): Update;
  setStyle(address: Address, style: Style | null): Update;
  /** All changes until `endGesture` are one step of the history. */
  beginGesture(): null;
  endGesture(): Update;
  setName(address: Address, name: string | undefined): Update;
  setTitle(title: string): Update;
  setCamera(camera: Camera): null;
  setLanguage(language: Language): Update;
  undo(): Update;
  redo(): Update;
  /** Goes on computing what an earlier answer left pending. */
  proceed(): Update;
  /** `step` is the grid the coordinates are rounded to. */
  movePole(address: Address, index: number[], to: number[], step: number, gesture: Gesture): Update;
  /** Typed coordinates, and the weight last. */
  typePole(address: Address, index: number[], texts: string[]): Update;
  assist(text: string, caret: number): Assistance;
  catalogue(): Operator[];
  importFile(name: string, bytes: Uint8Array): Update;
  /** One file, or several that belong together, named `stem`. */
  exportFile(format: ExportFormat, stem: string): Exported[];
}

export type Method = keyof Engine;
export type Arguments<M extends Method> = Parameters<Engine[M]>;
export type Answer<M extends Method> = ReturnType<Engine[M]>;

/** An error a person can act on. `fatal` means that the worker is no longer usable. */
export interface Failure {
  message: string;
  hint: string | null;
  fatal: boolean;
}

export interface Request {
  id: number;
  method: Method;
  args: unknown[];
}

export type Response =
  | { id: number; value: unknown }
  | { id: number; failure: Failure };
