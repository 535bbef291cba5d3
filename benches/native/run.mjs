// Prints the seconds of a work in WebAssembly, and the sum of its results.
//   node run.mjs MODULE.wasm NUMBER PASSES
import { readFile } from "node:fs/promises";

const [file, number, passes] = process.argv.slice(2);
const clock = { now: () => performance.now() / 1000 };
const { instance } = await WebAssembly.instantiate(await readFile(file), { clock });
const { seconds, sum } = instance.exports;
console.log(seconds(Number(number), Number(passes)), sum(Number(number)));
