// The page of `glassbox views match --html`: the pixel under the mouse or the keys, its costs, the maps, and the points in space.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {namelessControls, openPage} from "./browser.mjs";
import {file, test} from "./cases.mjs";

const program = path.resolve(process.argv[2]);

function run(...words) {
  fs.mkdirSync(file("match"), {recursive: true});
  execFileSync(program, words, {stdio: "pipe", cwd: file("match")});
}
function match(name, ...words) {
  run("views", "match", ...words, "--html", `${name}.html`);
  return file("match", `${name}.html`);
}
const room = ["--scene", "room", "--size", "160x120", "--eye-separation", "0.2"];

async function open(made, settings = {}) {
  const opened = await openPage(made, settings);
  await opened.page.waitForSelector("#panes[data-ready]");
  return opened;
}
const readout = (page) => page.textContent("#readout");
const colourOf = (page, id, x, y) => page.evaluate(([id, x, y]) => {
  const canvas = document.getElementById(id);
  return [...canvas.getContext("2d").getImageData(Math.round(x * canvas.width), Math.round(y * canvas.height), 1, 1).data].slice(0, 3);
}, [id, x, y]);
const spaceBytes = (page) => page.evaluate(() => document.getElementById("space").toDataURL());

test("match: the pixel under the mouse is told, and moved by keys", async () => {
  const opened = await open(match("room", ...room)), {page} = opened;
  const box = await page.locator("#left").boundingBox();
  await page.mouse.move(box.x + box.width / 4, box.y + box.height / 2);
  assert.match(await readout(page), /^Pixel (39|40), (59|60): disparity −?\d+\.\d\d px, column \d+\.\d\d of the right picture\. True: −?\d+\.\d\d px, off by \d/);
  await page.locator("#left").focus();
  const [, x, y] = /^Pixel (\d+), (\d+)/.exec(await readout(page)).map(Number);
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("ArrowUp");
  assert.ok((await readout(page)).startsWith(`Pixel ${x + 10}, ${y - 1}:`), await readout(page));
  for (let i = 0; i < 20; i++) await page.keyboard.press("Shift+ArrowLeft");
  assert.ok((await readout(page)).startsWith(`Pixel 0, ${y - 1}:`));
  return opened;
});

test("match: the curve's least is the disparity that was found, and the mark is there", async () => {
  const opened = await open(match("plain", ...room, "--no-median", "--no-smooth", "--no-subpixel", "--no-fill")), {page} = opened;
  const shown = await page.evaluate(() => {
    const points = document.querySelector("#curve .sums").getAttribute("points").split(" ").map((each) => each.split(",").map(Number));
    const [x] = points.reduce((best, point) => (point[1] > best[1] ? point : best));
    return {x, found: Number(/^M([\d.]+)/.exec(document.querySelector("#curve .found").getAttribute("d"))[1]), text: document.querySelector("#curve .found-name").textContent};
  });
  assert.ok(Math.abs(shown.x - shown.found) < .1, JSON.stringify(shown));
  assert.match(shown.text, /^found −?\d+\.00$/);
  return opened;
});

test("match: each map has its colours and its legend", async () => {
  const opened = await open(match("room", ...room)), {page} = opened, seen = new Set();
  for (const map of ["disparity", "error", "doubt", "truth"]) {
    await page.locator(`#maps [value=${map}]`).check({force: true});
    seen.add(JSON.stringify(await colourOf(page, "map-canvas", .25, .5)));
    assert.ok((await page.textContent("#legend")).length > 5);
  }
  assert.ok(seen.size >= 3, [...seen].join(" "));
  return opened;
});

test("match: the points in space turn by keys, mouse and buttons", async () => {
  const opened = await open(match("room", ...room)), {page} = opened, straight = await spaceBytes(page);
  await page.locator("#space").focus();
  await page.keyboard.press("ArrowLeft");
  const turned = await spaceBytes(page);
  assert.notEqual(turned, straight);
  await page.keyboard.press("+");
  assert.notEqual(await spaceBytes(page), turned);
  await page.click("#straight");
  assert.equal(await spaceBytes(page), straight);
  const box = await page.locator("#space").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2, {steps: 3});
  await page.mouse.up();
  assert.notEqual(await spaceBytes(page), straight);
  return opened;
});

test("match: the cursor's ring moves over the points, which are not drawn again", async () => {
  const opened = await open(match("room", ...room)), {page} = opened, before = await spaceBytes(page);
  await page.evaluate(() => {
    globalThis.made = 0;
    globalThis.ImageData = class extends ImageData { constructor(...words) { super(...words); made++; } };
  });
  await page.locator("#left").focus();
  for (let i = 0; i < 3; i++) await page.keyboard.press("Shift+ArrowLeft");
  assert.notEqual(await spaceBytes(page), before);
  assert.equal(await page.evaluate(() => made), 0);
  for (let i = 0; i < 3; i++) await page.keyboard.press("Shift+ArrowRight");
  assert.equal(await spaceBytes(page), before);
  await page.locator("#space").focus();
  await page.keyboard.press("ArrowLeft");
  assert.equal(await page.evaluate(() => made), 1);
  return opened;
});

test("match: the table has the same columns as the report", async () => {
  const opened = await open(match("room", ...room)), {page} = opened;
  const cells = (selector) => page.locator(`#errors ${selector}`).allTextContents();
  assert.deepEqual((await cells("th")).slice(-3), ["RMS px", "of good px", "density %"]);
  const ofGood = await page.evaluate(() => JSON.parse(document.getElementById("manifest").textContent).errors.visible_and_textured.rms_good_px.toFixed(3));
  assert.equal((await cells("tr:has(td:text-is('visible and textured')) td")).at(-2), ofGood);
  return opened;
});

test("match: every control has a name, and nothing is wider than the screen, with and without a truth", async () => {
  run("render", "cube", "--size", "32x24", "-o", "cube.png");
  for (const [name, words] of [["room", room], ["files", ["cube.png", "cube.png", "--range", "0,9"]]]) {
    const made = match(name, ...words);
    for (const width of [360, 800, 1920]) {
      for (const colorScheme of ["light", "dark"]) {
        const {page, problems, close} = await open(made, {viewport: {width, height: 900}, colorScheme});
        assert.deepEqual(await namelessControls(page), []);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${name}, ${width} px`);
        if (name === "files") {
          assert.equal(await page.locator("#maps [value=truth]").isVisible(), false);
          assert.equal(await page.locator("#errors-section").isVisible(), false);
          assert.match(await page.textContent("#space-note"), /Without --calibration there is no depth/);
        }
        assert.deepEqual(problems, []);
        await close();
      }
    }
  }
});
