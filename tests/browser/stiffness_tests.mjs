// The page of `glassbox study stiffness`: every number with its place, what passes a pixel marked, and room for it on every screen.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {namelessControls, openPage} from "./browser.mjs";
import {file, test} from "./cases.mjs";

const program = path.resolve(process.argv[2]);

function stiffness(scene, name) {
  fs.mkdirSync(file("study"), {recursive: true});
  execFileSync(program, ["study", "stiffness", scene, "--size", "160x90", "--html", name], {stdio: "pipe", cwd: file("study")});
  return file("study", name);
}

test("stiffness: what passes a pixel is marked in the table, the bars and its own part", async () => {
  const opened = await openPage(stiffness("depth-ladder", "ladder.html")), {page} = opened;
  assert.deepEqual(await page.locator("#overview tr.passes td:first-child").allInnerTexts(), ["far over near"]);
  assert.equal(await page.locator(".bar.passes").count(), 1);
  assert.match(await page.locator("#far-over-near.passes").innerText(), /bound 8 in docs\/references\.md.*glassbox pixel depth-ladder --size 160x90 --at .*depth tests.*--near/s);
  const filled = ([bar, part]) => bar.locator(part).evaluate((element) => parseFloat(getComputedStyle(element).width) / element.parentNode.clientWidth);
  assert.ok(await filled([page.locator(".bar.passes"), "span"]) > .7);
  assert.ok(await filled([page.locator(".bar:not(.passes)").first(), "span"]) < .5);
  assert.ok(!/NaN|undefined|null/.test(await page.locator("main").innerText()));
  assert.deepEqual(await namelessControls(page), []);
  return opened;
});

test("stiffness: the page fits narrow and wide screens, light and dark", async () => {
  const made = stiffness("room", "room.html");
  for (const width of [360, 768, 1280, 1920]) {
    for (const colorScheme of ["light", "dark"]) {
      const {page, problems, close} = await openPage(made, {viewport: {width, height: 900}, colorScheme});
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${width} px`);
      assert.equal(await page.locator("#numbers section").count(), 6);
      assert.equal(await page.locator(".passes").count(), 0);
      assert.deepEqual(problems, []);
      await close();
    }
  }
});

test("stiffness: a link of the table goes to the number's part", async () => {
  const opened = await openPage(stiffness("room", "room.html")), {page} = opened;
  await page.locator("#overview a").last().click();
  assert.ok(await page.evaluate(() => document.querySelector(":target")?.id === "texture-coordinates"));
  return opened;
});
