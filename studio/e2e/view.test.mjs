import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Bench, GOLD, RED, repository } from "./studio.mjs";

let bench;
before(async () => (bench = await Bench.start()));
after(() => bench.stop());

test("the page opens on the octant of sphere and its Viviani arc", async () => {
  const studio = await bench.visit();
  assert.equal(await studio.read("A4"), "pS33 =MIR(A1, A2, A3)");
  assert.equal(await studio.read("A5"), "pL5 =DIAG(A4)");
  const [gold, red] = [await studio.count(GOLD), await studio.count(RED)];
  assert.ok(gold > 30_000, `${gold} golden pixels`);
  assert.ok(red > 1_000, `${red} red pixels`);
  assert.deepEqual(studio.faults, []);
  await studio.picture("octant");
  await studio.close();
});

test("a pole is dragged, its cell and what depends on it follow, one undo takes it back", async () => {
  const studio = await bench.visit();
  await studio.type("B1", "=POINT(A4, 1/2, 1/2)");
  const before = { source: await studio.source("A2"), value: await studio.cell("B1").getAttribute("title") };
  const picture = await studio.pixels();
  const poles = await studio.poles();
  assert.ok(poles.length >= 2, `${poles.length} poles seen`);
  const pole = poles[0];
  await studio.drag(pole, { x: pole.x - 70, y: pole.y - 50 });
  const source = await studio.source("A2");
  assert.notEqual(source, before.source);
  assert.ok(source.length < before.source.length + 40, `short numbers: ${source}`);
  assert.notEqual(await studio.cell("B1").getAttribute("title"), before.value, "the dependent value follows");
  assert.notDeepEqual((await studio.pixels()).data, picture.data, "the picture follows");
  await studio.page.click('[data-action="undo"]');
  await studio.settled();
  assert.equal(await studio.source("A2"), before.source, "one step of the history");
  assert.equal(await studio.cell("B1").getAttribute("title"), before.value);
  await studio.close();
});

test("Shift keeps a pole on an axis, and the grid makes its coordinates round", async () => {
  const studio = await bench.visit();
  await studio.cell("A1").click();
  const [pole] = (await studio.poles()).slice(-1);
  const numbers = (source) => source.match(/-?\d+(\.\d+)?/g).map(Number);
  const before = numbers(await studio.source("A1"));
  await studio.page.keyboard.down("Shift");
  await studio.drag(pole, { x: pole.x + 8, y: pole.y + 90 });
  await studio.page.keyboard.up("Shift");
  const moved = numbers(await studio.source("A1"));
  assert.equal(moved.filter((number, at) => number !== before[at]).length, 1, `${moved}`);
  await studio.page.click('[data-action="undo"]');
  await studio.settled();
  await studio.page.locator('.view-tools button[title^="Snap"]').click();
  await studio.drag(pole, { x: pole.x - 61, y: pole.y + 47 });
  const snapped = numbers(await studio.source("A1"));
  const grid = snapped.filter((number, at) => number !== before[at]);
  assert.ok(grid.length >= 2, `${snapped}`);
  for (const number of grid) assert.ok(Math.abs(number * 20 - Math.round(number * 20)) < 1e-9, `${number}`);
  await studio.close();
});

test("a slider changes the picture while it moves, as one step of the history", async () => {
  const studio = await bench.visit();
  await studio.cell("A4").click();
  const before = await studio.count(GOLD);
  const slider = studio.page.locator('[data-field="opacity"]');
  const box = await slider.boundingBox();
  const y = box.y + box.height / 2;
  await studio.drag({ x: box.x + box.width * 0.85, y }, { x: box.x + 4, y }, 6);
  assert.ok((await studio.count(GOLD)) < before / 2);
  await studio.page.click('[data-action="undo"]');
  await studio.settled();
  assert.ok(Math.abs((await studio.count(GOLD)) - before) < before / 50);
  assert.ok(await studio.page.locator('[data-action="undo"]').isDisabled());
  await studio.close();
});

test("coordinates of a pole can be typed", async () => {
  const studio = await bench.visit();
  await studio.cell("A2").click();
  const [pole] = await studio.poles();
  await studio.page.mouse.dblclick(pole.x, pole.y);
  const field = studio.page.locator(".pole-popup input").first();
  await field.fill("1/3");
  await field.press("Enter");
  await studio.settled();
  assert.match(await studio.source("A2"), /1\/3/);
  assert.ok(await studio.page.locator(".pole-popup").isHidden());
  await studio.close();
});

test("each view shows the forms, and the view is kept", async () => {
  const studio = await bench.visit();
  const pictures = new Set();
  for (const view of ["OX", "OY", "OZ", "AXO"]) {
    await studio.page.locator(".view-tools button", { hasText: view }).click();
    assert.ok((await studio.count(GOLD)) > 10_000, view);
    pictures.add((await studio.pixels()).text);
  }
  assert.equal(pictures.size, 4);
  await studio.settled();
  await studio.page.reload();
  await studio.ready();
  assert.equal(await studio.page.locator('.view-tools [aria-pressed="true"]').first().innerText(), "AXO");
  await studio.close();
});

test("looking round is no step of the history", async () => {
  const studio = await bench.visit();
  await studio.type("C1", "1");
  const before = (await studio.pixels()).text;
  const box = await studio.page.locator(".view canvas").boundingBox();
  await studio.drag({ x: box.x + 40, y: box.y + 600 }, { x: box.x + 160, y: box.y + 560 });
  const turned = (await studio.pixels()).text;
  assert.notEqual(turned, before);
  await studio.page.click('[data-action="undo"]');
  await studio.settled();
  assert.equal(await studio.read("C1"), "");
  assert.equal((await studio.pixels()).text, turned);
  await studio.page.locator(".view canvas").focus();
  await studio.page.keyboard.press("f");
  await studio.settled();
  assert.notEqual((await studio.pixels()).text, turned);
  await studio.close();
});

test("the styles of a cell change the picture", async () => {
  const studio = await bench.visit();
  await studio.cell("A4").click();
  const surface = await studio.count(GOLD);
  await studio.page.locator(".ways label", { hasText: "Points" }).click();
  await studio.settled();
  await studio.page.locator(".ways label", { hasText: "Surface" }).click();
  await studio.settled();
  const points = await studio.count(GOLD);
  assert.ok(points > 100 && points < surface / 2, `${points} of ${surface}`);
  await studio.page.locator(".ways .switch").click();
  await studio.settled();
  assert.ok((await studio.count(GOLD)) < points / 4);
  assert.deepEqual(studio.faults, []);
  await studio.close();
});

test("the Newell teapot opens", async () => {
  const studio = await bench.visit();
  await studio.page.setInputFiles("input[type=file]", join(repository, "cases/models/newell-teapot32.bpt"));
  await studio.waitFor("A2", /pS44/);
  await studio.settled();
  assert.equal(await studio.page.locator("input.title").inputValue(), "newell-teapot32");
  assert.match(await studio.page.locator(".statusbar").innerText(), /33 cells/);
  assert.equal(await studio.source("B1"), "=A1:A32");
  const pot = await studio.count(GOLD);
  assert.ok(pot > 30_000, `${pot} golden pixels`);
  assert.deepEqual(studio.faults, []);
  await studio.picture("teapot");
  await studio.close();
});

test("a model is exported as GLB, OBJ, STL and POV", async () => {
  const studio = await bench.visit();
  const starts = { glb: "glTF", obj: "", stl: "", pov: "" };
  for (const [format, start] of Object.entries(starts)) {
    await studio.page.click('[data-action="export"]');
    const waiting = studio.page.waitForEvent("download");
    await studio.page.click(`[data-format="${format}"]`);
    const download = await waiting;
    assert.equal(download.suggestedFilename(), `octant-of-a-sphere.${format}`);
    const bytes = readFileSync(await download.path());
    assert.ok(bytes.length > 1000, `${format}: ${bytes.length} bytes`);
    assert.equal(bytes.subarray(0, start.length).toString("latin1"), start);
    if (format === "glb") assert.equal(bytes.readUInt32LE(8), bytes.length, "the length in the header");
  }
  await studio.close();
});

test("a sheet is saved as text that opens again", async () => {
  const studio = await bench.visit();
  const waiting = studio.page.waitForEvent("download");
  await studio.page.click('[data-action="save"]');
  const path = await (await waiting).path();
  assert.match(readFileSync(path, "utf8"), /^pfs = 1\ntitle = "Octant of a sphere"/);
  await studio.page.click('[data-action="newSheet"]');
  await studio.settled();
  const input = { name: "again.pfs", mimeType: "text/plain", buffer: readFileSync(path) };
  await studio.page.setInputFiles("input[type=file]", input);
  await studio.waitFor("A4", /pS33/);
  await studio.close();
});
