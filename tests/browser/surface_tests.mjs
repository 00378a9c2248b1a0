// The page of `glassbox views polygons --html` and `views texture --html`: a surface turned and picked, its pictures and their weights.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {clickOnShape, namelessControls, openPage} from "./browser.mjs";
import {file, test} from "./cases.mjs";

const program = path.resolve(process.argv[2]);

let made = null;
function pages() {
  if (made) return made;
  const cwd = file("surface");
  fs.mkdirSync(cwd, {recursive: true});
  const run = (...all) => execFileSync(program, ["views", ...all], {stdio: "pipe", cwd});
  run("ring", "cube", "-o", "ring", "--views", "7", "--elevation", "10,50", "--size", "80x80");
  run("polygons", "ring", "--resolution", "24", "--leave-out", "2", "-o", "cube.glb", "--html", "polygons.html");
  run("texture", "cube.glb", "ring", "--leave-out", "2", "--html", "texture.html");
  made = {polygons: path.join(cwd, "polygons.html"), texture: path.join(cwd, "texture.html")};
  return made;
}

async function open(page, options) {
  const opened = await openPage(page, options);
  await opened.page.waitForSelector("body[data-ready]");
  return opened;
}
const pixels = (page) => page.evaluate(() => document.getElementById("shape").toDataURL());

test("surface: a click picks a polygon, and keys turn the surface", async () => {
  const opened = await open(pages().polygons), {page} = opened;
  const before = await pixels(page);
  await clickOnShape(page);
  assert.match(await page.textContent("#readout"), /^Polygon \d+: \d+ pictures? sees? it\. Corners \(/);
  await page.locator("#shape").focus();
  await page.keyboard.press("ArrowLeft");
  await page.waitForFunction((last) => document.getElementById("shape").toDataURL() !== last, before);
  assert.ok(await page.isHidden("#weights-part"));
  return opened;
});

test("surface: the weights of the pictures around the eye sum to one, however the surface is turned", async () => {
  const opened = await open(pages().texture), {page} = opened;
  await page.locator("#shape").focus();
  for (const key of ["ArrowLeft", "ArrowUp", "ArrowLeft", "ArrowLeft", "ArrowUp", "ArrowUp", "ArrowLeft"]) {
    const text = await page.textContent("#weights"), weights = [...text.matchAll(/view\d+\.png: ([01]\.\d\d)/g)].map((found) => +found[1]);
    assert.ok(weights.length >= 1 && weights.length <= 3, text);
    // Each is rounded to a hundredth.
    assert.ok(Math.abs(weights.reduce((all, each) => all + each) - 1) <= .005 * weights.length + 1e-9, text);
    await page.keyboard.press(key);
    await page.waitForFunction((last) => document.getElementById("weights").textContent !== last, text);
  }
  await clickOnShape(page);
  assert.match(await page.textContent("#readout"), /From here: view\d+\.png [01]\.\d\d/);
  return opened;
});

test("surface: the picture that was left out changes places with the drawn one", async () => {
  const opened = await open(pages().texture), {page} = opened;
  const before = await page.getAttribute("#held", "src");
  await page.click("#other");
  assert.notEqual(await page.getAttribute("#held", "src"), before);
  await page.click("#flicker");
  assert.equal(await page.getAttribute("#flicker", "aria-pressed"), "true");
  await page.waitForFunction((src) => document.getElementById("held").src === src, before);
  return opened;
});

test("surface: every control has a name, and nothing is wider than the screen", async () => {
  for (const made of Object.values(pages())) {
    for (const width of [360, 800, 1920]) {
      for (const colorScheme of ["light", "dark"]) {
        const opened = await open(made, {viewport: {width, height: 900}, colorScheme}), {page} = opened;
        assert.deepEqual(await namelessControls(page), []);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${made} at ${width}`);
        assert.deepEqual(opened.problems, []);
        await opened.close();
      }
    }
  }
});
