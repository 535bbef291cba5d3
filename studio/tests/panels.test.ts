import { describe, expect, it } from "vitest";
import type { CellInfo, Operator } from "../src/engine/protocol";
import { preferredLanguage } from "../src/i18n";
import { TABLE } from "../src/i18n/table";
import { figureOf, groups } from "../src/panels/figures";
import { fileStem } from "../src/panels/files";
import { matches } from "../src/panels/functions";
import { defaultStyle, PALETTE } from "../src/panels/styles";
import { columnWidths } from "../src/sheet/widths";
import { Store } from "../src/store";
import { update } from "./update";

function cell(address: string, part: Partial<CellInfo> = {}): CellInfo {
  return {
    address,
    source: "1",
    text: "1",
    kind: "number",
    sort: "number",
    error: null,
    cost: null,
    name: null,
    style: null,
    modes: [],
    reads: [],
    pending: false,
    ...part,
  };
}

describe("languages", () => {
  it("say everything in both, with the same places to fill", () => {
    const places = (text: string): string[] => [...text.matchAll(/\{(\w+)\}/g)].map((match) => match[1]!).sort();
    for (const [key, phrase] of Object.entries(TABLE)) {
      expect(phrase.en.trim(), key).not.toBe("");
      expect(phrase.fr.trim(), key).not.toBe("");
      expect(places(phrase.fr), key).toEqual(places(phrase.en));
    }
  });

  it("follow the browser", () => {
    expect(preferredLanguage(["de-DE", "fr-CA", "en"])).toBe("fr");
    expect(preferredLanguage(["de"])).toBe("en");
  });
});

describe("the store", () => {
  it("keeps what an update does not mention", () => {
    const store = new Store();
    store.apply(update({ whole: true, cells: [cell("A1"), cell("B2")] }));
    store.apply(update({ cells: [cell("A1", { text: "2" })], removed: ["B2"], canUndo: true }));
    expect(store.cells.get("A1")?.text).toBe("2");
    expect(store.cells.has("B2")).toBe(false);
    expect(store.canUndo).toBe(true);
  });

  it("forgets everything when the sheet is replaced", () => {
    const store = new Store();
    store.apply(update({ cells: [cell("A1")], poles: [{ address: "A1", orders: [1], poles: [] }] }));
    store.apply(update({ whole: true, cells: [cell("C3")] }));
    expect([...store.cells.keys()]).toEqual(["C3"]);
    expect(store.poles.size).toBe(0);
    expect(store.extent()).toEqual({ columns: 3, rows: 3 });
  });

  it("drops the poles of a cell that is literal no more", () => {
    const store = new Store();
    store.apply(update({ cells: [cell("A1")], poles: [{ address: "A1", orders: [1], poles: [] }] }));
    store.apply(update({ cells: [cell("A1", { source: "=B1" })] }));
    expect(store.poles.has("A1")).toBe(false);
  });
});

describe("the gallery", () => {
  const text = 'pfs = 1\ntitle = "An \\"octant\\""\ntitle_fr = "Un octant"\n[cells]\n';

  it("reads titles and chapters", () => {
    expect(figureOf("../cases/sheets/octant.pfs", text)).toMatchObject({
      name: "octant",
      titles: { en: 'An "octant"', fr: "Un octant" },
      chapter: null,
    });
    expect(figureOf("x/pf_2236.pfs", "pfs = 1")).toMatchObject({ chapter: 2, titles: { en: "pf_2236", fr: "pf_2236" } });
  });

  it("groups examples first, then chapters", () => {
    const names = ["pf_212", "pf_111", "octant", "pf_130"];
    const sorted = groups(names.map((name) => figureOf(`${name}.pfs`, text)));
    expect(sorted.map(([chapter, figures]) => [chapter, figures.map((one) => one.name)])).toEqual([
      [null, ["octant"]],
      [1, ["pf_111", "pf_130"]],
      [2, ["pf_212"]],
    ]);
  });
});

describe("small things", () => {
  it("find functions by any word, without accents", () => {
    const operator = { name: "ELEVATION", aliases: ["ELEVATE"], group: "", summary: "élève l’ordre", help: "" };
    expect(matches(operator as unknown as Operator, "élev ordre")).toBe(true);
    expect(matches(operator as unknown as Operator, "diag")).toBe(false);
  });

  it("make file names from titles", () => {
    expect(fileStem("Octant de sphère, n° 1")).toBe("octant-de-sphere-n-1");
    expect(fileStem("???")).toBe("");
  });

  it("draw a form in its most usual way", () => {
    expect(defaultStyle(cell("A1", { modes: ["curve", "points", "net"] })).draw).toEqual(["curve"]);
    const style = defaultStyle(cell("A4", { modes: ["surface", "points", "net"] }));
    expect(style.draw).toEqual(["surface"]);
    expect(PALETTE).toContain(style.color);
  });

  it("give columns room for their texts, within bounds", () => {
    const widths = columnWidths([cell("A1"), cell("B1", { sort: "form", source: "=".repeat(500) })], 3);
    expect(widths[0]).toBe(widths[2]);
    expect(widths[1]).toBeGreaterThan(widths[0]!);
    expect(widths[1]).toBeLessThan(400);
  });
});
