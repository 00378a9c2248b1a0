// The 3-D view on the page of `glassbox inspect`: what it opens on is recognised, and the camera is seen.
import assert from "node:assert/strict";
import {openPage, press} from "./browser.mjs";
import {test} from "./cases.mjs";
import {inspect, small} from "./inspect_cases.mjs";

// The shares that each colour has of what is drawn in the view, in 32 steps of each channel, the largest first.
const sharesOf = (page) => page.evaluate(() => {
  const space = document.getElementById("space"), copy = document.createElement("canvas"), counts = new Map();
  Object.assign(copy, {width: space.width, height: space.height});
  const context = copy.getContext("2d");
  context.drawImage(space, 0, 0);
  const {data} = context.getImageData(0, 0, copy.width, copy.height), key = (at) => (data[at] >> 3) << 10 | (data[at + 1] >> 3) << 5 | data[at + 2] >> 3;
  for (let at = 0; at < data.length; at += 4) counts.set(key(at), (counts.get(key(at)) ?? 0) + 1);
  counts.delete(key(data.length - 4)); // what is behind everything
  const drawn = [...counts.values()].reduce((sum, count) => sum + count, 0);
  return [...counts.values()].map((count) => count / drawn).sort((a, b) => b - a);
});

test("inspect: NDC and screen space open on surfaces that are told apart, not on one slab", async () => {
  for (const [name, scene, ...words] of [["room", "room"], ["teapot", "teapot"], ["far", "room", "--near", "0.01"]]) {
    const made = inspect(`space-${name}`, scene, ...small, ...words);
    for (const [space, colorScheme] of [["ndc", "light"], ["screen", "dark"]]) {
      const {page, problems, close} = await openPage(made, {colorScheme}, `#space=${space}`), shares = await sharesOf(page);
      assert.ok(shares[0] < 0.45, `${name}, ${space}: ${shares[0]} of what is drawn has one colour`);
      assert.ok(shares.filter((share) => share > 0.04).length >= 4, `${name}, ${space}: ${shares.slice(0, 6)}`);
      assert.deepEqual(problems, []);
      await close();
    }
  }
});

// Remembers where what is written over the geometry.
function watchMarks() {
  const {clearRect, fillText} = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.clearRect = function (...box) {
    if (this.canvas.id === "space-marks") window.marks = [];
    return clearRect.apply(this, box);
  };
  CanvasRenderingContext2D.prototype.fillText = function (text, x, y, ...rest) {
    if (this.canvas.id === "space-marks") window.marks.push({text, x, y, width: this.canvas.width, height: this.canvas.height});
    return fillText.call(this, text, x, y, ...rest);
  };
}

test("inspect: the camera is seen in world and eye space, also inside of walls, from every side", async () => {
  for (const [name, ...words] of [["open"], ["closed", "--cull", "none"]]) {
    const made = inspect(`camera-${name}`, "room", ...small, ...words);
    for (const space of ["world", "eye"]) {
      const {page, problems, close} = await openPage(made, {}, `#space=${space}`, watchMarks);
      await page.locator("#space").focus();
      for (let i = 0; i < 4; i++) {
        const marks = await page.evaluate(() => window.marks), camera = marks.find(({text}) => text === "camera");
        assert.ok(camera && camera.x > 0 && camera.x < camera.width && camera.y > 0 && camera.y < camera.height, `${name}, ${space}: ${JSON.stringify(marks)}`);
        await press(page, ...Array(15).fill("ArrowRight"));
      }
      await page.selectOption("#space-name", "ndc");
      assert.ok(!(await page.evaluate(() => window.marks)).some(({text}) => text === "camera"), "in NDC it has no place");
      assert.deepEqual(problems, []);
      await close();
    }
  }
});
