// The page of `glassbox views geometry --draw`: a point under the mouse or the keys has its line in the other picture.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {namelessControls, openPage} from "./browser.mjs";
import {file, test} from "./cases.mjs";

const program = path.resolve(process.argv[2]);

function geometry(name, ...words) {
  fs.mkdirSync(file("geometry"), {recursive: true});
  execFileSync(program, ["views", "geometry", ...words, "--draw", `${name}.html`], {stdio: "pipe", cwd: file("geometry")});
  return file("geometry", `${name}.html`);
}
const room = ["--scene", "room", "--size", "320x240"];
const general = [...room, "--move", "0.5,0.1,0.2", "--turn", "-10,3,5", "--noise", "0.5", "--outliers", "0.3", "--count", "100"];

// What the page's script holds, and the ends of the line that is drawn in a picture.
const manifestOf = (page) => page.evaluate(() => JSON.parse(document.getElementById("manifest").textContent));
const lineIn = (page, side) => page.locator(`#${side} svg > g:last-child path.line`).evaluateAll((all) =>
  all.map((one) => one.getAttribute("d")).filter((d) => /^M[^L]+L[^L]+$/.test(d)).map((d) => d.slice(1).split("L").map((end) => end.split(",").map(Number))));
const readout = (page) => page.textContent("#readout");

// How far the ends are from the line of the point, px.
function offBy(f, side, [x, y], ends) {
  const p = [x, y, 1], entry = (i, k) => side === "left" ? f[i][k] : f[k][i];
  const [a, b, c] = [0, 1, 2].map((i) => [0, 1, 2].reduce((sum, k) => sum + entry(i, k) * p[k], 0));
  return Math.max(...ends.map(([u, v]) => Math.abs(a * u + b * v + c) / Math.hypot(a, b)));
}

test("geometry: the point under the mouse has its epipolar line in the other picture, both ways", async () => {
  const opened = await openPage(geometry("general", ...general)), {page} = opened, {F} = await manifestOf(page);
  for (const side of ["left", "right"]) {
    const other = side === "left" ? "right" : "left";
    const box = await page.locator(`#${side}`).boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    const [ends, ...more] = await lineIn(page, other);
    assert.equal(more.length, 0);
    assert.deepEqual(await lineIn(page, side), []);
    // The mouse stands on whole CSS pixels, up to half of one beside the middle.
    assert.ok(offBy(F, side, [160, 120], ends) < 1, JSON.stringify(ends));
    assert.match(await readout(page), new RegExp(`^${side === "left" ? "Left" : "Right"} \\(1(59|60)\\.`));
  }
  return opened;
});

test("geometry: keys move the point and go from match to match", async () => {
  const opened = await openPage(geometry("general", ...general)), {page} = opened, {F, matches} = await manifestOf(page);
  assert.match(await readout(page), /^Match 1 of 100/);
  await page.locator("#shown :checked").focus();
  for (const id of ["connected", "previous", "next", "left"]) {
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.id), id);
  }
  await page.keyboard.press("n");
  assert.match(await readout(page), /^Match 2 of 100: left/);
  await page.keyboard.press("p");
  await page.keyboard.press("p");
  assert.match(await readout(page), /^Match 100 of 100/);
  await page.keyboard.press("Tab");
  assert.match(await readout(page), /^Match 100 of 100: left/);
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("ArrowUp");
  const [x, y] = matches[99].right, expected = [Math.min(320, x + 10), Math.max(0, y - 1)];
  const [ends] = await lineIn(page, "left");
  assert.ok(ends && offBy(F, "right", expected, ends) < 1e-3, JSON.stringify([expected, ends]));
  await page.locator("#shown [value=inliers]").check({force: true});
  const inliers = matches.filter(({inlier}) => inlier).length;
  assert.equal(await page.locator("#left circle").count(), inliers);
  assert.equal(await page.locator("#left g:first-child path").count(), 0);
  await page.locator("#shown [value=others]").check({force: true});
  assert.equal(await page.locator("#right g:first-child path").count(), 100 - inliers);
  await page.click("#next");
  assert.match(await readout(page), /not an inlier/);
  return opened;
});

test("geometry: the residual's colour fills an inlier's dot", async () => {
  const opened = await openPage(geometry("general", ...general)), {page} = opened;
  const fills = await page.locator("#left circle").evaluateAll((all) => [...new Set(all.map((one) => getComputedStyle(one).fill))]);
  assert.ok(fills.length >= 4 && !fills.includes("none"), fills.join(" "));
  return opened;
});

// The page of matches that were found in the pair of `general`.
function foundPage() {
  geometry("general", ...general, "--pair-out", "left.png", "right.png");
  return geometry("found", "--pair", "left.png", "right.png", "--ratio", "0.9");
}
const linkEnds = (page, kind) => page.locator(`#links ${kind}`).evaluateAll((all) =>
  all.map((one) => one.getAttribute("d").slice(1).split("L").map((end) => end.split(",").map(Number))));

test("geometry: found matches are connected, inliers by whole lines and the others by dashed ones", async () => {
  const opened = await openPage(foundPage()), {page} = opened, {matches} = await manifestOf(page);
  const inliers = matches.filter(({inlier}) => inlier).length;
  assert.ok(inliers > 20 && inliers < matches.length, `${inliers} of ${matches.length}`);
  assert.equal(await page.locator("#links .link").count(), matches.length);
  assert.equal(await page.locator("#links .link.far").count(), matches.length - inliers);
  const dashes = (kind) => page.locator(`#links .link${kind}`).first().evaluate((one) => getComputedStyle(one).strokeDasharray);
  assert.equal(await dashes(":not(.far)"), "none");
  assert.notEqual(await dashes(".far"), "none");
  // The ends of the first line are on the first match's points in the two pictures.
  const ends = (await linkEnds(page, ".link"))[0], corner = await page.locator("#pair").boundingBox();
  for (const [i, side] of ["left", "right"].entries()) {
    const box = await page.locator(`#${side}`).boundingBox(), [x, y] = matches[0][side];
    assert.ok(Math.hypot(corner.x + ends[i][0] - box.x - x * box.width / 320, corner.y + ends[i][1] - box.y - y * box.height / 240) < 1, side);
  }
  await page.locator("#shown [value=others]").check({force: true});
  assert.equal(await page.locator("#links .link").count(), matches.length - inliers);
  await page.click("#next");
  assert.equal(await page.locator("#links .chosen.far").count(), 1);
  assert.match(await readout(page), /not an inlier\. Its ratio to the second nearest is 0\.\d\d\.$/);
  await page.locator("#connected").uncheck();
  assert.equal(await page.locator("#links path").count(), 0);
  return opened;
});

test("geometry: lines between the pictures follow them when the window changes", async () => {
  const opened = await openPage(foundPage()), {page} = opened, {matches} = await manifestOf(page);
  await page.setViewportSize({width: 420, height: 900});
  await page.waitForFunction(() => document.getElementById("left").getBoundingClientRect().right < 420);
  await page.waitForTimeout(100);
  const ends = (await linkEnds(page, ".link"))[0], corner = await page.locator("#pair").boundingBox();
  const box = await page.locator("#right").boundingBox(), [x, y] = matches[0].right;
  assert.ok(Math.hypot(corner.x + ends[1][0] - box.x - x * box.width / 320, corner.y + ends[1][1] - box.y - y * box.height / 240) < 1);
  return opened;
});

test("geometry: every control has a name, and nothing is wider than the screen", async () => {
  foundPage();
  for (const [name, words] of [["general", general], ["found", ["--pair", "left.png", "right.png"]], ["turned", [...room, "--turn", "8,0,0", "--noise", "0.5"]], ["tiny", ["--scene", "room", "--size", "8x8", "--eye-separation", "0.3"]]]) {
    const made = geometry(name, ...words);
    for (const width of [360, 800, 1920]) {
      for (const colorScheme of ["light", "dark"]) {
        const {page, problems, close} = await openPage(made, {viewport: {width, height: 900}, colorScheme});
        assert.deepEqual(await namelessControls(page), []);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${name}, ${width} px`);
        if (name === "turned") assert.match(await readout(page), /There is no line: from one point of view/);
        assert.deepEqual(problems, []);
        await close();
      }
    }
  }
});
