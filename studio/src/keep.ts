/**
 * Keeps sheets in this browser, so that neither a reload nor a crash loses one.
 *
 * Each tab works on a sheet of its own; the newest [`KEPT`] sheets can be found again in the gallery.
 */

/** How many sheets are kept before the oldest is dropped. */
export const KEPT = 40;

export interface KeptSheet {
  id: string;
  title: string;
  /** The sheet with its history, as the kernel gave it. */
  snapshot: string;
  /** Milliseconds since 1970. */
  at: number;
}

/** Text that was being typed when the page went away. */
export interface Draft {
  address: string;
  text: string;
}

const CURRENT = "pforms.current";
const LAST = "pforms.last";
const DRAFT = "pforms.draft";

function database(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open("pforms", 1);
    request.onupgradeneeded = () => request.result.createObjectStore("sheets", { keyPath: "id" });
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("indexedDB"));
  });
}

async function sheets<T>(mode: IDBTransactionMode, use: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const base = await database();
  try {
    return await new Promise<T>((resolve, reject) => {
      const transaction = base.transaction("sheets", mode);
      const request = use(transaction.objectStore("sheets"));
      transaction.oncomplete = () => resolve(request.result);
      transaction.onerror = transaction.onabort = () => reject(transaction.error ?? new Error("indexedDB"));
    });
  } finally {
    base.close();
  }
}

/** The id of this tab's sheet; survives a reload. */
export function currentId(): string {
  const known = sessionStorage.getItem(CURRENT);
  return known ?? renewId();
}

/** The next sheet of this tab is another one: the present one stays in the gallery. */
export function renewId(): string {
  const id = crypto.randomUUID();
  sessionStorage.setItem(CURRENT, id);
  return id;
}

/** Stores the present sheet and drops the oldest ones. */
export async function keep(title: string, snapshot: string): Promise<void> {
  const id = currentId();
  await sheets("readwrite", (store) => store.put({ id, title, snapshot, at: Date.now() } satisfies KeptSheet));
  localStorage.setItem(LAST, id);
  const old = (await keptSheets()).slice(KEPT);
  for (const sheet of old) await forget(sheet.id);
}

/** All kept sheets, the newest first. */
export async function keptSheets(): Promise<KeptSheet[]> {
  const all = await sheets<KeptSheet[]>("readonly", (store) => store.getAll());
  return all.sort((a, b) => b.at - a.at);
}

export async function forget(id: string): Promise<void> {
  await sheets("readwrite", (store) => store.delete(id));
}

/** The sheet to begin with: this tab's own, else the one last worked on, else none. */
export async function lastSheet(): Promise<KeptSheet | null> {
  const id = sessionStorage.getItem(CURRENT) ?? localStorage.getItem(LAST);
  if (!id) return null;
  return (await sheets<KeptSheet | undefined>("readonly", (store) => store.get(id))) ?? null;
}

/** Remembers text while it is typed; null when it was accepted or abandoned. */
export function keepDraft(draft: Draft | null): void {
  try {
    if (draft) sessionStorage.setItem(DRAFT, JSON.stringify(draft));
    else sessionStorage.removeItem(DRAFT);
  } catch {
    sessionStorage.removeItem(DRAFT);
  }
}

export function keptDraft(): Draft | null {
  try {
    const draft: unknown = JSON.parse(sessionStorage.getItem(DRAFT) ?? "null");
    return isDraft(draft) ? draft : null;
  } catch {
    return null;
  }
}

function isDraft(value: unknown): value is Draft {
  if (typeof value !== "object" || value === null) return false;
  const { address, text } = value as Partial<Draft>;
  return typeof address === "string" && typeof text === "string";
}
