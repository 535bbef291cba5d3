import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Bench } from "./studio.mjs";

let bench;
before(async () => (bench = await Bench.start()));
after(() => bench.stop());

/** The cells of the first example, whatever else was tried. */
async function stillWhole(studio) {
  assert.match(await studio.read("A4"), /pS33/);
  assert.match(await studio.read("A5"), /pL5/);
  assert.deepEqual(studio.faults, []);
}

test("a circle of cells names every cell of it, and can be undone", async () => {
  const studio = await bench.visit();
  await studio.type("C1", "=C2+1");
  await studio.type("C2", "=C3");
  await studio.type("C3", "=2*C1");
  const message = await studio.read("C1");
  for (const cell of ["C1", "C2", "C3"]) assert.match(message, new RegExp(cell));
  await studio.cell("C2").click();
  assert.match(await studio.page.locator(".bar-message.wrong").innerText(), /→/);
  await stillWhole(studio);
  await studio.page.click('[data-action="undo"]');
  await studio.settled();
  assert.equal(await studio.read("C3"), "");
  await studio.close();
});

test("monstrous formulas get an answer", async () => {
  const studio = await bench.visit();
  const monsters = {
    C1: `=${"1+".repeat(50_000)}1`,
    C2: `=${"(".repeat(10_000)}1${")".repeat(10_000)}`,
    C3: `=${"MIR(".repeat(10_000)}`,
    C4: `[${"(1,2,3),".repeat(12_000)}(1,2,3)]`,
  };
  for (const [address, text] of Object.entries(monsters)) await studio.type(address, text);
  assert.equal(await studio.read("C1"), "50001");
  for (const address of ["C2", "C3"]) assert.ok(await studio.cell(address).evaluate((cell) => cell.className.includes("error")));
  await stillWhole(studio);
  assert.equal((await studio.source("C2")).length, 20_002, "the text is still there");
  await studio.close();
});

test("mistakes are underlined where they are, with a hint", async () => {
  const studio = await bench.visit();
  await studio.type("C1", "=1 + DIAGG(A4)");
  await studio.choose("C1");
  assert.equal(await studio.page.locator(".editor-mirror .wrong").innerText(), "DIAGG");
  assert.match(await studio.page.locator(".bar-message .hint").innerText(), /DIAG/);
  await studio.type("C2", "=C1");
  await studio.waitFor("C2", /DIAGG/);
  await studio.choose("C2");
  // An error names its origin.
  await studio.page.locator(".bar-message", { hasText: "C1" }).waitFor();
  await studio.close();
});

test("every kind of bad value becomes an error in its cell", async () => {
  const studio = await bench.visit();
  const bad = [
    "[[(0,0),(1,0)],[(0,1)]]",
    "[]",
    "=1/0",
    "=1e400",
    "(1, 2",
    "=[(0,0,0),(1,0)]",
    "=SUB(A4, 7, 1/2)",
    "=A4(",
    "=SUBDIVIDE(A4, 40)",
    "=MIR(A1, \"x\")",
  ];
  for (const [row, text] of bad.entries()) await studio.type(`D${row + 1}`, text);
  for (const row of bad.keys()) {
    const cell = studio.cell(`D${row + 1}`);
    const [name, said] = await cell.evaluate((one) => [one.className, one.textContent ?? ""]);
    assert.ok(name.includes("error") || bad[row] === "[]", `${bad[row]} gave ${name} ${said}`);
    assert.ok(said.length > 3, bad[row]);
  }
  await stillWhole(studio);
  await studio.close();
});

test("a damaged file is refused, and the open sheet stays", async () => {
  const studio = await bench.visit();
  const files = {
    "cut.pfs": 'pfs = 1\n[cells]\nA1 = "(1, 2',
    "old.pfs": "pfs = 99\n",
    "types.pfs": "pfs = 1\ncells = 3\n",
    "cut.bpt": "32\n3 3\n0 0 0\n",
    "huge.bpt": "1\n99999999 99999999\n0 0 0\n",
    "wrong.json": '{"forms": [1, 2',
    "noise.json": "\u0000\u0001",
  };
  for (const [name, text] of Object.entries(files)) {
    const input = { name, mimeType: "text/plain", buffer: Buffer.from(text) };
    await studio.page.setInputFiles("input[type=file]", input);
    const toast = studio.page.locator(".toast.wrong").last();
    await toast.waitFor().catch(() => assert.fail(`${name} was not refused`));
    assert.ok((await toast.innerText()).length > 20, name);
    await toast.locator("button").click();
    await stillWhole(studio);
  }
  await studio.close();
});

test("a long computation is stopped, and goes on with the next change", async () => {
  const studio = await bench.visit();
  await studio.cell("C1").click();
  await studio.page.keyboard.type('=EXPLAIN("DIAG", "pS[20,20]")');
  await studio.page.keyboard.press("Enter");
  await studio.settled();
  await studio.cell("C1").click();
  await studio.cell("C30").click({ modifiers: ["Shift"] });
  await studio.page.keyboard.press("Control+d");
  await studio.page.locator(".busy .stop").click();
  await studio.settled();
  const pending = await studio.page.locator("td.pending").count();
  assert.ok(pending > 0, "it was stopped half-way");
  await stillWhole(studio);
  await studio.type("D1", "=1+1");
  assert.equal(await studio.read("D1"), "2");
  await studio.page.waitForFunction(() => document.querySelectorAll("td.pending").length === 0);
  await studio.close();
});

test("a kernel that dies is replaced, and the sheet is back with its history", async () => {
  const studio = await bench.visit({}, () => {
    const Real = globalThis.Worker;
    globalThis.workers = [];
    globalThis.Worker = class extends Real {
      constructor(...given) {
        super(...given);
        globalThis.workers.push(this);
      }
    };
  });
  await studio.type("C1", "42");
  await studio.type("C2", "=C1/2");
  await studio.page.evaluate(() => globalThis.workers[0].onerror(new ErrorEvent("error", { message: "unreachable" })));
  await studio.page.locator(".toast.wrong").waitFor();
  await studio.settled();
  assert.equal(await studio.read("C2"), "21");
  await studio.page.click('[data-action="undo"]');
  await studio.settled();
  assert.equal(await studio.read("C2"), "");
  await stillWhole(studio);
  await studio.close();
});

test("cells at the far end of a sheet are reached without a hang", async () => {
  const studio = await bench.visit();
  const address = studio.page.locator("input.address");
  await address.fill("ZZZ1000000");
  await address.press("Enter");
  await studio.page.keyboard.type("=2*21");
  await studio.page.keyboard.press("Enter");
  await studio.waitFor("ZZZ1000000", /42/);
  await studio.page.keyboard.press("Control+a");
  await studio.page.keyboard.press("Control+c");
  await studio.page.keyboard.press("Control+Home");
  await stillWhole(studio);
  assert.ok((await studio.page.locator("td[data-address]").count()) < 3_000);
  await studio.page.locator('.state[data-phrase="saved"]').waitFor();
  await studio.page.reload();
  await studio.ready();
  await stillWhole(studio);
  await studio.close();
});
