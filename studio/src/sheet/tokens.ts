/** A piece of formula text, for colouring only; meaning is the kernel's affair. */
export interface Token {
  from: number;
  to: number;
  kind: "number" | "text" | "reference" | "name" | "function" | "mark" | "space";
}

const PIECE =
  /(?<text>"(?:[^"]|"")*"?)|(?<reference>\$?[A-Za-z]{1,3}\$?[1-9]\d*(?![\p{L}\p{N}_(]))|(?<number>\d+(?:[.,]\d+)?(?:[eE][+-]?\d+)?)|(?<name>[\p{L}_][\p{L}\p{N}_]*)|(?<space>\s+)|(?<mark>.)/gsu;

/** Longer texts are left uncoloured: nobody reads colours in them, and the page stays quick. */
export const COLOURED_LENGTH = 6000;

export function tokens(text: string): Token[] {
  const found: Token[] = [];
  for (const match of text.matchAll(PIECE)) {
    const from = match.index;
    const to = from + match[0].length;
    found.push({ from, to, kind: kindOf(match, text, to) });
  }
  return found;
}

function kindOf(match: RegExpMatchArray, text: string, to: number): Token["kind"] {
  const groups = match.groups ?? {};
  if (groups["name"]) return /^\s*\(/.test(text.slice(to, to + 8)) ? "function" : "name";
  for (const kind of ["text", "reference", "number", "space"] as const) {
    if (groups[kind]) return kind;
  }
  return "mark";
}

/** The cells a formula mentions, in the order of their first appearance. */
export function references(text: string): string[] {
  if (!text.startsWith("=") || text.length > COLOURED_LENGTH) return [];
  const seen = new Set<string>();
  for (const token of tokens(text)) {
    if (token.kind === "reference") seen.add(text.slice(token.from, token.to).replaceAll("$", "").toUpperCase());
  }
  return [...seen];
}
