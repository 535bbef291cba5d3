import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Bench, repository } from "./studio.mjs";

let bench;
before(async () => (bench = await Bench.start()));
after(() => bench.stop());

const figures = readdirSync(join(repository, "cases/sheets"))
  .filter((name) => name.endsWith(".pfs"))
  .map((name) => name.slice(0, -4));

test("every sheet of the gallery opens without an error, and something is seen", async () => {
  const studio = await bench.visit();
  assert.ok(figures.length > 20);
  for (const figure of figures) {
    await studio.page.click('[data-action="gallery"]');
    await studio.page.click(`[data-figure="${figure}"]`);
    await studio.settled();
    const errors = await studio.page.locator("td.error").allInnerTexts();
    assert.deepEqual(errors, [], figure);
    const { data } = await studio.pixels();
    const ground = data.subarray(0, 3);
    let drawn = 0;
    for (let i = 0; i < data.length; i += 4) if (data.compare(ground, 0, 3, i, i + 3) !== 0) drawn++;
    assert.ok(drawn > 4_000, `${figure}: ${drawn} pixels`);
    assert.deepEqual(studio.faults, [], figure);
    await studio.picture(figure);
  }
  await studio.close();
});
