import { describe, expect, it } from "vitest";
import { addressOf, blockName, blockOf, columnName, placeOf, placesIn } from "../src/sheet/address";
import { fromClip, fromTable, parseTable, toClip, toTable } from "../src/sheet/clipboard";
import { gridAction, type Stroke } from "../src/sheet/keys";
import { references, tokens } from "../src/sheet/tokens";
import { Layout, scrolledTo } from "../src/sheet/window";

describe("addresses", () => {
  it("name columns as spreadsheets do", () => {
    expect([0, 25, 26, 51, 52, 701, 702].map(columnName)).toEqual(["A", "Z", "AA", "AZ", "BA", "ZZ", "AAA"]);
  });

  it("read what they write", () => {
    for (const column of [0, 7, 25, 26, 700, 701, 702]) {
      const place = { column, row: column * 3 };
      expect(placeOf(addressOf(place))).toEqual(place);
    }
  });

  it("accept dollars and small letters, and refuse what is no address", () => {
    expect(placeOf("$b$3")).toEqual({ column: 1, row: 2 });
    for (const wrong of ["", "A", "A0", "3", "ABCD1", "A1B", "A1:B2"]) expect(placeOf(wrong)).toBeNull();
  });

  it("make blocks from any two corners", () => {
    const block = blockOf({ column: 2, row: 0 }, { column: 0, row: 1 });
    expect(blockName(block)).toBe("A1:C2");
    expect([...placesIn(block)].map(addressOf)).toEqual(["A1", "B1", "C1", "A2", "B2", "C2"]);
  });
});

describe("the clipboard", () => {
  it("brings back what it took, whatever is in the cells", () => {
    const sources = ["=MIR(A1, A2)", 'a "quoted" one', "two\nlines", "with\ttab", '"', ""];
    const block = blockOf({ column: 0, row: 0 }, { column: 2, row: 1 });
    const text = toTable(block, ({ column, row }) => sources[row * 3 + column] ?? "");
    const back = fromTable(text, { column: 0, row: 0 });
    expect(back.map(([, source]) => source)).toEqual(sources);
    expect(back.map(([address]) => address)).toEqual(["A1", "B1", "C1", "A2", "B2", "C2"]);
  });

  it("carries cells with their places, and refuses what it did not make", () => {
    const clip = toClip(blockOf({ column: 0, row: 0 }, { column: 1, row: 0 }), [["A1", "=B1"]]);
    expect(clip).toEqual({ range: "A1:B1", cells: [["A1", "=B1"]] });
    expect(fromClip(JSON.stringify(clip))).toEqual(clip);
    for (const wrong of ["", "null", "3", '{"range":1}', "{"]) expect(fromClip(wrong)).toBeNull();
  });

  it("reads tables of other programs", () => {
    expect(parseTable("1\t2\r\n3\t4\r\n")).toEqual([
      ["1", "2"],
      ["3", "4"],
    ]);
    expect(parseTable('"open')).toEqual([['"open']]);
    expect(parseTable("")).toEqual([[""]]);
  });
});

describe("the layout", () => {
  const layout = new Layout([100, 50, 200, 100, 100, 100, 100, 100, 100, 100, 100, 100], 1_000_000, 32);

  it("knows where columns are", () => {
    expect([0, 99, 100, 149, 150, 349, 5000].map((x) => layout.columnAt(x))).toEqual([0, 0, 1, 1, 2, 2, 11]);
    expect([layout.x(2), layout.width, layout.y(3)]).toEqual([150, 1250, 96]);
  });

  it("lays out what is seen and a little more, however long the sheet", () => {
    const seen = { x: 0, y: 32 * 500_000, width: 300, height: 640 };
    const window = layout.windowOn(seen);
    expect(window).toEqual({ left: 0, top: 499_984, columns: 7, rows: 52 });
    expect(layout.covers(window, seen)).toBe(true);
    expect(layout.covers(window, { ...seen, y: seen.y + 32 * 30 })).toBe(false);
  });

  it("scrolls no more than needed", () => {
    expect([scrolledTo(100, 50, 110, 140), scrolledTo(100, 50, 80, 90), scrolledTo(100, 50, 140, 170)]).toEqual([100, 80, 120]);
    expect(scrolledTo(0, 50, 100, 300)).toBe(100);
  });
});

describe("keys", () => {
  const stroke = (key: string, more: Partial<Stroke> = {}): Stroke => ({
    key,
    ctrlKey: false,
    metaKey: false,
    shiftKey: false,
    altKey: false,
    ...more,
  });

  it("move, select and jump", () => {
    expect(gridAction(stroke("ArrowDown"))).toEqual({ do: "move", columns: 0, rows: 1, extend: false, far: false });
    expect(gridAction(stroke("ArrowLeft", { shiftKey: true, ctrlKey: true }))).toEqual({
      do: "move",
      columns: -1,
      rows: 0,
      extend: true,
      far: true,
    });
    expect(gridAction(stroke("Tab", { shiftKey: true }))).toMatchObject({ do: "move", columns: -1 });
  });

  it("start editing: in place with F2 and Enter, anew with a letter", () => {
    expect(gridAction(stroke("F2"))).toEqual({ do: "edit", text: null });
    expect(gridAction(stroke("Enter"))).toEqual({ do: "edit", text: null });
    expect(gridAction(stroke("="))).toEqual({ do: "edit", text: "=" });
    expect(gridAction(stroke("é"))).toEqual({ do: "edit", text: "é" });
  });

  it("undo and redo on every kind of keyboard", () => {
    expect(gridAction(stroke("z", { ctrlKey: true }))).toEqual({ do: "undo" });
    expect(gridAction(stroke("Z", { metaKey: true, shiftKey: true }))).toEqual({ do: "redo" });
    expect(gridAction(stroke("y", { ctrlKey: true }))).toEqual({ do: "redo" });
  });

  it("leave alone what the browser needs", () => {
    for (const key of ["F5", "Shift", "Control"]) expect(gridAction(stroke(key))).toBeNull();
    expect(gridAction(stroke("r", { ctrlKey: true }))).toBeNull();
    expect(gridAction(stroke("v", { ctrlKey: true }))).toBeNull();
  });
});

describe("tokens", () => {
  it("cover the text without gaps", () => {
    const text = '=MIR($A$1, "a ""b""", 1.5e-3) + racine(2)×É_1 § 😀';
    const found = tokens(text);
    expect(found.map((token) => text.slice(token.from, token.to)).join("")).toBe(text);
  });

  it("tell functions, names and references apart", () => {
    const kinds = tokens("=LOG2(A2)+octant").map((token) => token.kind);
    expect(kinds).toEqual(["mark", "function", "mark", "reference", "mark", "mark", "name"]);
  });

  it("list references once, in order", () => {
    expect(references("=MIR(b2, $A$1, B2)")).toEqual(["B2", "A1"]);
    expect(references("A1 is text")).toEqual([]);
    expect(references(`=${"A1+".repeat(50_000)}1`)).toEqual([]);
  });
});
