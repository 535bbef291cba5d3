import type { Port } from "./client";

/** The first kernel starts when this file is read, before the rest of the page: it compiles meanwhile. */
let first: Port | null = start();

/** A kernel in a worker of its own. */
export function spawn(): Port {
  const port = first ?? start();
  first = null;
  return port;
}

function start(): Port {
  return new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
}
