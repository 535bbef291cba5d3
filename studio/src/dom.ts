type Child = Node | string | null | undefined | false;

type Props<T> = {
  [K in keyof T]?: T[K] extends ((this: GlobalEventHandlers, event: infer E) => unknown) | null
    ? (event: E) => void
    : T[K];
} & { class?: string; data?: Record<string, string>; aria?: Record<string, string>; role?: string };

/** Makes an element: properties are set as they are, `class`, `data`, `aria` and `role` as attributes. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  props: Props<HTMLElementTagNameMap[K]> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const node = document.createElement(tag);
  const { class: name, data, aria, role, ...rest } = props;
  if (name) node.className = name;
  if (role) node.setAttribute("role", role);
  for (const [key, value] of Object.entries(data ?? {})) node.dataset[key] = value;
  for (const [key, value] of Object.entries(aria ?? {})) node.setAttribute(`aria-${key}`, value);
  Object.assign(node, rest);
  append(node, children);
  return node;
}

function append(node: Element, children: Child[]): void {
  for (const child of children) if (child) node.append(child);
}

/** Replaces the children of an element. */
export function fill(node: Element, ...children: Child[]): void {
  node.replaceChildren();
  append(node, children);
}

/** Shows an element or takes it away. Said twice, it costs nothing: a browser would work the style out anew. */
export function show(node: HTMLElement, on: boolean): void {
  if (node.hidden === on) node.hidden = !on;
}

let count = 0;

/** An id that no other element has. */
export function freshId(prefix: string): string {
  count += 1;
  return `${prefix}-${count}`;
}

/** Hands bytes to the person as a file. */
export function download(name: string, bytes: BlobPart, type: string): void {
  const link = el("a", { href: URL.createObjectURL(new Blob([bytes], { type })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
