// What a page of 1,000 pairs takes, for docs/diff.md:
//
//     node measure_diff.mjs PROGRAM DIRECTORY [PAIRS]
//
// Renders pictures of 640 x 360 px into DIRECTORY, copies them to as many pairs as asked for, changes every tenth in one of
// five ways, leaves every hundredth without its reference, and prints for the page in one file and for the page with its
// files: the time to write it, its size, and the time until a browser lists all pairs and has drawn them, of five tries the
// middle one. Needs playwright-core beside it (npm install), as the tests do.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {closeBrowser, openPage} from "./browser.mjs";
import {decodePng, encodePng} from "./pictures.mjs";

const [, , programPath, directory, pairs = "1000"] = process.argv;
const program = path.resolve(programPath), here = path.resolve(directory);
const at = (...names) => path.join(here, ...names);

// A pseudo-random whole number below `end`, the same every time.
let random = 1;
const below = (end) => (random = (random * 48271) % 2147483647) % end;

const changes = [
  (samples) => { samples[3 * below(samples.length / 3)] ^= 64; },
  (samples) => { for (let i = 0; i < 4000; i++) samples[below(samples.length)] ^= 1; },
  (samples, width) => {
    for (let y = 100; y < 160; y++) for (let x = 300; x < 400; x++) samples[3 * (y * width + x)] = 255;
  },
  (samples) => { for (let i = 0; i < samples.length; i++) samples[i] = Math.min(samples[i] + 3, 255); },
  (samples, width) => samples.copyWithin(3 * width, 0, samples.length - 3 * width),
];

function changed(file, way) {
  const picture = decodePng(file);
  changes[way](picture.samples, picture.width);
  return encodePng(picture);
}

function writePairs() {
  for (const side of ["reference", "test"]) fs.mkdirSync(at(side), {recursive: true});
  const renders = ["teapot", "forest", "room", "thicket", "checker", "sphere"].map((scene) => {
    execFileSync(program, ["render", scene, "--size", "640x360", "-o", at(`${scene}.png`)], {stdio: "pipe"});
    return [scene, fs.readFileSync(at(`${scene}.png`))];
  });
  for (let i = 0; i < Number(pairs); i++) {
    const [scene, file] = renders[i % renders.length], name = `${scene}-${i}.png`;
    if (i % 100 !== 50) fs.writeFileSync(at("reference", name), file);
    fs.writeFileSync(at("test", name), i % 10 === 3 ? changed(file, (i - 3) / 10 % changes.length) : file);
  }
}

// The seconds of the command, without and with its page.
function diff(...options) {
  const start = performance.now();
  try {
    execFileSync(program, ["diff", at("reference"), at("test"), ...options], {stdio: "pipe"});
  } catch (error) {
    if (![1, 2].includes(error.status)) throw error;
  }
  return (performance.now() - start) / 1000;
}

const bytesOf = (name) => fs.statSync(name).isDirectory()
  ? fs.readdirSync(name).reduce((sum, each) => sum + bytesOf(path.join(name, each)), 0) : fs.statSync(name).size;
const middle = (numbers) => numbers.sort((a, b) => a - b)[numbers.length >> 1];

// Milliseconds from the start of the navigation until the list is drawn.
const listTime = `addEventListener("DOMContentLoaded", () => requestAnimationFrame(() => setTimeout(() => {
  window.listed = [performance.now(), document.querySelectorAll("#pairs li").length];
})));`;
async function openingTime(page) {
  const times = [];
  for (let i = 0; i < 5; i++) {
    const opened = await openPage(page, {viewport: {width: 1400, height: 900}}, "", listTime);
    const [time, rows] = await opened.page.evaluate(() => window.listed);
    if (rows !== Number(pairs) || opened.problems.length) throw new Error(`${rows} rows; ${opened.problems}`);
    times.push(time);
    await opened.close();
  }
  return middle(times);
}

writePairs();
const without = diff();
console.log(`${pairs} pairs; without a page: ${without.toFixed(1)} s`);
for (const [name, ...options] of [["one.html"], ["files.html", "--html-files"]]) {
  const seconds = diff("--html", at(name), ...options), folder = at(name.replace(".html", "-files"));
  const beside = fs.existsSync(folder) ? `, ${(bytesOf(folder) / 1e6).toFixed(1)} MB beside it` : "";
  console.log(`${name}: ${seconds.toFixed(1)} s, ${(bytesOf(at(name)) / 1e6).toFixed(1)} MB${beside}; ` +
    `listed after ${(await openingTime(at(name))).toFixed(0)} ms`);
}
await closeBrowser();
