// The page of `glassbox bench --html`: its bars and curves are as long and high as the times that stand below them.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {coloured, openPage, settled} from "./browser.mjs";
import {file, hostile, test} from "./cases.mjs";

const program = path.resolve(process.argv[2]);

function bench(name, ...words) {
  fs.mkdirSync(file("bench"), {recursive: true});
  execFileSync(program, ["bench", ...words, "--size", "64x36", "--frames", "1", "--html", `${name}.html`], {stdio: "pipe", cwd: file("bench")});
  return file("bench", `${name}.html`);
}

// A page with other results in it.
function benchOf(name, results, scaling = []) {
  const page = fs.readFileSync(bench(name, "cube", "--threads", "1"), "utf8");
  const manifest = JSON.stringify({results, scaling}).replaceAll("<", "\\u003c");
  fs.writeFileSync(file("bench", `${name}.html`), page.replace(/(id="manifest">)[^]*?(<\/script>)/, (all, before, after) => before + manifest + after));
  return file("bench", `${name}.html`);
}
const result = (scene, threads, ms, peer_ms = null, floor_ms = undefined) => ({scene, threads, ms, peer: peer_ms && "a peer", peer_ms, ratio: peer_ms && peer_ms / ms, floor_ms});
const bars = "canvas[aria-label^=Milliseconds]", curve = 'canvas[aria-label^="Time against"]';

// What is written on a canvas.
const watchTexts = () => {
  window.written = [];
  const {fillText} = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
    window.written.push(text);
    return fillText.call(this, text, ...rest);
  };
};

test("bench: all bars are on one scale, each with its time, beside the scene's end, the threads and the ratio", async () => {
  const results = [result("S1", 1, 99.97, 400, 2), result("S1", 2, 51.23456, 200, 1), result("a/".repeat(30) + "the-end.obj", 1, 1234.5678, 617.2839, .3814), result(hostile, 1, .5)];
  const opened = await openPage(benchOf("all", results), {}, "", watchTexts), {page} = opened;
  const lengths = await page.locator(bars).evaluate((canvas) => {
    const chart = Chart.getChart(canvas);
    return chart.data.datasets.flatMap(({data}, i) => data.map((ms, at) => [ms, chart.getDatasetMeta(i).data[at].x - chart.scales.x.getPixelForValue(0)]));
  });
  assert.equal(lengths.length, 12);
  const [longest, width] = lengths.find(([ms]) => ms === 1234.5678);
  assert.ok(width > 600);
  for (const [ms, length] of lengths.filter(([time]) => time !== null)) assert.ok(Math.abs(length - width * ms / longest) < .01, `${length} px for ${ms} ms, ${width} for ${longest}`);
  const written = await page.evaluate(() => window.written);
  for (const text of ["100.0 ms", "51.2 ms", "1235 ms", "617 ms", "0.381 ms", "S1", "1 thread", "2 threads", "ratio 4.00", "ratio 3.90", "ratio 0.500", "Glassbox", "peer", "floor"])
    assert.ok(written.includes(text), text);
  assert.ok(written.some((text) => text.startsWith("…") && text.endsWith("/the-end.obj")));
  const words = await page.locator("main").innerText();
  assert.match(words, /The peer is a peer; the ratio is its time divided by that of Glassbox\./);
  assert.match(words, /The floor is the time that the memory needs to move the necessary bytes/);
  for (const colour of [[0, 0x72, 0xb2], [0xd5, 0x5e, 0], [0, 0x9e, 0x73]]) assert.ok(await coloured(page, bars, colour) > 5, colour);
  return opened;
});

test("bench: a page without a peer and a floor names none", async () => {
  const opened = await openPage(bench("alone", "cube", "S2", "--threads", "1"), {}, "", watchTexts), {page} = opened;
  assert.ok(!/peer|ratio|floor|undefined|NaN/.test(await page.locator("main").innerText() + await page.evaluate(() => window.written)));
  assert.equal(await page.locator("canvas:not([aria-label])").count(), 0);
  return opened;
});

test("bench: a curve goes through its points, and a line stands where it bends", async () => {
  const points = [1000, 10000, 100000].map((x) => ({x, ms: x / 5000, ms_quartiles: [x / 6000, x / 4000], peak_bytes: 1}));
  const opened = await openPage(benchOf("bent", [], [{by: "triangles", told: "time grows", points, bend: {at: 10000, exponent_before: .5, exponent_after: 1}}])), {page} = opened;
  const {places, bend} = await page.locator(curve).evaluate((canvas) => {
    const chart = Chart.getChart(canvas), {x, y, bend: line} = chart.scales;
    return {places: chart.getDatasetMeta(0).data.map((point) => [x.getValueForPixel(point.x), y.getValueForPixel(point.y)]),
      bend: line.ticks.map(({value, label}) => [value, label, line.getPixelForValue(value) - x.getPixelForValue(value)])};
  });
  places.forEach(([x, ms], i) => assert.ok(Math.abs(x / points[i].x - 1) + Math.abs(ms / points[i].ms - 1) < 1e-6, `${x}, ${ms}`));
  assert.deepEqual(bend, [[10000, "the exponent changes here", 0]]);
  const {x, y} = await page.locator(curve).evaluate((canvas) => Chart.getChart(canvas).getDatasetMeta(0).data[1].getProps(["x", "y"]));
  await page.locator(curve).hover({position: {x, y}});
  const told = await page.waitForFunction((canvas) => {
    const {tooltip} = Chart.getChart(document.querySelector(canvas));
    return tooltip.opacity > 0 && tooltip.body.flatMap(({lines}) => lines);
  }, curve);
  assert.deepEqual(await told.jsonValue(), ["10,000 triangles", "2.00 ms (1.67 to 2.50)"]);
  return opened;
});

test("bench: the page fits every screen and scheme, and paper has light colours", async () => {
  const made = benchOf("wide", [result("a/".repeat(40) + "the-end.obj", 2, 100, 400, 2), result("S3", 1, 3, 2, 1)]);
  for (const width of [360, 768, 1280, 1920]) {
    for (const colorScheme of ["light", "dark"]) {
      const {page, problems, close} = await openPage(made, {viewport: {width, height: 900}, colorScheme});
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${width} px`);
      assert.ok(await coloured(page, bars, colorScheme === "dark" ? [0x56, 0xb4, 0xe9] : [0, 0x72, 0xb2]) > 100, colorScheme);
      assert.deepEqual(problems, []);
      await close();
    }
  }
  const opened = await openPage(made, {colorScheme: "dark"}), {page} = opened;
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.ok(await coloured(page, bars, [0, 0x72, 0xb2]) > 100);
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await page.emulateMedia({colorScheme: "light"});
  await settled(page);
  assert.ok(await coloured(page, bars, [0, 0x72, 0xb2]) > 100, "drawn again when the scheme changes");
  return opened;
});

test("bench: screenshots", async () => {
  fs.mkdirSync(file("screenshots"), {recursive: true});
  const bars = bench("real", "S1", "S2", "S3", "--threads", "1,2", "--floor"), curve = bench("grows", "--scaling", "triangles", "--most", "30000");
  for (const [name, page, settings] of [["bench-light", bars, {}], ["bench-dark", bars, {colorScheme: "dark"}], ["scaling-dark", curve, {colorScheme: "dark"}]]) {
    const {page: shown, problems, close} = await openPage(page, settings);
    await shown.screenshot({path: file("screenshots", `${name}.png`), fullPage: true});
    assert.deepEqual(problems, []);
    await close();
  }
});
