// The page of `glassbox views triangulate --html`: cameras, rays and points, turned and chosen.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {clickOnShape, namelessControls, openPage} from "./browser.mjs";
import {file, test} from "./cases.mjs";

const program = path.resolve(process.argv[2]);

function makePage(name, ...words) {
  fs.mkdirSync(file("triangulate"), {recursive: true});
  execFileSync(program, ["views", "triangulate", "--scene", "room", "--size", "160x120", "--count", "80", ...words, "--html", `${name}.html`], {stdio: "pipe", cwd: file("triangulate")});
  return file("triangulate", `${name}.html`);
}
const pixels = (page) => page.evaluate(() => document.getElementById("shape").toDataURL());
const readout = (page) => page.textContent("#readout");

test("triangulate: keys and buttons go from match to match, and a click chooses a point", async () => {
  const opened = await openPage(makePage("noisy", "--eye-separation", "0.3", "--noise", "0.5")), {page} = opened;
  assert.match(await readout(page), /^Match 1 of 80: in front of both cameras\. Left \(/);
  await page.click("#next");
  assert.match(await readout(page), /^Match 2 of 80/);
  await page.keyboard.press("p");
  await page.keyboard.press("p");
  assert.match(await readout(page), /^Match 80 of 80/);
  await clickOnShape(page);
  assert.match(await readout(page), /^Match \d+ of 80.* Point \(.*Half axes /);
  assert.deepEqual(await namelessControls(page), []);
  return opened;
});

test("triangulate: the picture changes when it is turned, and when all rays are shown", async () => {
  const opened = await openPage(makePage("outliers", "--move", "0.5,0.1,0.2", "--turn", "-10,3,5", "--noise", "0.5", "--outliers", "0.3")), {page} = opened;
  let before = await pixels(page);
  const changes = async () => {
    await page.waitForFunction((last) => document.getElementById("shape").toDataURL() !== last, before);
    before = await pixels(page);
  };
  await page.locator("#shape").focus();
  await page.keyboard.press("ArrowLeft");
  await changes();
  await page.locator("#shown [value=all]").check({force: true});
  await changes();
  assert.match(await page.textContent("#text"), /behind a camera: the rays are closest where the camera does not look/);
  return opened;
});
