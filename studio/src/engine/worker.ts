import init, { Engine as Kernel } from "./wasm/pforms_wasm";
import type { Failure, Request, Response } from "./protocol";
import { buffersOf } from "./transfer";

/** The kernel runs here, away from the page: one call at a time, in the order they come. */
const kernel: Promise<Kernel> = init().then(() => new Kernel());

self.onmessage = async (event: MessageEvent<Request>) => {
  const { id, method, args } = event.data;
  const response = await answer(id, method, args);
  self.postMessage(response, { transfer: "value" in response ? buffersOf(response.value) : [] });
};

async function answer(id: number, method: Request["method"], args: unknown[]): Promise<Response> {
  try {
    const engine = (await kernel) as unknown as Record<string, (...args: unknown[]) => unknown>;
    return { id, value: engine[method]?.(...args) };
  } catch (error) {
    return { id, failure: failureOf(error) };
  }
}

/** The kernel throws plain failures; anything else is a fault of the program, after which it cannot go on. */
function failureOf(error: unknown): Failure {
  if (isFailure(error)) return error;
  const message = error instanceof Error ? error.message : String(error);
  return { message, hint: null, fatal: true };
}

function isFailure(error: unknown): error is Failure {
  return typeof error === "object" && error !== null && "message" in error && "fatal" in error;
}
