// The page of `glassbox views voxels --html`: voxels turned, sliced and picked; a picked voxel has the verdict that the command found.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {clickOnShape, namelessControls, openPage} from "./browser.mjs";
import {file, test} from "./cases.mjs";

const program = path.resolve(process.argv[2]);

function voxels(name, ...words) {
  const cwd = file("voxels");
  fs.mkdirSync(cwd, {recursive: true});
  const run = (...all) => execFileSync(program, ["views", ...all], {stdio: "pipe", cwd});
  run("ring", "cube", "-o", "ring", "--views", "7", "--elevation", "40", "--size", "80x80");
  run("voxels", "ring", "--resolution", "28", "--leave-out", "2", "--html", `${name}.html`, ...words);
  return path.join(cwd, `${name}.html`);
}

async function open(made, options) {
  const opened = await openPage(made, options);
  await opened.page.waitForSelector("body[data-ready]");
  return opened;
}

const readout = (page) => page.textContent("#readout");

test("voxels: a click on the shape picks a coloured voxel, whose pictures agree with the verdict", async () => {
  const opened = await open(voxels("sweep")), {page} = opened;
  await clickOnShape(page);
  await page.waitForSelector("#projections figure");
  assert.match(await readout(page), /: coloured\. [2-9]\d* pictures see it: mean \([\d.]+, [\d.]+, [\d.]+\), sigma [\d.]+, below T = 18\./);
  assert.equal(await page.locator("#projections figure").count(), 6);
  return opened;
});

test("voxels: arrow keys go through a slice, and the verdict of each voxel is said", async () => {
  const opened = await open(voxels("sweep")), {page} = opened, verdicts = new Set();
  await page.locator("#layer").fill("10");
  await page.locator("#slice").focus();
  for (const key of Array(12).fill("ArrowRight")) {
    const last = await readout(page);
    await page.keyboard.press(key);
    await page.waitForFunction((text) => document.getElementById("readout").textContent !== text, last, {timeout: 5000});
    verdicts.add((await readout(page)).match(/layer 11: ([^.]+)\./)?.[1]);
  }
  assert.ok(verdicts.size >= 2 && !verdicts.has(undefined), [...verdicts].join());
  return opened;
});

test("voxels: what the page says of a voxel's numbers never contradicts the command's verdict", async () => {
  for (const [name, words, says] of [
    ["box", ["--footprint", "box"], /the test compares all pixels of the footprint \(box\)/],
    ["infinite", ["--threshold", "inf"], /below T = infinity/],
    ["edges", ["--threshold", "1", "--edges", "1"], /below T = 1/]]) {
    const opened = await open(voxels(name, ...words)), {page} = opened;
    const texts = [];
    for (const layer of ["0", "1", "6", "12"]) {
      await page.locator("#layer").fill(layer);
      await page.locator("#slice").focus();
      for (const key of Array(6).fill("ArrowRight")) {
        const last = await readout(page);
        await page.keyboard.press(key);
        await page.waitForFunction((text) => document.getElementById("readout").textContent !== text, last, {timeout: 5000});
        texts.push(await readout(page));
      }
    }
    assert.ok(texts.some((text) => says.test(text)), `${name}: ${texts[0]}`);
    // Coloured all the same: only an edge excuses a sigma that is not below T.
    for (const text of texts) {
      if (/: coloured\./.test(text) && /not below T/.test(text)) assert.match(text, /allowed where every picture has an edge of 1/);
    }
    assert.deepEqual(opened.problems, []);
    await opened.close();
  }
});

test("voxels: the picture that was left out changes places with the drawn one", async () => {
  const opened = await open(voxels("sweep")), {page} = opened;
  const before = await page.getAttribute("#held", "src");
  await page.click("#other");
  assert.notEqual(await page.getAttribute("#held", "src"), before);
  await page.click("#flicker");
  assert.equal(await page.getAttribute("#flicker", "aria-pressed"), "true");
  await page.waitForFunction((src) => document.getElementById("held").src === src, before);
  return opened;
});

test("voxels: every control has a name, and nothing is wider than the screen", async () => {
  for (const [name, words] of [["sweep", []], ["carved", ["--order", "carve"]]]) {
    const made = voxels(name, ...words);
    for (const width of [360, 800, 1920]) {
      for (const colorScheme of ["light", "dark"]) {
        const opened = await open(made, {viewport: {width, height: 900}, colorScheme}), {page} = opened;
        await clickOnShape(page);
        await page.waitForSelector("#projections figure");
        assert.deepEqual(await namelessControls(page), []);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${name} at ${width}`);
        assert.deepEqual(opened.problems, []);
        await opened.close();
      }
    }
  }
});
