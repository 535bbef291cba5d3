/** Line drawings of 16 × 16, in the colour of the text. */
const PATHS = {
  undo: "M5.5 3 2.5 6l3 3M2.5 6h6.5a4 4 0 0 1 0 8H6",
  redo: "M10.5 3l3 3-3 3M13.5 6H7a4 4 0 0 0 0 8h3",
  gallery: "M2 2.5h5v5H2zM9 2.5h5v5H9zM2 9.5h5v4H2zM9 9.5h5v4H9z",
  open: "M2 13V3.5h4l1.5 2H14V13z",
  save: "M8 2v8M4.8 7 8 10.2 11.2 7M2.5 13.5h11",
  export: "M8 10.5V2.5M4.8 5.5 8 2.3l3.2 3.2M3 9v4.5h10V9",
  blank: "M3.5 2h6l3 3v9h-9zM9.5 2v3h3",
  functions: "M11 3c-2-.8-3 .2-3.4 2.2L6.2 12c-.3 1.4-1.2 2-2.7 1.5M4.5 6.5h6M10 9l3.5 4M13.5 9 10 13",
  keyboard: "M1.5 4h13v8h-13zM4 6.5h.5M6.5 6.5H7M9 6.5h.5M11.5 6.5h.5M5 9.5h6",
  light: "M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6ZM8 1.2v1.5M8 13.3v1.5M1.2 8h1.5M13.3 8h1.5M3.2 3.2l1 1M11.8 11.8l1 1M3.2 12.8l1-1M11.8 4.2l1-1",
  dark: "M13 9.6A5.6 5.6 0 0 1 6.4 3a5.6 5.6 0 1 0 6.6 6.6Z",
  auto: "M8 2.2a5.8 5.8 0 1 0 0 11.6zM8 2.2a5.8 5.8 0 0 1 0 11.6",
  fit: "M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",
  snap: "M2.5 2.5h11v11h-11zM2.5 8h11M8 2.5v11",
  handles: "M3 12.5 6 4.5l6.5 1.5M3 12.5h0M4.6 12.5a1.6 1.6 0 1 1-3.2 0 1.6 1.6 0 0 1 3.2 0ZM7.6 4.5a1.6 1.6 0 1 1-3.2 0 1.6 1.6 0 0 1 3.2 0ZM14.1 6a1.6 1.6 0 1 1-3.2 0 1.6 1.6 0 0 1 3.2 0Z",
  axes: "M5.5 10.5V2M5.5 10.5H14M5.5 10.5 2 14",
  upright: "M8 14V3M5.2 5.6 8 2.6l2.8 3M11.2 9.5h3.3l-3.3 4h3.3",
  cost: "M8 4.5V8l2.3 1.6M8 2a6 6 0 1 0 0 12A6 6 0 0 0 8 2Z",
  accept: "M3 8.5 6.5 12 13 4.5",
  cancel: "M4 4l8 8M12 4l-8 8",
  more: "M8 3.5v.01M8 8v.01M8 12.5v.01",
} as const;

export type IconName = keyof typeof PATHS;

export function icon(name: IconName): SVGSVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("class", "icon");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", PATHS[name]);
  svg.append(path);
  return svg;
}
