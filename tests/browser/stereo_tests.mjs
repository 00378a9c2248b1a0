// The page of `glassbox stereo --html`: its pictures are the run's, and it can be used with keys, calmly, and on any screen.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {coloured, namelessControls, openPage, shadowsOf} from "./browser.mjs";
import {file, hostile, test} from "./cases.mjs";
import {decodePng} from "./pictures.mjs";

const program = path.resolve(process.argv[2]);
const run = (...words) => execFileSync(program, words, {stdio: "pipe", cwd: file("stereo")});

function stereo(name, scene, ...options) {
  fs.mkdirSync(file("stereo"), {recursive: true});
  run("stereo", scene, ...options, "--html", `${name}.html`);
  return file("stereo", `${name}.html`);
}
const room = ["--size", "320x180", "--eye-separation", "0.4", "--target-rivalry", "0.03"];
const moving = {reducedMotion: "no-preference"};
const shownPictures = (page) => page.locator("#shown img").evaluateAll((all) => all.map((img) => img.alt));

test("stereo: the eyes and the anaglyph are the pictures that render draws", async () => {
  const opened = await openPage(stereo("room", "room", ...room)), {page} = opened;
  for (const [name, words] of [["left", ["--seen-by", "left"]], ["right", ["--seen-by", "right"]], ["anaglyph", ["--stereo", "anaglyph"]]]) {
    run("render", "room", "--size", "320x180", "--eye-separation", "0.4", ...words, "-o", `${name}.png`);
    const source = await page.evaluate((key) => JSON.parse(document.getElementById("manifest").textContent).pictures[key], name);
    const [shown, drawn] = [Buffer.from(source.split(",")[1], "base64"), fs.readFileSync(file("stereo", `${name}.png`))].map(decodePng);
    assert.deepEqual(shown, drawn, name);
  }
  const broken = await page.locator("img[alt]").evaluateAll((all) => all.filter((img) => img.src && !img.naturalWidth).map((img) => img.alt));
  assert.deepEqual(broken, []);
  return opened;
});

test("stereo: keys choose a picture and swap the eyes", async () => {
  const opened = await openPage(stereo("room", "room", ...room)), {page} = opened;
  assert.deepEqual(await shownPictures(page), ["The anaglyph of both eyes' pictures"]);
  await page.locator("#views input").first().focus();
  await page.keyboard.press("ArrowRight");
  assert.deepEqual(await shownPictures(page), ["What the left eye sees"]);
  await page.locator("#swap").press("Enter");
  assert.deepEqual(await shownPictures(page), ["What the right eye sees"]);
  assert.equal(await page.locator("#views :checked").inputValue(), "right");
  await page.locator("#views [value=crossed]").check({force: true});
  assert.deepEqual(await shownPictures(page), ["What the right eye sees", "What the left eye sees"]);
  return opened;
});

test("stereo: a map opens in full size and closes with Escape, where the keys were", async () => {
  const opened = await openPage(stereo("room", "room", ...room)), {page} = opened;
  const button = page.getByRole("button", {name: "Disparity of the left eye's pixels: open in full size"});
  await button.press("Enter");
  assert.ok(await page.locator("#large").isVisible());
  assert.equal(await page.textContent("#large-title"), "Disparity of the left eye's pixels");
  const box = await page.locator("#large-picture").boundingBox();
  assert.ok(box.height <= 800 && box.width <= 1280 && box.width > 600, JSON.stringify(box));
  await page.keyboard.press("Escape");
  assert.ok(!await page.locator("#large").isVisible());
  assert.ok(await button.evaluate((node) => node === document.activeElement));
  return opened;
});

const histogram = 'canvas[aria-label^="Histogram:"]', compromise = 'canvas[aria-label^="Rivalry falls"]';

test("stereo: bars stand in the map's colours between lines of the budget, and the goal is a line beside the curve", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const {page, problems, close} = await openPage(stereo("near", "room", "--size", "320x180", "--eye-separation", "0.6", "--target-rivalry", "0.03"), {colorScheme});
    const bad = colorScheme === "dark" ? [0xff, 0x8a, 0x80] : [0xb3, 0x26, 0x1e], {disparity, scales} = await page.evaluate(() => JSON.parse(document.getElementById("manifest").textContent));
    assert.ok(disparity.share_beyond_budget > 0);
    const {bars, lines, plain} = await page.locator(histogram).evaluate((canvas) => {
      const chart = Chart.getChart(canvas), [{data, backgroundColor: colours}] = chart.data.datasets, elements = chart.getDatasetMeta(0).data;
      return {plain: colours.filter((colour) => typeof colour === "string"), lines: chart.scales.budget.ticks.map(({value, label}) => [value, label]),
        bars: data.map(({x, low, high}, i) => ({x, low, high, striped: typeof colours[i] !== "string", left: chart.scales.x.getValueForPixel(elements[i].x - elements[i].width / 2),
          right: chart.scales.x.getValueForPixel(elements[i].x + elements[i].width / 2), height: elements[i].base - elements[i].y}))};
    });
    const counts = disparity.histogram.counts, highest = Math.max(...bars.map(({height}) => height));
    assert.equal(bars.length, counts.length + 2);
    bars.forEach(({x, low, high, striped, left, right, height}, i) => {
      assert.equal(striped, x < -disparity.budget_in_front_px || x > disparity.budget_behind_px, `${x} px`);
      assert.ok(Math.abs(left - low) + Math.abs(right - high) < .1 * (high - low), `${low} to ${high} px is drawn from ${left} to ${right}`);
      assert.ok(Math.abs(height - highest * Math.sqrt((counts[i - 1] ?? 0) / Math.max(...counts))) < .01 * highest, `${height} px for ${counts[i - 1]}`);
    });
    assert.ok(bars.some(({striped, height}) => striped && height > 0));
    assert.ok(plain.every((colour) => scales.disparity.colours.includes(colour)));
    assert.deepEqual(lines, [[-disparity.budget_in_front_px, `−${disparity.budget_percent} %`], [disparity.budget_behind_px, `+${disparity.budget_percent} %`]]);
    for (const chart of [histogram, compromise]) assert.ok(await coloured(page, chart, bad) > 50, chart);
    assert.deepEqual(await page.locator(compromise).evaluate((canvas) => Chart.getChart(canvas).scales.target.ticks.map(({value, label}) => [value, label])), [[0.03, "target 0.03"]]);
    assert.deepEqual(problems, []);
    await close();
  }
});

test("stereo: the eyes take turns on request only, slowly, and not for who wants little motion", async () => {
  const made = stereo("room", "room", ...room), calm = await openPage(made);
  assert.ok(!await calm.page.locator("#wiggle").isVisible());
  assert.deepEqual(calm.problems, []);
  await calm.close();
  const opened = await openPage(made, moving), {page} = opened;
  await page.evaluate(() => {
    window.turns = [];
    new MutationObserver(() => window.turns.push(performance.now())).observe(document.getElementById("shown"), {childList: true});
  });
  const turns = () => page.evaluate(() => window.turns.length);
  await page.waitForTimeout(700);
  assert.equal(await turns(), 0);
  await page.click("#wiggle");
  assert.equal(await page.getAttribute("#wiggle", "aria-pressed"), "true");
  await page.waitForFunction(() => window.turns.length >= 5);
  const times = await page.evaluate(() => window.turns);
  const flashes = 1000 * (times.length - 2) / (times.at(-1) - times[1]) / 2; // there and back, a second
  assert.ok(flashes < 3, `${flashes} flashes a second`);
  await page.click("#wiggle");
  const before = await turns();
  await page.waitForTimeout(700);
  assert.equal(await turns(), before);
  return opened;
});

test("stereo: names are text, every control and picture has a name, and nothing is wider than the screen", async () => {
  fs.mkdirSync(file("stereo"), {recursive: true});
  const scene = hostile.replaceAll("/", "").replace(".png", ".obj");
  fs.writeFileSync(file("stereo", scene), "o <b>x</b>\nv -9 -9 0\nv 9 -9 0\nv 0 9 1\nf 1 2 3\n");
  const made = stereo("hostile", scene, "--size", "64x48", "--eye", "0,0,4", "--look-at", "0,0,0", "--far", "20", "--window", "8", "--cull", "none");
  for (const width of [360, 400, 1280, 1920]) {
    for (const colorScheme of ["light", "dark"]) {
      const {page, problems, close} = await openPage(made, {viewport: {width, height: 900}, colorScheme});
      assert.equal(await page.textContent("h1"), scene);
      assert.deepEqual(await namelessControls(page), []);
      assert.equal(await page.locator("#shown img:not([alt]), #figures img:not([alt]), canvas:not([aria-label])").count(), 0);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${width} px`);
      assert.deepEqual(problems, []);
      await close();
    }
  }
});

test("stereo: a wide window is filled, and in a narrow one a shadow shows that there is more of a table", async () => {
  const made = stereo("room", "room", ...room);
  for (const each of [made, stereo("one-advice", "room", "--size", "320x180")]) {
    const {page, problems, close} = await openPage(each);
    const boxes = await page.locator("#start section").evaluateAll((all) => all.map((section) => section.getBoundingClientRect().toJSON()));
    const top = Math.min(...boxes.map((box) => box.top)), ends = [0, 640].map((from) => Math.max(...boxes.filter(({left}) => left >= from && left < from + 640).map(({bottom}) => bottom - top)));
    assert.ok(Math.min(...ends) > 0.65 * Math.max(...ends), `the columns are ${ends} px long`);
    assert.deepEqual(await shadowsOf(page, ".scroll"), [], "no table is too wide");
    assert.deepEqual(problems, []);
    await close();
  }
  const plain = await openPage(stereo("plain", "room", "--size", "320x180")); // without the curve beside the table
  const methods = await plain.page.locator("#methods").boundingBox(), table = await plain.page.locator("#methods-table").boundingBox();
  assert.ok(table.width > 0.9 * methods.width, `${table.width} of ${methods.width} px`);
  await plain.close();
  for (const colorScheme of ["light", "dark"]) {
    const {page, problems, close} = await openPage(made, {viewport: {width: 420, height: 800}, colorScheme}), shadows = await shadowsOf(page, ".scroll");
    assert.ok(shadows.length >= 1);
    for (const each of shadows) assert.deepEqual(each, [[false, true], [true, false]], colorScheme);
    assert.deepEqual(problems, []);
    await close();
  }
});

test("stereo: pages of nothing drawn, of one pixel, of eyes in one place and of eyes far apart open", async () => {
  for (const [name, ...words] of [["nothing", "teapot", "--size", "64x48", "--eye", "0,0,50", "--look-at", "0,0,100"], ["pixel", "room", "--size", "1x1"],
    ["one", "teapot", "--size", "64x48", "--eye-separation", "0"], ["far", "teapot", "--size", "64x48", "--eye-separation", "5"],
    ["parallel", "teapot", "--size", "64x48", "--ortho", "5"]]) {
    const {page, problems, close} = await openPage(stereo(name, ...words));
    assert.deepEqual(problems, [], name);
    assert.ok(await page.locator("#verdicts dt").count() >= 2 && await page.locator("#figures figure").count() >= 4, name);
    assert.ok(!/NaN|undefined|null/.test(await page.locator("main").innerText()), name);
    assert.ok(!/NaN|undefined/.test(await page.locator("#figures").innerHTML().then((html) => html.replaceAll(/data:[^"]*/g, ""))), name);
    await close();
  }
});

test("stereo: screenshots", async () => {
  fs.mkdirSync(file("screenshots"), {recursive: true});
  const made = stereo("forest", "forest");
  for (const [name, settings] of [["stereo-light", {}], ["stereo-dark", {colorScheme: "dark", viewport: {width: 1920, height: 1080}}]]) {
    const {page, problems, close} = await openPage(made, settings);
    await page.screenshot({path: file("screenshots", `${name}.png`), fullPage: true});
    assert.deepEqual(problems, []);
    await close();
  }
});
