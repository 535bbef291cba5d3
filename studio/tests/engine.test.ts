import { describe, expect, it, vi } from "vitest";
import { EngineClient, EngineFailure, type Port } from "../src/engine/client";
import { LatestWins } from "../src/engine/latest";
import type { Failure, Request, Response } from "../src/engine/protocol";
import { buffersOf } from "../src/engine/transfer";

/** A worker that answers only when told to. */
class StillPort implements Port {
  onmessage: ((event: MessageEvent) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  readonly requests: Request[] = [];
  ended = false;

  postMessage(message: unknown): void {
    this.requests.push(message as Request);
  }

  terminate(): void {
    this.ended = true;
  }

  answer(response: Response): void {
    this.onmessage?.({ data: response } as MessageEvent);
  }
}

function client(): { ports: StillPort[]; client: EngineClient } {
  const ports: StillPort[] = [];
  const spawn = (): Port => {
    const port = new StillPort();
    ports.push(port);
    return port;
  };
  return { ports, client: new EngineClient(spawn) };
}

const failure = (fatal: boolean): Failure => ({ message: "no", hint: "do", fatal });

describe("the engine client", () => {
  it("matches answers to calls, in any order", async () => {
    const { ports, client: engine } = client();
    const first = engine.call("save");
    const second = engine.call("snapshot");
    ports[0]!.answer({ id: 2, value: "second" });
    ports[0]!.answer({ id: 1, value: "first" });
    expect(await Promise.all([first, second])).toEqual(["first", "second"]);
  });

  it("keeps the worker after an ordinary failure", async () => {
    const { ports, client: engine } = client();
    const call = engine.call("save");
    ports[0]!.answer({ id: 1, failure: failure(false) });
    await expect(call).rejects.toThrow(EngineFailure);
    expect(ports).toHaveLength(1);
    expect(ports[0]!.ended).toBe(false);
  });

  it("starts a new worker after a fatal one, and fails what was waiting", async () => {
    const { ports, client: engine } = client();
    const calls = [engine.call("save"), engine.call("snapshot")];
    const settled = Promise.allSettled(calls);
    ports[0]!.answer({ id: 1, failure: failure(true) });
    expect((await settled).map((result) => result.status)).toEqual(["rejected", "rejected"]);
    expect(ports[0]!.ended).toBe(true);
    const next = engine.call("save");
    ports[1]!.answer({ id: 3, value: "works" });
    expect(await next).toBe("works");
  });

  it("tells when the worker was replaced, even while nothing was asked", () => {
    const { ports, client: engine } = client();
    const lost = vi.fn();
    engine.onLost = lost;
    ports[0]!.onerror!({ message: "boom" } as ErrorEvent);
    expect(lost).toHaveBeenCalledWith({ message: "boom", hint: null, fatal: true });
    expect(ports).toHaveLength(2);
  });

  it("tells how many calls are under way", () => {
    const { ports, client: engine } = client();
    const busy = vi.fn();
    engine.onBusy = busy;
    void engine.call("save");
    ports[0]!.answer({ id: 1, value: "" });
    expect(busy.mock.calls.flat()).toEqual([1, 0]);
  });
});

describe("the latest wins", () => {
  it("drops what is overtaken while a task runs", async () => {
    const sent: number[] = [];
    const release: (() => void)[] = [];
    const latest = new LatestWins<number>((value) => {
      sent.push(value);
      return new Promise((resolve) => release.push(resolve));
    });
    for (const value of [1, 2, 3, 4]) latest.push(value);
    expect(sent).toEqual([1]);
    release.shift()!();
    await vi.waitFor(() => expect(sent).toEqual([1, 4]));
    release.shift()!();
    await latest.idle();
    latest.push(5);
    expect(sent).toEqual([1, 4, 5]);
  });
});

describe("transfer", () => {
  it("finds every buffer once", () => {
    const shared = new Float32Array(3);
    const answer = { drawings: [{ meshes: [{ a: shared, b: new Uint32Array(shared.buffer) }] }], none: null, n: 1 };
    expect(buffersOf(answer)).toEqual([shared.buffer]);
  });
});
