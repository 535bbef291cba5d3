import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Bench, GOLD } from "./studio.mjs";

let bench;
before(async () => (bench = await Bench.start()));
after(() => bench.stop());

/** A visitor with an empty sheet. */
async function empty(options) {
  const studio = await bench.visit(options);
  await studio.page.click('[data-action="newSheet"]');
  await studio.settled();
  return studio;
}

test("a formula is typed and its form is seen", async () => {
  const studio = await empty();
  assert.ok((await studio.count(GOLD)) < 1_000);
  await studio.type("A1", "[(0,0,0), (1,1,0), (2,0,0)]");
  await studio.type("A2", "[(0,0,1), (1,-1,1), (2,0,1)]");
  await studio.type("B1", "=MIR(A1, A2)");
  assert.equal(await studio.read("B1"), "pS23 =MIR(A1, A2)");
  await studio.cell("B1").click();
  await studio.page.keyboard.press("Control+Enter");
  await studio.settled();
  await studio.page.locator('.swatch[title="#e8b84a"]').click();
  await studio.settled();
  const surface = await studio.count(GOLD);
  assert.ok(surface > 20_000, `${surface} golden pixels`);
  assert.deepEqual(studio.faults, []);
  await studio.close();
});

test("completion and help come from the catalogue", async () => {
  const studio = await empty();
  await studio.cell("A1").click();
  await studio.page.keyboard.type("=dia");
  await studio.page.locator(".proposals li", { hasText: "DIAG" }).first().waitFor();
  await studio.page.keyboard.press("Tab");
  await studio.page.locator(".call-card .active").waitFor();
  assert.match(await studio.page.locator(".editor-area").inputValue(), /^=DIAG\($/);
  assert.match(await studio.page.locator(".call-card").innerText(), /DIAG\(/);
  await studio.close();
});

test("undo and redo go step by step", async () => {
  const studio = await empty();
  await studio.type("A1", "2");
  await studio.type("A2", "=A1*A1");
  await studio.type("A1", "3");
  assert.equal(await studio.read("A2"), "9");
  await studio.page.click('[data-action="undo"]');
  await studio.waitFor("A2", /^4/);
  await studio.page.click('[data-action="undo"]');
  await studio.page.click('[data-action="undo"]');
  await studio.settled();
  assert.equal(await studio.read("A1"), "");
  assert.ok(await studio.page.locator('[data-action="undo"]').isDisabled());
  for (let step = 0; step < 3; step++) await studio.page.click('[data-action="redo"]');
  await studio.waitFor("A2", /^9/);
  await studio.close();
});

test("everything is done with the keyboard alone", async () => {
  const studio = await empty();
  const { keyboard } = studio.page;
  const keys = async (...list) => {
    for (const key of list) await keyboard.press(key);
    await studio.settled();
  };
  await studio.cell("A1").focus();
  await keyboard.type("[(0,0,0), (1,2,0), (2,0,0)]");
  await keys("Tab");
  await keyboard.type("=ELEVATE(A1, 1)");
  await keys("Enter");
  assert.equal(await studio.read("B1"), "pL4 =ELEVATE(A1, 1)");
  await keys("ArrowUp", "Control+Enter");
  assert.ok((await studio.cell("B1").locator(".dot.on").count()) === 1);
  await keys("F2", "Escape", "ArrowLeft", "Control+c", "ArrowDown", "Control+v");
  assert.equal(await studio.source("A2"), "[(0,0,0), (1,2,0), (2,0,0)]");
  await keys("Delete");
  assert.equal(await studio.read("A2"), "");
  await keys("Control+z", "Control+z");
  assert.equal(await studio.read("A2"), "");
  await keys("Control+y");
  assert.match(await studio.read("A2"), /pL3/);
  for (let panel = 0; panel < 5; panel++) {
    if (await studio.page.evaluate(() => document.activeElement?.tagName === "CANVAS")) break;
    await keys("F6");
  }
  await keys("f", "]");
  await keyboard.type("0.5");
  await keys("Enter");
  const sources = [await studio.source("A1"), await studio.source("A2")];
  assert.ok(sources.some((source) => source.startsWith("[(0.5, 0, 0)")), sources.join(" | "));
  await studio.close();
});

test("scrolling far away and typing comes back to the selected cell", async () => {
  const studio = await empty();
  await studio.type("A1", "5");
  await studio.type("A200", "6");
  await studio.cell("A200").click();
  await studio.page.keyboard.press("Control+Home");
  await studio.page.locator(".sheet-scroll").evaluate((one) => (one.scrollTop = 5000));
  await studio.page.waitForTimeout(100);
  assert.equal(await studio.cell("A1").count(), 0, "out of sight");
  await studio.page.keyboard.press("ArrowRight");
  assert.ok(await studio.cell("B1").evaluate((cell) => cell === document.activeElement));
  await studio.close();
});

test("a formula copied elsewhere follows", async () => {
  const studio = await empty();
  await studio.type("A1", "2");
  await studio.type("A2", "5");
  await studio.type("B1", "=A1+$A$1");
  await studio.cell("B1").click();
  await studio.page.keyboard.press("Control+c");
  await studio.cell("B2").click();
  await studio.page.keyboard.press("Control+v");
  await studio.waitFor("B2", /7/);
  assert.equal(await studio.source("B2"), "=A2+$A$1");
  await studio.close();
});

test("a click puts a cell into the formula that is being typed", async () => {
  const studio = await empty();
  await studio.type("A1", "4");
  await studio.cell("B1").click();
  await studio.page.keyboard.type("=2*");
  await studio.cell("A1").click();
  await studio.page.keyboard.press("Enter");
  await studio.waitFor("B1", /8/);
  assert.equal(await studio.source("B1"), "=2*A1");
  await studio.close();
});

test("a reload loses nothing: cells, history, text half typed", async () => {
  const studio = await empty();
  await studio.type("A1", "(1, 2, 3)");
  await studio.type("A2", "=2*A1");
  const title = studio.page.locator("input.title");
  await title.fill("Kept");
  await title.press("Enter");
  await studio.settled();
  await studio.page.locator('.state[data-phrase="saved"]').waitFor();
  await studio.cell("A3").click();
  await studio.page.keyboard.type("=MI(A1, ");
  await studio.page.reload();
  await studio.ready();
  assert.equal(await studio.page.locator(".editor-area").inputValue(), "=MI(A1, ");
  assert.equal(await title.inputValue(), "Kept");
  await studio.page.keyboard.type("A2)");
  await studio.page.keyboard.press("Enter");
  await studio.waitFor("A3", /pP/);
  assert.equal(await studio.source("A2"), "=2*A1");
  for (let step = 0; step < 3; step++) await studio.page.click('[data-action="undo"]');
  await studio.settled();
  assert.equal(await studio.read("A2"), "", "the history reaches behind the reload");
  await studio.close();
});

test("French: the page, the names of functions, the decimal comma", async () => {
  const studio = await empty({ locale: "fr-FR" });
  assert.equal(await studio.page.locator("html").getAttribute("lang"), "fr");
  assert.match(await studio.page.locator('[data-action="gallery"]').innerText(), /Galerie/);
  await studio.type("A1", "1,5");
  await studio.type("A2", "=RACINE(A1 + 0,75)");
  assert.equal(await studio.read("A2"), "1,5");
  await studio.type("A3", "(1,5; 2; 0 | 0,5)");
  assert.match(await studio.read("A3"), /pP/);
  await studio.page.click(".language");
  await studio.settled();
  assert.equal(await studio.page.locator("html").getAttribute("lang"), "en");
  assert.equal(await studio.source("A1"), "1.5");
  assert.match(await studio.source("A3"), /^\(1\.5, 2, 0 ?; 0\.5\)$/);
  assert.deepEqual(studio.faults, []);
  await studio.close();
});
