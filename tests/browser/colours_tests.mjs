// The pages of `glassbox views klt --html` and `glassbox views glyphs find --html`: bands put together again, and regions that say why.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {namelessControls, openPage} from "./browser.mjs";
import {file, test} from "./cases.mjs";

const program = path.resolve(process.argv[2]);
const cwd = file("colours");
fs.mkdirSync(cwd, {recursive: true});
const run = (...all) => execFileSync(program, ["views", ...all], {stdio: "pipe", cwd});

function klt() {
  run("klt", "clouds:64", "--html", "klt.html");
  return path.join(cwd, "klt.html");
}
function glyphs() {
  run("glyphs", "sheet", "-o", "wall.glb");
  run("ring", "wall.glb", "-o", "shots", "--views", "1", "--distance", "2", "--fov", "40", "--size", "640x480", "--background", "0.5,0.5,0.5");
  run("glyphs", "find", "shots/view000.png", "--against", "shots/ring_par.txt", "--html", "glyphs.html");
  return path.join(cwd, "glyphs.html");
}
async function open(made, options) {
  const opened = await openPage(made, options);
  await opened.page.waitForSelector("body[data-ready]");
  return opened;
}

test("colours: as many components as there are give the band back, and none its mean", async () => {
  const opened = await open(klt()), {page} = opened;
  const rms = async () => Number((await page.textContent("#difference-says")).match(/RMS ([\d.,]+)/)[1].replaceAll(",", ""));
  await page.locator("#components button").nth(4).click();
  assert.equal(await page.textContent("#kept-at"), "5 of 5");
  // Both are kept as 16 bits of their range.
  assert.ok(await rms() < 0.1, String(await rms()));
  await page.locator("#kept").fill("0");
  assert.ok(await rms() > 100, String(await rms()));
  await page.selectOption("#band", "3");
  assert.match(await page.textContent("#again-says"), /its mean/);
  return opened;
});

test("colours: a glyph says what it is, and what is none why", async () => {
  const opened = await open(glyphs()), {page} = opened;
  await page.locator("#picture a.glyph").first().focus();
  await page.keyboard.press("Enter");
  assert.match(await page.textContent("#readout"), /^Glyph \d+: \w+, \w+, \w+, from the inside out\.$/);
  await page.locator("#table tbody tr", {hasText: "none"}).first().locator("button").click();
  assert.match(await page.textContent("#readout"), /^No glyph: /);
  return opened;
});

test("colours: every control has a name, and nothing is wider than the screen", async () => {
  for (const made of [klt(), glyphs()]) {
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
