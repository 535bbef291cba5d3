import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { sheet } from "../bench/sheet.mjs";
import { Bench } from "./studio.mjs";

let bench;
before(async () => (bench = await Bench.start()));
after(() => bench.stop());

/** Runs in the page before anything else: writes down what is made for the graphics card, and what is asked and told. */
function watch() {
  const seen = { made: [], written: 0, asked: [], told: [] };
  globalThis.seen = seen;
  const card = WebGL2RenderingContext.prototype;
  const spy = (name, note) => {
    const plain = card[name];
    card[name] = function (...args) {
      note();
      return plain.apply(this, args);
    };
  };
  const making = ["createBuffer", "createVertexArray", "createTexture", "createProgram", "createShader", "bufferData"];
  for (const name of making) spy(name, () => seen.made.push(name));
  spy("bufferSubData", () => (seen.written += 1));
  const Plain = globalThis.Worker;
  globalThis.Worker = class extends Plain {
    postMessage(message, transfer) {
      seen.asked.push(message.method === "movePole" ? message.args.at(-1) : message.method);
      super.postMessage(message, transfer);
    }
    set onmessage(handler) {
      super.onmessage = (event) => {
        if (event.data.value?.cells) seen.told.push(event.data.value);
        handler(event);
      };
    }
  };
}

const APART = '\nB1 = "=POINT(A1, 1/2, 1/2)"\nB2 = "=DIAG(A1)"\nC1 = "[(2, 0, 0), (3, 0, 0)]"\n';
const SHOWN = '\n[show.B2]\ndraw = ["curve"]\n\n[show.C1]\ndraw = ["curve"]\n';

test("a frame of a drag is what depends on the pole, written over what is there; the drag is one step", async () => {
  const studio = await bench.visit({}, watch);
  const { page } = studio;
  const text = sheet().replace("\n\n[show.A1]", `${APART}\n[show.A1]`) + SHOWN;
  const input = { name: "drag.pfs", mimeType: "text/plain", buffer: Buffer.from(text) };
  await page.setInputFiles("input[type=file]", input);
  await studio.waitFor("B2", /pL7/);
  await studio.settled();
  const before = await studio.source("A1");
  const pole = (await studio.poles())[5];
  const go = async (x, y) => {
    const frames = await page.evaluate(() => document.querySelector("canvas").dataset.frames);
    await page.mouse.move(pole.x + x, pole.y + y);
    await page.waitForFunction((old) => document.querySelector("canvas").dataset.frames !== old, frames);
  };
  await page.mouse.move(pole.x, pole.y);
  await page.mouse.down();
  for (let i = 1; i <= 3; i++) await go(3 * i, -2 * i);
  await page.evaluate(() => Object.assign(globalThis.seen, { made: [], written: 0, asked: [], told: [] }));
  for (let i = 4; i <= 15; i++) await go(3 * i, -2 * i);
  const seen = await page.evaluate(() => ({
    ...globalThis.seen,
    told: globalThis.seen.told.map(({ cells, drawings, poles }) => ({
      cells: cells.map((cell) => cell.address),
      drawings: drawings.map((drawing) => drawing.address),
      poles: poles.map((net) => net.address),
    })),
  }));
  assert.deepEqual(seen.made, [], "nothing new on the graphics card");
  assert.ok(seen.written >= 2 * seen.told.length, `${seen.written} buffers written over`);
  assert.ok(seen.told.length >= 8, `${seen.told.length} answers`);
  assert.ok(seen.asked.every((asked) => asked === "during"), `no snapshot, no save: ${seen.asked}`);
  for (const told of seen.told) {
    assert.deepEqual(told.cells, ["A1", "B1", "B2"]);
    assert.deepEqual(told.drawings, ["A1", "B2"]);
    assert.deepEqual(told.poles, ["A1"]);
  }
  await page.mouse.up();
  await studio.settled();
  const last = await page.evaluate(() => globalThis.seen.asked.filter((asked) => asked !== "during"));
  assert.deepEqual(last, ["end", "snapshot"], "kept once, at the end");
  assert.notEqual(await studio.source("A1"), before);
  await page.click('[data-action="undo"]');
  await studio.settled();
  assert.equal(await studio.source("A1"), before);
  assert.ok(await page.locator('[data-action="undo"]').isDisabled(), "one step");
  assert.deepEqual(studio.faults, []);
  await studio.close();
});

test("what follows a drag is read in the sheet when it pauses", async () => {
  const studio = await bench.visit();
  const { page } = studio;
  await studio.type("B1", "=POINT(A4, 1/2, 1/2)");
  await studio.cell("A1").click();
  const before = await studio.cell("B1").getAttribute("title");
  const [pole] = await studio.poles();
  await page.mouse.move(pole.x, pole.y);
  await page.mouse.down();
  await page.mouse.move(pole.x - 40, pole.y - 30, { steps: 3 });
  await page.waitForFunction((old) => document.querySelector('td[data-address="B1"]').title !== old, before);
  assert.ok(await page.locator(".drag-label").isVisible());
  await page.mouse.up();
  await studio.settled();
  assert.ok(await page.locator(".drag-label").isHidden());
  await studio.close();
});
