import type { Answer, Arguments, Failure, Method, Request, Response } from "./protocol";

/** The part of a `Worker` that is used, so that tests can stand in for it. */
export interface Port {
  postMessage(message: unknown, transfer?: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

interface Waiting {
  resolve(value: unknown): void;
  reject(error: EngineFailure): void;
}

/** A [`Failure`] as an exception. */
export class EngineFailure extends Error {
  constructor(readonly failure: Failure) {
    super(failure.message);
  }
}

/** Talks to the kernel in its worker. The page never waits in place: every call is a promise. */
export class EngineClient {
  private port: Port;
  private next = 1;
  private readonly waiting = new Map<number, Waiting>();
  private held = 0;
  /** Called when work begins or ends, with the number of calls and holds still under way. */
  onBusy: (count: number) => void = () => undefined;

  /** Called after a worker was replaced by a fresh one, which knows no sheet yet. */
  onLost: (reason: Failure) => void = () => undefined;

  constructor(private readonly spawn: () => Port) {
    this.port = this.start();
  }

  /** Work of several calls begins; it ends when the answer is called. */
  hold(): () => void {
    this.held += 1;
    this.tell();
    return () => {
      this.held -= 1;
      this.tell();
    };
  }

  private tell(): void {
    this.onBusy(this.waiting.size + this.held);
  }

  call<M extends Method>(method: M, ...args: Arguments<M>): Promise<Answer<M>> {
    const id = this.next++;
    return new Promise<Answer<M>>((resolve, reject) => {
      this.waiting.set(id, { resolve: resolve as (value: unknown) => void, reject });
      this.tell();
      this.port.postMessage({ id, method, args } satisfies Request);
    });
  }

  /** Ends the worker and whatever it computes, and starts a fresh, empty one. */
  restart(reason: Failure): void {
    this.port.terminate();
    const lost = [...this.waiting.values()];
    this.waiting.clear();
    this.port = this.start();
    for (const call of lost) call.reject(new EngineFailure(reason));
    this.tell();
    this.onLost(reason);
  }

  private start(): Port {
    const port = this.spawn();
    port.onmessage = (event) => this.receive(event.data as Response);
    port.onerror = (event) => {
      event.preventDefault?.();
      this.restart({ message: event.message || "worker", hint: null, fatal: true });
    };
    return port;
  }

  private receive(response: Response): void {
    const call = this.waiting.get(response.id);
    if (!call) return;
    this.waiting.delete(response.id);
    this.tell();
    if ("value" in response) call.resolve(response.value);
    else if (response.failure.fatal) {
      call.reject(new EngineFailure(response.failure));
      this.restart(response.failure);
    } else call.reject(new EngineFailure(response.failure));
  }
}
