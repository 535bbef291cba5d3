import { beforeEach, describe, expect, it, vi } from "vitest";
import { EngineClient, type Port } from "../src/engine/client";
import type { CellInfo, Poles, Redrawing, Request, Response, Update } from "../src/engine/protocol";
import { Session } from "../src/session";
import { READING, Store } from "../src/store";
import { update } from "./update";

/** A kernel that answers at once, by a table; it remembers what it was asked. */
class QuickPort implements Port {
  onmessage: ((event: MessageEvent) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;

  constructor(
    private readonly asked: string[],
    private readonly answer: (request: Request) => Response,
  ) {}

  postMessage(message: unknown): void {
    const request = message as Request;
    this.asked.push([request.method, ...request.args.slice(-1)].join(" "));
    queueMicrotask(() => this.onmessage?.({ data: this.answer(request) } as MessageEvent));
  }

  terminate(): void {
    this.onmessage = null;
  }
}

function session(answer: (request: Request) => unknown): {
  asked: string[];
  session: Session;
  errors: string[];
  ports: QuickPort[];
} {
  const asked: string[] = [];
  const errors: string[] = [];
  const ports: QuickPort[] = [];
  const client = new EngineClient(() => {
    const port = new QuickPort(asked, (request) => {
      const value = answer(request);
      const refused = typeof value === "object" && value !== null && "fatal" in value;
      return refused ? ({ id: request.id, failure: value } as Response) : { id: request.id, value };
    });
    ports.push(port);
    return port;
  });
  const notices = { error: (_: string, message: string) => void errors.push(message), info: vi.fn(), kept: vi.fn() };
  return { asked, errors, ports, session: new Session(new Store(), client, notices) };
}

beforeEach(() => {
  const memory = new Map<string, string>();
  const storage = { getItem: (key: string) => memory.get(key) ?? null, setItem: memory.set.bind(memory) };
  vi.stubGlobal("sessionStorage", storage);
  vi.stubGlobal("localStorage", storage);
});

describe("a session", () => {
  it("proceeds until nothing is pending", async () => {
    let pending = 3;
    const { asked, session: one } = session(({ method }) =>
      method === "snapshot" ? "kept" : update({ pending: method === "proceed" ? --pending : pending }),
    );
    await one.change("set", [["A1", "1"]]);
    await vi.waitFor(() => expect(one.store.pending).toBe(0));
    expect(asked.filter((call) => call.startsWith("proceed"))).toHaveLength(3);
  });

  it("keeps nothing in the middle of a drag, and the sheet after it", async () => {
    const { asked, session: one } = session(({ method }) => (method === "snapshot" ? "kept" : update()));
    const move = { address: "A1", index: [0], to: [0, 0, 0], step: 0.1 };
    void one.beginDrag(move);
    for (let step = 0; step < 20; step++) one.drag(move);
    await one.endDrag(move);
    await one.settled();
    const moves = asked.filter((call) => call.startsWith("movePole"));
    expect(moves[0]).toBe("movePole begin");
    expect(moves.at(-1)).toBe("movePole end");
    expect(moves.length).toBeLessThan(6);
    expect(asked.filter((call) => call.startsWith("snapshot"))).toHaveLength(1);
    expect(asked.at(-1)).toBe("snapshot");
  });

  it("tells a refusal and changes nothing", async () => {
    const { errors, session: one } = session(() => ({ message: "no such cell", hint: null, fatal: false }));
    expect(await one.change("set", [["?", "1"]])).toBe(false);
    expect(errors).toEqual(["no such cell"]);
  });

  it("gives a new worker the sheet as it was after the last good change", async () => {
    const { asked, errors, ports, session: one } = session(({ method }) =>
      method === "snapshot" ? "kept" : update({ title: method === "resume" ? "back" : "" }),
    );
    await one.open("pfs = 1");
    ports[0]!.onerror!({ message: "unreachable" } as ErrorEvent);
    await vi.waitFor(() => expect(one.store.title).toBe("back"));
    expect(asked.slice(-2)).toEqual(["setLanguage en", "resume kept"]);
    expect(errors[0]).toContain("unreachable");
  });
});

describe("the page's copy of the sheet", () => {
  const shape = (indices: Uint32Array | null): NonNullable<Redrawing["shape"]> => ({
    meshes: [{ positions: new Float32Array(9), normals: new Float32Array(9), indices }],
    points: [],
  });
  const drawing = (part: Partial<Redrawing> = {}): Redrawing => ({
    address: "A1",
    color: [0, 0, 0],
    opacity: 1,
    shape: null,
    ...part,
  });

  it("fills in what did not travel", () => {
    const store = new Store();
    const indices = new Uint32Array([0, 1, 2]);
    store.apply(update({ drawings: [drawing({ shape: shape(indices) })] }));
    const moved = shape(null);
    store.apply(update({ drawings: [drawing({ shape: moved })] }));
    expect(store.drawings.get("A1")!.meshes[0]!.indices).toBe(indices);
    expect(store.drawings.get("A1")!.meshes[0]!.positions).toBe(moved.meshes[0]!.positions);
    store.apply(update({ drawings: [drawing({ color: [1, 0, 0] })] }));
    expect(store.drawings.get("A1")!.meshes[0]!.positions).toBe(moved.meshes[0]!.positions);
    expect(store.drawings.get("A1")!.color).toEqual([1, 0, 0]);
  });

  it("shows every frame of a drag, and writes texts now and then", () => {
    vi.useFakeTimers();
    const store = new Store();
    const told = { cells: [] as string[], drawings: 0, poles: 0, history: 0 };
    store.on("cells", (touched) => void told.cells.push([...(touched ?? [])].join()));
    store.on("drawings", () => void told.drawings++);
    store.on("poles", () => void told.poles++);
    store.on("history", () => void told.history++);
    const frame = (address: string): Update =>
      update({
        cells: [{ address } as CellInfo],
        drawings: [drawing({ address, shape: shape(null) })],
        poles: [{ address, orders: [], poles: [] }],
      });
    for (let i = 0; i < 30; i++) {
      store.apply(frame(i % 2 === 0 ? "A1" : "A2"), true);
      vi.advanceTimersByTime(READING / 10);
    }
    expect([told.drawings, told.poles]).toEqual([30, 30]);
    expect(told.cells).toEqual(["A1,A2", "A1,A2", "A1,A2"]);
    expect(told.history).toBe(3);
    store.apply(frame("A1"), true);
    store.apply(frame("A3"));
    expect(told.cells.at(-1)).toBe("A1,A3");
    vi.advanceTimersByTime(10 * READING);
    expect(told.cells).toHaveLength(4);
    vi.useRealTimers();
  });

  it("keeps the order of the poles, and forgets those of a cell that has none any more", () => {
    const store = new Store();
    const net = (address: string): Poles => ({ address, orders: [], poles: [] });
    const cell = (address: string): CellInfo => ({ address }) as CellInfo;
    const [a, b] = [cell("A1"), cell("A2")];
    store.apply(update({ cells: [a, b], poles: [net("A1"), net("A2")] }));
    let told = 0;
    store.on("poles", () => void told++);
    store.apply(update({ cells: [a], poles: [net("A1")] }));
    expect([...store.poles.keys()]).toEqual(["A1", "A2"]);
    store.apply(update({ cells: [cell("A3")] }));
    expect(told).toBe(1);
    store.apply(update({ cells: [a], removed: ["A2"] }));
    expect([store.poles.size, told]).toEqual([0, 2]);
  });
});
