/** A bicubic surface over a square, its poles in three waves; every 16 poles can be dragged. */
export function sheet() {
  const rows = [0, 1, 2, 3].map((i) =>
    [0, 1, 2, 3].map((j) => `(${i / 3 - 0.5}, ${((i * 7 + j * 5) % 6) / 10}, ${j / 3 - 0.5})`.replace(/(\.\d{4})\d+/g, "$1")),
  );
  const net = `[${rows.map((row) => `[${row.join(", ")}]`).join(", ")}]`;
  return `pfs = 1
title = "A bicubic surface"

[cells]
A1 = "${net}"

[show.A1]
draw = ["surface"]
color = "#f2c14e"
fineness = 7
`;
}
