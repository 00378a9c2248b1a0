// Compares glassbox diff with odiff, pixelmatch and reg-cli on the same pictures, and prints the tables of docs/diff.md and
// of docs/metrics.md (Cost).
//
//     node tests/peers/diff_peers.mjs build/release [FOLDER]
//
// The build needs the targets test_compare, which draws the pictures, and glassbox_program. The tools come from npm and are
// kept in FOLDER. Where they cannot be had, the script says so and ends with 0.
import {execFileSync, spawnSync} from "node:child_process";
import fs from "node:fs";
import {createRequire} from "node:module";
import os from "node:os";
import path from "node:path";

const here = import.meta.dirname;
const build = path.resolve(process.argv[2] ?? "build/release");
const folder = path.resolve(process.argv[3] ?? fs.mkdtempSync(path.join(os.tmpdir(), "diff-peers-")));
const program = process.env.GLASSBOX ?? path.join(build, "app", "glassbox");
const file = (...names) => path.join(folder, ...names);

function install() {
  fs.mkdirSync(folder, {recursive: true});
  fs.copyFileSync(path.join(here, "package.json"), file("package.json"));
  const {status} = spawnSync("npm", ["install", "--silent", "--no-audit", "--no-fund"], {cwd: folder, stdio: "inherit"});
  if (status === 0) return;
  console.log("skipped: npm, or the tools that it should install, are not there");
  process.exit(0);
}

install();
const load = (name) => import(createRequire(file("package.json")).resolve(name)).then((loaded) => loaded.default);
const {PNG} = await load("pngjs");
const pixelmatch = {7: await load("pixelmatch7"), 8: await load("pixelmatch")};
const odiff = file("node_modules", ".bin", "odiff"), regCli = file("node_modules", ".bin", "reg-cli");

const readPng = (name) => PNG.sync.read(fs.readFileSync(name));
const writePng = (name, png) => fs.writeFileSync(name, PNG.sync.write(png));

// The pairs of pictures that the project's test draws: those that only moved, and those with changed pixels among them.
function corpus() {
  fs.rmSync(file("corpus"), {recursive: true, force: true});
  fs.mkdirSync(file("corpus"), {recursive: true});
  execFileSync(path.join(build, "tests", "compare", "test_compare"), ["[corpus]"],
    {env: {...process.env, CORPUS: file("corpus")}, stdio: "pipe"});
  return fs.readdirSync(file("corpus")).filter((name) => name.endsWith(".txt")).map((name) => {
    const stem = file("corpus", name.slice(0, -4));
    const lines = fs.readFileSync(`${stem}.txt`, "utf8").split("\n").filter(Boolean).map((line) => line.split(" "));
    return {
      name: name.slice(0, -4), reference: `${stem}-reference.png`, test: `${stem}-test.png`,
      changed: lines.map(([x, y, kind]) => ({x: Number(x), y: Number(y), kind})),
    };
  });
}

// Runs a program that must end with one of these statuses, because a tool that failed has reported nothing.
function run(command, words, ...statuses) {
  const {status, stdout, stderr} = spawnSync(command, words, {stdio: "pipe", maxBuffer: 1 << 28});
  if (statuses.includes(status)) return {status, stdout};
  throw new Error(`${command} ${words.join(" ")} ended with ${status}: ${stderr}`);
}

const kOdiffStatuses = [0, 21, 22];  // the same, another size, other pixels

// Each tool gives the pixels that it reports, as an array of 0 and 1.

function byPixelmatch(version, threshold) {
  return ({reference, test}) => {
    const a = readPng(reference), b = readPng(test), mask = new PNG({width: a.width, height: a.height});
    pixelmatch[version](a.data, b.data, mask.data, a.width, a.height, {threshold, diffMask: true});
    return reported(mask, (data, i) => data[i + 3] > 0);
  };
}

function byOdiff(threshold) {
  return ({reference, test}) => {
    const out = file("odiff.png");
    fs.rmSync(out, {force: true});
    const {status} = run(odiff, [reference, test, out, "--aa", "--diff-mask", `--threshold=${threshold}`], ...kOdiffStatuses);
    if (status === 0) return reported(readPng(reference), () => false);  // it writes no picture
    return reported(readPng(out), (data, i) => data[i + 3] > 0);
  };
}

// In the heat map, what is the same is black, and what is set aside has one of two colours.
function byGlassbox(...options) {
  const aside = ["0,0,0", "0,160,120", "0,90,170"];
  return ({reference, test}) => {
    fs.rmSync(file("heat.png"), {force: true});
    run(program, ["diff", reference, test, "-o", file("heat.png"), ...options], 0, 1);
    return reported(readPng(file("heat.png")), (data, i) => !aside.includes(data.subarray(i, i + 3).join()));
  };
}

function reported({data}, isReported) {
  return Uint8Array.from({length: data.length / 4}, (_, i) => Number(isReported(data, 4 * i)));
}

const tools = {
  "glassbox --ignore-antialiasing": byGlassbox("--ignore-antialiasing"),
  "the same with --threshold 0.1": byGlassbox("--ignore-antialiasing", "--threshold", "0.1"),
  "odiff --aa": byOdiff(0.1),
  "odiff --aa, threshold 0": byOdiff(0),
  "pixelmatch 7": byPixelmatch(7, 0.1),
  "pixelmatch 7, threshold 0": byPixelmatch(7, 0),
  "pixelmatch 8": byPixelmatch(8, 0.1),
};

function differing({reference, test}) {
  const a = readPng(reference), b = readPng(test);
  return reported(a, (data, i) => [0, 1, 2, 3].some((c) => data[i + c] !== b.data[i + c]));
}

// How often a tool is right, pixel by pixel and picture by picture. `changed` are pixels on plain ground or beside edges.
function judge(tool, pairs) {
  const sum = {moved: 0, movedReported: 0, changed: 0, changedFound: 0, still: 0, passed: 0, other: 0, found: 0};
  for (const pair of pairs) {
    const reports = tool(pair), {width} = readPng(pair.reference);
    const changed = new Set(pair.changed.map(({x, y}) => y * width + x));
    let any = 0;
    pair.differing.forEach((differs, i) => {
      if (!differs) return;
      const found = reports[i];
      any ||= found;
      sum[changed.has(i) ? "changed" : "moved"] += 1;
      sum[changed.has(i) ? "changedFound" : "movedReported"] += found;
    });
    sum[changed.size ? "other" : "still"] += 1;
    if (changed.size) sum.found += any;
    else sum.passed += 1 - any;
  }
  return sum;
}

const percent = (part, whole) => `${(100 * part / whole).toFixed(1)} %`;
const row = (cells) => console.log(`| ${cells.join(" | ")} |`);

const count = (number) => number.toLocaleString("en");

// `text` is the pair of a browser's text, or nothing.
function printAccuracy(pairs, text) {
  const {moved, changed, other} = judge(differing, pairs);
  console.log(`${count(moved)} pixels differ because they moved, and ${count(changed)} pixels of ${other} pictures changed;`);
  console.log(text ? `of a browser's text, ${count(text.differing.filter(Boolean).length)} pixels moved.`
    : "skipped: the text of a browser, because chromium is not there");
  console.log();
  row(["", "moved pixels reported", "precision", "recall", "pictures that only moved: passed", "with changed pixels: found",
    "of a browser's text reported"]);
  row(Array(7).fill("---"));
  for (const [name, tool] of Object.entries(tools)) {
    const sum = judge(tool, pairs), right = sum.changedFound;
    row([name, percent(sum.movedReported, sum.moved), percent(right, right + sum.movedReported), percent(right, sum.changed),
      `${sum.passed} of ${sum.still}`, `${sum.found} of ${sum.other}`,
      text ? count(tool(text).filter(Boolean).length) : "not measured"]);
  }
}

// What reg-cli says of folders; it gives no pixels.
function printRegCli(pairs) {
  for (const [side, key] of [["expected", "reference"], ["actual", "test"]]) {
    fs.rmSync(file(side), {recursive: true, force: true});
    fs.mkdirSync(file(side));
    for (const pair of pairs) fs.copyFileSync(pair[key], file(side, `${pair.name}.png`));
  }
  const verdicts = (name, failed) => {
    const still = pairs.filter(({changed}) => !changed.length), other = pairs.filter(({changed}) => changed.length);
    const passed = (some) => some.filter(({name}) => !failed.has(`${name}.png`)).length;
    row([name, `${passed(still)} of ${still.length}`, `${other.length - passed(other)} of ${other.length}`]);
  };
  console.log();
  row(["folders", "pictures that only moved: passed", "with changed pixels: found"]);
  row(Array(3).fill("---"));
  const reg = file("reg.json");
  fs.rmSync(reg, {force: true});
  run(regCli, [file("actual"), file("expected"), file("diff"), "-J", reg, "-A", "-M", "0.1"], 0, 1);
  verdicts("reg-cli -A -M 0.1", new Set(JSON.parse(fs.readFileSync(reg)).failedItems));
  for (const options of [["--ignore-antialiasing"], ["--ignore-antialiasing", "--threshold", "0.1"]]) {
    const {stdout} = run(program, ["diff", file("expected"), file("actual"), "--json", "-", ...options], 0, 1);
    const {pictures} = JSON.parse(stdout);
    verdicts(`glassbox ${options.join(" ")}`,
      new Set(pictures.filter(({verdict}) => verdict === "different").map(({name}) => name)));
  }
}

// Two pictures that are the same to a person: one with an opaque alpha channel, and one with more rows.
function printVerdicts(pair) {
  const rgb = readPng(pair.reference), higher = new PNG({width: rgb.width, height: rgb.height + 10});
  rgb.data.copy(higher.data);
  writePng(file("higher.png"), higher);
  fs.writeFileSync(file("rgb.png"), PNG.sync.write(rgb, {colorType: 2}));
  fs.writeFileSync(file("rgba.png"), PNG.sync.write(rgb, {colorType: 6}));
  const verdict = (command, ...words) => run(command, words, 0, 1, ...kOdiffStatuses).status === 0 ? "same" : "different";
  console.log();
  row(["verdict", "odiff", "glassbox"]);
  row(["---", "---", "---"]);
  row(["opaque RGBA against RGB", verdict(odiff, file("rgb.png"), file("rgba.png"), file("o.png")),
    verdict(program, "diff", file("rgb.png"), file("rgba.png"))]);
  row(["ten rows more", verdict(odiff, file("rgb.png"), file("higher.png"), file("o.png")),
    verdict(program, "diff", file("rgb.png"), file("higher.png"))]);
}

// The same text twice, the second time a part of a pixel elsewhere, as a browser draws it. Nothing without a browser.
function browserText() {
  const words = "The quick brown fox jumps over the lazy dog, 0123456789. <b>Bold</b>, <i>slanted</i> and <small>small</small>. ";
  const pictures = {};
  for (const [key, shift] of Object.entries({reference: "none", test: "translate(0.3px, 0.2px)"})) {
    const page = file(`${key}.html`);
    pictures[key] = file(`browser-${key}.png`);
    fs.rmSync(pictures[key], {force: true});
    fs.writeFileSync(page, `<body style="margin: 0; background: #fff"><p style="margin: 10px; font: 14px 'DejaVu Sans', sans-serif;
      transform: ${shift}">${words.repeat(6)}`);
    spawnSync("chromium", ["--headless", "--no-sandbox", "--disable-gpu", "--window-size=640,240",
      `--screenshot=${pictures[key]}`, `file://${page}`], {stdio: "pipe", timeout: 120000});
  }
  return fs.existsSync(pictures.test) ? {...pictures, differing: differing(pictures)} : undefined;
}

// A pair of 4096 x 2304 pixels of which the small one is a tile.
function largePair({reference, test}) {
  const large = {};
  for (const [key, name] of Object.entries({reference, test})) {
    const tile = readPng(name), png = new PNG({width: 4096, height: 2304});
    for (let y = 0; y < png.height; y += tile.height) {
      for (let x = 0; x < png.width; x += tile.width) {
        PNG.bitblt(tile, png, 0, 0, Math.min(tile.width, png.width - x), Math.min(tile.height, png.height - y), x, y);
      }
    }
    large[key] = file(`large-${key}.png`);
    fs.writeFileSync(large[key], PNG.sync.write(png, {colorType: 2}));
  }
  return large;
}

// The large reference, and the same picture with one pixel inverted.
function onePixelPair({reference}) {
  const png = readPng(reference), middle = 4 * (1152 * png.width + 2048);
  for (let c = 0; c < 3; c++) png.data[middle + c] = 255 - png.data[middle + c];
  fs.writeFileSync(file("large-one.png"), PNG.sync.write(png, {colorType: 2}));
  return {reference, test: file("large-one.png")};
}

// The median of the processor time of five runs, in seconds.
function processorTime(command, ...words) {
  const times = [];
  for (let i = 0; i < 5; i++) {
    const before = timeOfChildren();
    run(command, words, 1, ...kOdiffStatuses);
    times.push(timeOfChildren() - before);
  }
  return times.sort((a, b) => a - b)[2].toFixed(2);
}

// The processor time of all ended children, in seconds.
function timeOfChildren() {
  const fields = fs.readFileSync("/proc/self/stat", "utf8").split(") ")[1].split(" ");
  return (Number(fields[13]) + Number(fields[14])) / 100;
}

function printTimes({reference, test}) {
  console.log();
  row(["4096 x 2304, processor time in s", "verdict", "with a picture of the differences", "moved edges set aside"]);
  row(["---", "---", "---", "---"]);
  row(["glassbox", processorTime(program, "diff", reference, test),
    processorTime(program, "diff", reference, test, "-o", file("heat.png")),
    processorTime(program, "diff", reference, test, "--ignore-antialiasing")]);
  row(["odiff", processorTime(odiff, reference, test), processorTime(odiff, reference, test, file("odiff.png")),
    processorTime(odiff, reference, test, "--aa")]);
}

function printTimesOfMetrics(large) {
  const metrics = ["", "rmse", "ssim", "flip", "flip,ssim,psnr"];
  const times = ({reference, test}) => metrics.map((metric) =>
    processorTime(program, "diff", reference, test, ...(metric ? ["--metric", metric] : [])));
  console.log();
  row(["processor time in s", "no metric", ...metrics.slice(1)]);
  row(Array(6).fill("---"));
  row(["1.65 million pixels differ, all over the picture", ...times(large)]);
  row(["one pixel differs", ...times(onePixelPair(large))]);
}

const pairs = corpus().map((pair) => ({...pair, differing: differing(pair)}));
printAccuracy(pairs, browserText());
printRegCli(pairs);
printVerdicts(pairs[0]);
const large = largePair(pairs.find(({name}) => name === "grey-text-0.3-moved"));
printTimes(large);
printTimesOfMetrics(large);
