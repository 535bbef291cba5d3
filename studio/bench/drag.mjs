/**
 * One pole of a pS44 drawn at 129×129 is dragged through many places: what a frame costs, stage by stage.
 *
 *   npm run bench            (CHROMIUM=path, FRAMES=200, JSON=file, PICTURE=file.png)
 */
import { writeFileSync } from "node:fs";
import { cpus, loadavg } from "node:os";
import { Bench } from "../e2e/studio.mjs";
import { sheet } from "./sheet.mjs";
import { watchPage, watchWorker } from "./probe.mjs";

const FRAMES = Number(process.env["FRAMES"] ?? 200);
const WARM = 20;

const median = (numbers) => quantile(numbers, 0.5);

function quantile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? Number.NaN;
}

/** Moves the pole along a small figure of eight, each place after the picture of the one before. */
async function drag(studio, pole) {
  const { page } = studio;
  await page.mouse.move(pole.x, pole.y);
  await page.mouse.down();
  const place = (step) => [pole.x + 60 * Math.sin(step / 9), pole.y - 40 * Math.sin((2 * step) / 9)];
  for (let step = 1; step <= WARM + FRAMES; step++) {
    if (step === WARM) await forget(studio);
    const before = await page.evaluate(() => document.querySelector("canvas").dataset.frames);
    await page.mouse.move(...place(step));
    await page.waitForFunction((old) => document.querySelector("canvas").dataset.frames !== old, before, {
      polling: 2,
      timeout: 5000,
    });
  }
}

async function forget(studio) {
  await studio.page.evaluate(() => Object.values(globalThis.bench).forEach((list) => list.splice(0)));
  await studio.page.workers()[0].evaluate(() => self.bench.splice(0));
}

/** The stages of every frame: a pointer event, its answer, the picture after it. */
function frames(page, worker) {
  const moves = worker.filter((record) => record.method === "movePole");
  const found = [];
  for (const move of moves) {
    const asked = page.asked.findLast(([from]) => from <= move.from);
    const pointer = page.pointer.findLast(([from]) => asked && from <= asked[0] + 0.01);
    const came = page.came.find((at) => at >= move.computed - 0.2);
    const picture = page.render.find(([from, to]) => came && from >= came && to - from > 0.05);
    const over = page.applied.find(([from]) => from === came);
    if (!asked || !pointer || !came || !picture || !over) continue;
    found.push({
      pointer: pointer[1] - pointer[0],
      engine: move.computed - move.from,
      send: move.posted - move.computed,
      apply: Math.min(over[1], picture[0]) - came,
      render: picture[1] - picture[0],
      latency: picture[1] - pointer[0],
      bytes: move.bytes,
    });
  }
  return found;
}

const STAGES = {
  pointer: "pointer event → message",
  engine: "engine: recalculate, mesh, buffers (worker)",
  send: "hand the buffers over (worker)",
  apply: "page takes the answer in",
  render: "upload and draw calls",
  work: "computation, all of these",
  latency: "pointer event → picture, waiting included",
};

function table(all) {
  const lines = Object.entries(STAGES).map(([stage, name]) => {
    const times = all.map((frame) => frame[stage]);
    const [least, middle, most] = [Math.min(...times), median(times), quantile(times, 0.95)];
    return { stage, name, least, median: middle, most };
  });
  for (const { name, least, median: middle, most } of lines) {
    console.log(`${name.padEnd(46)} ${[least, middle, most].map((ms) => ms.toFixed(2).padStart(8)).join("")} ms`);
  }
  return lines;
}

const bench = await Bench.start();
try {
  const started = performance.now();
  const studio = await bench.visit({}, watchPage);
  const opened = performance.now() - started;
  const input = { name: "drag.pfs", mimeType: "text/plain", buffer: Buffer.from(sheet()) };
  await studio.page.setInputFiles("input[type=file]", input);
  await studio.waitFor("A1", /pS44/);
  await studio.settled();
  await studio.page.workers()[0].evaluate(watchWorker);
  const poles = await studio.poles();
  const client = await studio.page.context().newCDPSession(studio.page);
  await client.send("Performance.enable");
  const metrics = async () =>
    Object.fromEntries((await client.send("Performance.getMetrics")).metrics.map(({ name, value }) => [name, value]));
  const before = await metrics();
  await drag(studio, poles[Math.floor(poles.length / 2)]);
  const after = await metrics();
  if (process.env["PICTURE"]) await studio.page.screenshot({ path: process.env["PICTURE"] });
  const page = await studio.page.evaluate(() => globalThis.bench);
  const worker = await studio.page.workers()[0].evaluate(() => self.bench);
  await studio.page.mouse.up();
  await studio.settled();
  const all = frames(page, worker);
  for (const frame of all) frame.work = frame.pointer + frame.engine + frame.send + frame.apply + frame.render;
  console.log(`a pole of a pS44 drawn at 129×129, ${all.length} frames; ${cpus()[0]?.model}, load ${loadavg()[0].toFixed(1)}`);
  console.log(`${"".padEnd(46)} ${["least", "median", "95 %"].map((word) => word.padStart(8)).join("")}`);
  const stages = table(all);
  const share = (name) => (1e3 * (after[name] - before[name])) / (WARM + FRAMES);
  const whole = ["TaskDuration", "ScriptDuration", "LayoutDuration", "RecalcStyleDuration"];
  console.log(`main thread per frame: ${whole.map((name) => `${name} ${share(name).toFixed(2)}`).join(", ")} ms`);
  console.log(`sent per frame: ${(median(all.map((frame) => frame.bytes)) / 1e3).toFixed(0)} kB; opened in ${opened.toFixed(0)} ms`);
  if (process.env["JSON"]) writeFileSync(process.env["JSON"], JSON.stringify({ stages, frames: all.length }));
  if (studio.faults.length > 0) throw new Error(studio.faults.join("\n"));
} finally {
  await bench.stop();
}
