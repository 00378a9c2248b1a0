// The page of `glassbox study scene`: its pictures are render's, byte for byte, and points, tables and views belong together.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {coloured, namelessControls, openPage} from "./browser.mjs";
import {file, test} from "./cases.mjs";

const program = path.resolve(process.argv[2]);
const run = (...words) => execFileSync(program, words, {stdio: "pipe", cwd: file("curve")});

const page_ = {path: ""};
function curvePage() {
  if (page_.path) return page_.path;
  fs.mkdirSync(file("curve"), {recursive: true});
  run("study", "scene", "checker", "--size", "96x54", "--html", "checker.html");
  return page_.path = file("curve", "checker.html");
}

// The colours of a PPM file, one pixel after the other.
function ppmPixels(name) {
  const bytes = fs.readFileSync(file("curve", name)), head = /^P6\s+(\d+)\s+(\d+)\s+255\s/.exec(bytes.subarray(0, 40).toString("latin1"));
  return {width: Number(head[1]), height: Number(head[2]), samples: [...bytes.subarray(head[0].length)]};
}

const shownPixels = (page) => page.locator("#picture").evaluate((canvas) => {
  const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  return {width: canvas.width, height: canvas.height, samples: [...data].filter((value, i) => i % 4 < 3)};
});

// The picture is unpacked while the page goes on.
const shows = (page, label) => page.waitForFunction((wanted) => document.getElementById("picture").ariaLabel === wanted, label);

const choose = (page, name) => page.locator("#table button", {hasText: new RegExp(`^${name}$`)}).click();

test("curve: every way shows the picture that its command draws", async () => {
  const opened = await openPage(curvePage()), {page} = opened;
  await page.locator("#shown input").nth(2).check({force: true});
  for (const name of ["as asked", "--filter nearest", "--samples 4", "--filter nearest --samples 16"]) {
    await choose(page, name);
    await shows(page, `Picture: ${name}`);
    assert.equal(await page.locator("#way-title").textContent(), name);
    const command = await page.locator("#way-command").textContent();
    run(...command.slice(command.indexOf("render")).split(" "), "-o", "drawn.ppm");
    assert.deepEqual(await shownPixels(page), ppmPixels("drawn.ppm"), command);
    assert.equal(await page.locator("#table tr.chosen button").textContent(), name);
  }
  assert.ok(!/NaN|undefined/.test(await page.locator("main").innerText()));
  assert.deepEqual(await namelessControls(page), []);
  return opened;
});

test("curve: the difference is eight times that of picture and reference, and FLIP is black where nothing is seen", async () => {
  const opened = await openPage(curvePage()), {page} = opened;
  await shows(page, "Picture: as asked");
  const picture = await shownPixels(page);
  const view = async (at, title) => {
    await page.locator("#views input").nth(at).check({force: true});
    await shows(page, `${title}: as asked`);
    return shownPixels(page);
  };
  const reference = await view(1, "Reference"), difference = await view(2, "Difference"), flip = await view(3, "FLIP");
  assert.deepEqual(difference.samples, picture.samples.map((value, i) => Math.min(255, 8 * Math.abs(value - reference.samples[i]))));
  assert.ok(difference.samples.some((value) => value > 0));
  const sky = (samples) => samples.slice(0, 3 * 96); // the first row, which both have alike
  assert.deepEqual(sky(difference.samples), sky(flip.samples));
  assert.ok(flip.samples.some((value) => value > 100));
  return opened;
});

test("curve: a click on a point of the chart chooses its way", async () => {
  const opened = await openPage(curvePage()), {page} = opened;
  const [x, y, name] = await page.locator("#chart canvas").evaluate((canvas) => {
    const chart = Chart.getChart(canvas), at = chart.data.datasets.findIndex(({label}) => label === "texture filter");
    const point = chart.getDatasetMeta(at).data[0], box = canvas.getBoundingClientRect();
    return [box.left + point.x, box.top + point.y, chart.data.datasets[at].data[0].point.name];
  });
  await page.mouse.click(x, y);
  await page.waitForFunction((wanted) => document.getElementById("way-title").textContent === wanted, name);
  await page.locator("#measures input").first().focus();
  await page.keyboard.press("ArrowRight");
  assert.match(await page.locator("#chart canvas").evaluate((canvas) => Chart.getChart(canvas).options.scales.y.title.text), /FLIP/);
  return opened;
});

test("curve: the front only goes down, and the bars of disturbed times are dashed", async () => {
  const opened = await openPage(curvePage()), {page} = opened;
  const {stairs, dashed, disturbed, points} = await page.locator("#chart canvas").evaluate((canvas) => {
    const {datasets} = Chart.getChart(canvas).data, bars = datasets.filter(({borderDash}) => borderDash), {points} = JSON.parse(document.getElementById("manifest").textContent);
    const barsOf = (dash) => bars.filter(({borderDash}) => borderDash.length > 0 === dash).reduce((sum, {data}) => sum + data.length / 3, 0);
    return {stairs: datasets.find(({stepped}) => stepped).data.map(({y}) => y), dashed: barsOf(true), points: barsOf(false) + barsOf(true) - points.length,
      disturbed: points.filter(({disturbed: some}) => some > 0).length};
  });
  assert.ok(stairs.length > 1 && stairs.every((y, i) => i === 0 || y < stairs[i - 1]), stairs.join(" "));
  assert.equal(dashed, disturbed);
  assert.equal(points, 0);
  return opened;
});

test("curve: the page fits narrow and wide screens, light and dark", async () => {
  fs.mkdirSync(file("screenshots"), {recursive: true});
  const made = curvePage();
  for (const width of [360, 1280, 1920]) {
    for (const colorScheme of ["light", "dark"]) {
      const {page, problems, close} = await openPage(made, {viewport: {width, height: 900}, colorScheme});
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${width} px`);
      assert.ok(await coloured(page, "#chart canvas", colorScheme === "dark" ? [0xe6, 0x9f, 0] : [0xd5, 0x5e, 0]) > 50, colorScheme);
      await page.screenshot({path: file("screenshots", `curve-${width}-${colorScheme}.png`), fullPage: true});
      assert.deepEqual(problems, []);
      await close();
    }
  }
});
