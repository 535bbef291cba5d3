/**
 * The built page in a real browser: a server on a free port, Chromium, and what the tests ask of a page.
 */
import { existsSync, mkdirSync } from "node:fs";
import { createServer } from "node:net";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { preview } from "vite";

const here = dirname(fileURLToPath(import.meta.url));
export const repository = join(here, "..", "..");

/** Drawn by software, since a test machine has no graphics card. */
const FLAGS = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"];
const ALONE = { "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp" };
const BROWSER = process.env["CHROMIUM"] ?? "/usr/bin/chromium";

async function freePort() {
  return new Promise((resolve, reject) => {
    const probe = createServer();
    probe.once("error", reject);
    probe.listen(0, "127.0.0.1", () => {
      const { port } = probe.address();
      probe.close(() => resolve(port));
    });
  });
}

/** How long a busy machine may take to show what was asked for: it ends what hangs, it measures nothing. */
const PATIENCE = 120_000;

/** A served page and a browser, for one file of tests. */
export class Bench {
  static async start() {
    if (!existsSync(join(here, "..", "dist", "index.html"))) throw new Error("build the page first: npm run build");
    const port = await freePort();
    const server = await preview({
      root: join(here, ".."),
      logLevel: "error",
      // Alone in its process, a page may read a fine clock.
      preview: { port, strictPort: true, host: "127.0.0.1", headers: ALONE },
    });
    const browser = await chromium.launch({ executablePath: BROWSER, args: FLAGS });
    return new Bench(server, browser, `http://127.0.0.1:${port}/`);
  }

  constructor(server, browser, address) {
    Object.assign(this, { server, browser, address });
  }

  async stop() {
    await this.browser.close();
    await this.server.close();
  }

  /**
   * A fresh visitor's page, ready for use. `before` runs in it first; `faults` collects what a console
   * would show in red.
   */
  async visit(options = {}, before = null) {
    const context = await this.browser.newContext({
      viewport: { width: 1360, height: 820 },
      locale: "en-GB",
      acceptDownloads: true,
      permissions: ["clipboard-read", "clipboard-write"],
      ...options,
    });
    const page = await context.newPage();
    page.setDefaultTimeout(PATIENCE);
    if (before) await page.addInitScript(before);
    const faults = [];
    page.on("pageerror", (error) => faults.push(String(error)));
    page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
    await page.goto(this.address);
    const studio = new StudioPage(page, faults);
    await studio.ready();
    return studio;
  }
}

/** What a person does with the page. */
export class StudioPage {
  constructor(page, faults) {
    this.page = page;
    this.faults = faults;
  }

  ready() {
    return this.page.waitForSelector(".studio[data-ready]");
  }

  async close() {
    await this.page.context().close();
  }

  cell(address) {
    return this.page.locator(`td[data-address="${address}"]`);
  }

  /** Goes to a cell that is out of sight: only what is seen is laid out. */
  async reveal(address) {
    if ((await this.cell(address).count()) > 0) return;
    await this.page.locator("input.address").fill(address);
    await this.page.locator("input.address").press("Enter");
  }

  /** The text of a cell as it is read, without its cost. */
  async read(address) {
    await this.reveal(address);
    return this.cell(address).evaluate((cell) =>
      [...cell.querySelectorAll(".kind, .text")].map((part) => part.textContent).join(" "),
    );
  }

  /** What stands in the formula bar after a cell was chosen. */
  async source(address) {
    await this.reveal(address);
    await this.cell(address).click();
    return this.page.locator(".editor-area").inputValue();
  }

  /** Types into a cell and accepts; waits until the answer is there. */
  async type(address, text) {
    await this.reveal(address);
    await this.cell(address).click();
    await this.page.keyboard.press("F2");
    await this.page.locator(".editor-area").fill(text);
    await this.page.keyboard.press("Enter");
    // The text is taken when the next cell is chosen; only then does waiting for the answer mean something.
    await this.page.waitForFunction((at) => document.querySelector("input.address")?.value !== at, address);
    await this.settled();
  }

  /** Clicks a cell and waits until the formula bar shows it. */
  async choose(address) {
    await this.reveal(address);
    await this.cell(address).click();
    await this.page.waitForFunction((at) => document.querySelector("input.address")?.value === at, address);
  }

  /** Waits until nothing is computed and the sheet is kept. */
  async settled() {
    await this.page.waitForTimeout(60);
    await this.page.waitForFunction(() => document.querySelector(".studio")?.dataset["calls"] === "0");
  }

  async waitFor(address, pattern) {
    await this.page.waitForFunction(
      ([at, source]) => new RegExp(source).test(document.querySelector(`td[data-address="${at}"]`)?.textContent ?? ""),
      [address, pattern.source],
    );
  }

  /** Pixels of the view, as bytes: red, green, blue, opacity. */
  async pixels() {
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const png = await this.page.locator(".view canvas").screenshot();
    const decoded = await this.page.evaluate(async (base64) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const pen = canvas.getContext("2d");
      pen.drawImage(image, 0, 0);
      const { data } = pen.getImageData(0, 0, image.width, image.height);
      let text = "";
      for (let i = 0; i < data.length; i += 8192) text += String.fromCharCode(...data.subarray(i, i + 8192));
      return { width: image.width, height: image.height, text: btoa(text) };
    }, png.toString("base64"));
    return { ...decoded, data: Buffer.from(decoded.text, "base64") };
  }

  /** How many pixels of the view are like this. */
  async count(like) {
    const { data } = await this.pixels();
    let found = 0;
    for (let i = 0; i < data.length; i += 4) if (like(data[i], data[i + 1], data[i + 2])) found++;
    return found;
  }

  /** The middles of the dots of the selected cell's poles, in pixels of the page, from left to right. */
  async poles() {
    const { data, width, height } = await this.pixels();
    const box = await this.page.locator(".view canvas").boundingBox();
    const places = clusters(data, width, height, POLE);
    return places.map(({ x, y }) => ({ x: box.x + x, y: box.y + y })).sort((a, b) => a.x - b.x);
  }

  async drag(from, to, steps = 8) {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move(to.x, to.y, { steps });
    await mouse.up();
    await this.settled();
  }

  /** Keeps a picture of the page when asked to (PICTURES=1). */
  async picture(name) {
    if (!process.env["PICTURES"]) return;
    const folder = join(here, "pictures");
    mkdirSync(folder, { recursive: true });
    await this.page.screenshot({ path: join(folder, `${name}.png`) });
  }
}

const near = (value, wanted, by) => Math.abs(value - wanted) <= by;

/** The colour of the dots of the selected cell, on light ground. */
const POLE = (r, g, b) => near(r, 15, 12) && near(g, 127, 12) && near(b, 140, 12);

export const GOLD = (r, g, b) => r > 150 && g > 100 && r - b > 60 && r >= g;
export const RED = (r, g, b) => r > 100 && r - g > 50 && r - b > 30 && g < 130;

/** Pixels of a colour that touch one another, as middles; specks are left out. */
function clusters(data, width, height, like) {
  const seen = new Uint8Array(width * height);
  const found = [];
  for (let start = 0; start < seen.length; start++) {
    if (seen[start] || !like(...data.subarray(4 * start, 4 * start + 3))) continue;
    let [count, sumX, sumY] = [0, 0, 0];
    const waiting = [start];
    seen[start] = 1;
    while (waiting.length > 0) {
      const at = waiting.pop();
      const [x, y] = [at % width, Math.floor(at / width)];
      count++;
      sumX += x;
      sumY += y;
      for (const next of [at - 1, at + 1, at - width, at + width]) {
        if (next < 0 || next >= seen.length || seen[next] || Math.abs((next % width) - x) > 1) continue;
        if (!like(...data.subarray(4 * next, 4 * next + 3))) continue;
        seen[next] = 1;
        waiting.push(next);
      }
    }
    if (count >= 40) found.push({ x: sumX / count, y: sumY / count });
  }
  return found;
}
