/** A sheet that comes with the studio. */
export interface Figure {
  /** File name without its ending, `pf_111`. */
  name: string;
  titles: { en: string; fr: string };
  text: string;
  /** Chapter of the book, or null for the other examples. */
  chapter: number | null;
}

/** Reads what the gallery shows of a sheet: its titles and, from its file name, its chapter. */
export function figureOf(path: string, text: string): Figure {
  const name = path.replace(/^.*\//, "").replace(/\.pfs$/, "");
  const en = titleLine(text, "title") ?? name;
  const chapter = /^pf_(\d)/.exec(name)?.[1];
  return {
    name,
    titles: { en, fr: titleLine(text, "title_fr") ?? en },
    text,
    chapter: chapter === undefined ? null : Number(chapter),
  };
}

function titleLine(text: string, key: string): string | null {
  const match = new RegExp(`^${key}\\s*=\\s*"((?:[^"\\\\]|\\\\.)*)"`, "m").exec(text);
  return match ? match[1]!.replace(/\\(.)/g, "$1") : null;
}

/** Examples first, then chapter by chapter; within a group by number. */
export function groups(figures: readonly Figure[]): [number | null, Figure[]][] {
  const chapters = [...new Set(figures.map((figure) => figure.chapter))];
  chapters.sort((a, b) => (a ?? 0) - (b ?? 0));
  return chapters.map((chapter) => [
    chapter,
    figures.filter((figure) => figure.chapter === chapter).sort((a, b) => (a.name < b.name ? -1 : 1)),
  ]);
}
