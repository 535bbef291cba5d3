import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Bench } from "./studio.mjs";

let bench;
before(async () => (bench = await Bench.start()));
after(() => bench.stop());

test("functions are found, explained and tried", async () => {
  const studio = await bench.visit();
  await studio.cell("C1").click();
  await studio.page.click('[data-action="functions"]');
  await studio.page.locator(".functions input").fill("diagonal surface");
  const entry = studio.page.locator(".operator", { hasText: "DIAG" }).first();
  await entry.locator("summary").click();
  const example = await entry.locator(".example code").innerText();
  await entry.locator(".example button").click();
  await studio.page.keyboard.press("Enter");
  await studio.waitFor("C1", /p[LS]\d/);
  assert.equal(await studio.source("C1"), example);
  await studio.close();
});

test("light and dark follow the system, and can be chosen", async () => {
  const studio = await bench.visit({ colorScheme: "dark" });
  const ground = async () => {
    const { data, width } = await studio.pixels();
    const at = 4 * (20 * width + 20);
    return data[at] + data[at + 1] + data[at + 2];
  };
  assert.ok((await ground()) < 150, "dark as the system is");
  await studio.page.click('[data-action="theme"]');
  assert.ok((await ground()) > 600, "light as chosen");
  await studio.page.reload();
  await studio.ready();
  assert.ok((await ground()) > 600, "and it stays");
  await studio.close();
});

test("each cell tells its cost", async () => {
  const studio = await bench.visit();
  await studio.cell("A4").click();
  assert.match(await studio.page.locator(".inspector .costs").innerText(), /ms.*3 × 3.*288 B/s);
  await studio.page.locator(".statusbar button").last().click();
  assert.match(await studio.cell("A5").locator(".cell-cost").innerText(), /ms · 160 B/);
  await studio.close();
});

test("a name given to a cell is used in formulas", async () => {
  const studio = await bench.visit();
  await studio.cell("A5").click();
  const name = studio.page.locator('[data-field="name"]');
  assert.equal(await name.inputValue(), "viviani");
  await name.fill("arc");
  await name.press("Enter");
  await studio.settled();
  await studio.type("C1", "=ELEVATE(arc, 1)");
  assert.match(await studio.read("C1"), /pL6/);
  await studio.close();
});

test("a replaced sheet is found again in the gallery, with its picture", async () => {
  const studio = await bench.visit();
  await studio.type("C1", "7");
  await studio.page.locator('.state[data-phrase="saved"]').waitFor();
  await studio.page.click('[data-action="newSheet"]');
  await studio.settled();
  assert.equal(await studio.read("C1"), "");
  await studio.page.click('[data-action="gallery"]');
  const own = studio.page.locator(".cards").first().locator(".card").first();
  await own.locator("img[src]").waitFor();
  await own.click();
  await studio.waitFor("C1", /7/);
  await studio.close();
});

test("a dropped file is opened", async () => {
  const studio = await bench.visit();
  await studio.page.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File(['pfs = 1\n[cells]\nB2 = "=2+3"\n'], "dropped.pfs"));
    document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  });
  await studio.waitFor("B2", /5/);
  await studio.close();
});

test("the table is a table, and says where one is", async () => {
  const studio = await bench.visit();
  await studio.cell("B3").click();
  const said = await studio.page.evaluate(() => {
    const cell = document.activeElement;
    const table = cell.closest("table");
    return [
      table.getAttribute("role"),
      Number(table.ariaColCount) > 12 && table.querySelectorAll("thead th[scope=col]").length > 3,
      cell.parentElement.querySelector("th[scope=row]").textContent,
      cell.getAttribute("role"),
      cell.getAttribute("aria-selected"),
      document.querySelectorAll("td[tabindex='0']").length,
      [...document.querySelectorAll("button")].every((button) => button.textContent || button.getAttribute("aria-label")),
      [...document.querySelectorAll("input, textarea")].every((field) => field.hidden || field.labels?.length || field.ariaLabel),
    ];
  });
  assert.deepEqual(said, ["grid", true, "3", "gridcell", "true", 1, true, true]);
  await studio.close();
});
