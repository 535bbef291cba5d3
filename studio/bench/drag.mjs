/**
 * One pole of a pS44 drawn at 129×129 is dragged through many places: what a frame costs, stage by stage.
 *
 *   npm run bench            (CHROMIUM=path, FRAMES=200, JSON=file, PICTURE=file.png)
 */
import { writeFileSync } from "node:fs";
import { cpus, loadavg } from "node:os";
import { Bench } from "../e2e/studio.mjs";
import { watchPage, watchWorker } from "./probe.mjs";
import { sheet } from "./sheet.mjs";

const FRAMES = Number(process.env["FRAMES"] ?? 200);
const WARM = 20;
const VISITS = 5;

const STAGES = {
  pointer: "pointer event to message",
  engine: "recalculate, mesh, buffers (worker)",
  send: "hand the buffers over (worker)",
  apply: "page takes the answer in",
  render: "upload and draw calls",
  work: "computation, all of these",
  latency: "pointer event to picture, waiting included",
};

function quantile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? Number.NaN;
}

/** Milliseconds from the first byte asked for to the page ready for use. */
async function opening(bench) {
  const times = [];
  for (let visit = 0; visit < VISITS; visit++) {
    const studio = await bench.visit({}, watchPage);
    times.push(...(await studio.page.evaluate(() => globalThis.bench.opened)));
    await studio.close();
  }
  return times;
}

/** A page with the surface open, watched from now on, and a pole to be dragged. */
async function surface(bench) {
  const studio = await bench.visit({}, watchPage);
  const input = { name: "drag.pfs", mimeType: "text/plain", buffer: Buffer.from(sheet()) };
  await studio.page.setInputFiles("input[type=file]", input);
  await studio.waitFor("A1", /pS44/);
  await studio.settled();
  await studio.page.workers()[0].evaluate(watchWorker);
  const poles = await studio.poles();
  return { studio, pole: poles[Math.floor(poles.length / 2)] };
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
  return moves.flatMap((move) => frame(page, move) ?? []);
}

function frame(page, move) {
  const asked = page.asked.findLast(([from]) => from <= move.from);
  const pointer = page.pointer.findLast(([from]) => asked && from <= asked[0] + 0.01);
  const came = page.came.find((at) => at >= move.computed - 0.2);
  const picture = page.render.find(([from, to]) => came && from >= came && to - from > 0.05);
  const over = page.applied.find(([from]) => from === came);
  if (!asked || !pointer || !came || !picture || !over) return null;
  const stages = {
    pointer: pointer[1] - pointer[0],
    engine: move.computed - move.from,
    send: move.posted - move.computed,
    apply: Math.min(over[1], picture[0]) - came,
    render: picture[1] - picture[0],
  };
  const work = Object.values(stages).reduce((sum, time) => sum + time, 0);
  return { ...stages, work, latency: picture[1] - pointer[0], bytes: move.bytes };
}

function report(all, opened) {
  const stages = Object.entries(STAGES).map(([stage, name]) => {
    const times = all.map((one) => one[stage]);
    return { stage, name, least: Math.min(...times), median: quantile(times, 0.5), most: quantile(times, 0.95) };
  });
  const kilobytes = quantile(all.map((one) => one.bytes), 0.5) / 1e3;
  return { frames: all.length, stages, kilobytes, opened: { least: Math.min(...opened), median: quantile(opened, 0.5) } };
}

function print({ frames, stages, kilobytes, opened }) {
  console.log(`Studio: one pole of a pS44 drawn at 129×129 is dragged, ${frames} frames, milliseconds`);
  console.log(`${cpus()[0]?.model}, drawn by software, load ${loadavg()[0].toFixed(1)}`);
  const line = (name, numbers) => console.log(name.padEnd(44) + numbers.map((text) => text.padStart(9)).join(""));
  line("", ["least", "median", "95 %"]);
  for (const { name, least, median, most } of stages) line(name, [least, median, most].map((ms) => ms.toFixed(2)));
  line("page opens on its first example", [opened.least.toFixed(0), opened.median.toFixed(0)]);
  console.log(`${kilobytes.toFixed(0)} kB from worker to page in each frame`);
}

const bench = await Bench.start();
try {
  const opened = await opening(bench);
  const { studio, pole } = await surface(bench);
  await drag(studio, pole);
  if (process.env["PICTURE"]) await studio.page.screenshot({ path: process.env["PICTURE"] });
  const page = await studio.page.evaluate(() => globalThis.bench);
  const worker = await studio.page.workers()[0].evaluate(() => self.bench);
  await studio.page.mouse.up();
  await studio.settled();
  const found = report(frames(page, worker), opened);
  print(found);
  if (process.env["JSON"]) writeFileSync(process.env["JSON"], JSON.stringify(found, null, 2));
  if (studio.faults.length > 0) throw new Error(studio.faults.join("\n"));
} finally {
  await bench.stop();
}
