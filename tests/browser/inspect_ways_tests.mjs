// The ways through the page of `glassbox inspect`: what it opens with, its stages, its axes, playing; and what they cost.
import assert from "node:assert/strict";
import fs from "node:fs";
import {countWork, openPage, press, settled} from "./browser.mjs";
import {file, test} from "./cases.mjs";
import {chosen, choosePixel, inspect, note, now, small} from "./inspect_cases.mjs";

// What the page has of each thing: the work of opening it is bounded by their sum.
async function itemsOf(page) {
  const {width, height, columns} = JSON.parse(await page.locator("#manifest").textContent());
  const counts = Object.fromEntries(columns.map(([name, , count]) => [name, count]));
  return width * height + counts["triangle.number"] + counts["position.x"] + counts["fragment.x"];
}

// Opens a page whose script's work is counted, and that of WebGL: the vertices that it is asked to draw.
async function openCounted(made, hash = "") {
  let work = null;
  const opened = await openPage(made, {}, hash, () => {
    window.vertices = 0;
    const {drawArrays, drawElements} = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.drawArrays = function (mode, first, count) {
      window.vertices += count;
      return drawArrays.call(this, mode, first, count);
    };
    WebGL2RenderingContext.prototype.drawElements = function (mode, count, ...rest) {
      window.vertices += count;
      return drawElements.call(this, mode, count, ...rest);
    };
  }, async (page) => { work = await countWork(page); });
  await opened.page.waitForSelector("body[data-ready]");
  return {...opened, work, vertices: () => opened.page.evaluate(() => window.vertices)};
}

test("inspect: a scene of 70,000 triangles at 1280x720 is below 10 MB, and opened by going through it some ten times", async () => {
  const made = inspect("large", "teapot:34"), bytes = fs.statSync(made).size, opened = await openCounted(made), {page} = opened;
  assert.ok(bytes < 10e6, `${bytes} bytes`);
  const work = await opened.work(), items = await itemsOf(page);
  const triangles = JSON.parse(await page.locator("#manifest").textContent()).stages.triangles;
  assert.ok(triangles >= 70000, `${triangles} triangles`);
  // Each column is unpacked byte by byte (some 40 a fragment, 2 loops each), then gone through a few times.
  assert.ok(work < 40 * items, `${work} steps of the script for ${items} pixels, triangles, positions and fragments`);
  await page.click("#view");
  assert.match(await note(page), /fragments?; shows \(/);
  return opened;
});

test("inspect: a step from fragment to fragment costs the same in a mesh of 200,000 triangles as in one of 1,000", async () => {
  const worst = {};
  for (const [name, scene] of [["small-mesh", "teapot:4"], ["large-mesh", "teapot:57"]]) {
    for (const space of ["world", "object", "ndc"]) {
      const {page, problems, close, work, vertices} = await openCounted(inspect(name, scene), `#space=${space}`);
      await page.locator("#view").focus();
      await press(page, "ArrowRight");
      await work();
      const drawn = await vertices();
      for (const key of ["ArrowRight", "ArrowRight", "ArrowLeft", "ArrowRight"]) {
        await press(page, key);
        worst[name] = Math.max(worst[name] ?? 0, await work());
      }
      assert.equal(await vertices(), drawn, `${scene}, ${space}: the geometry stands still and is not drawn again`);
      assert.deepEqual(problems, []);
      await close();
    }
  }
  // A few hundred numbers of the panel, a few dozen steps of the script each; the digits of some are longer than of others.
  for (const [name, work] of Object.entries(worst)) assert.ok(work < 40000, `${work} steps of the script, ${name}`);
});

test("inspect: neither keys nor the wheel scroll the page out of sight", async () => {
  const made = inspect("scroll", "room", "--size", "640x360", "--pixel", "320,230");
  const opened = await openPage(made, {viewport: {width: 1400, height: 1000}}), {page} = opened;
  const inSight = async (after) => assert.deepEqual(
    await page.evaluate(() => [document.documentElement.scrollHeight, scrollY, document.querySelector("header").getBoundingClientRect().top]),
    [1000, 0, 0], `the page is as tall as the window and stands still after ${after}`);
  await inSight("opening");
  await page.locator("details").evaluateAll((all) => all.forEach((each) => { each.open = true; }));
  for (const key of ["PageDown", "Space", "End", "Space"]) {
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press(key);
    await inSight(key);
  }
  for (const panel of ["nav", "aside", "footer", "main"]) {
    await page.hover(panel, {position: {x: 3, y: 3}});
    for (let i = 0; i < 8; i++) await page.mouse.wheel(0, 900);
    await settled(page);
    await inSight(`the wheel over ${panel}`);
  }
  return opened;
});

test("inspect: the page opens at a pixel that has something to tell", async () => {
  for (const [name, hash] of [["teapot", ""], ["forest", "#space=eye"], ["cube", ""]]) {
    const {page, problems, close} = await openPage(inspect(`opening-${name}`, name, ...small), {}, hash);
    assert.match(await note(page), /^[1-9]\d* fragments?; shows/, name);
    assert.match(await page.textContent("#verdict"), /written/, name);
    assert.match(await now(page), /^After ([\d,]+) of \1 fragments/, "and shows the finished picture");
    assert.deepEqual(problems, []);
    await close();
  }
  // Nothing is drawn: it says so and what to do.
  const opened = await openPage(inspect("opening-none", "cube", ...small, "--eye", "0,0,9", "--look-at", "0,0,20")), {page} = opened;
  assert.match(await page.textContent("#verdict"), /outside the near plane/);
  await choosePixel(page, 5, 5);
  assert.match(await page.textContent("#chain"), /shows the background\. Click on something that is drawn/);
  return opened;
});

test("inspect: a stage's name leads to its step, its space and its overlay, and its parts to the next of their kind", async () => {
  const made = inspect("room", "room", "--size", "640x360", "--pixel", "320,230"), opened = await openPage(made), {page} = opened;
  for (const [stage, step, space, overlay] of [["Assembly", "object", "object", "id"], ["Vertices", "world", "world", "none"],
    ["Clipping", "clip", "clip", "clipped"], ["Setup, culling", "facing", "screen", "culled"], ["Coverage", "fragment", "screen", "overdraw"],
    ["Depth test", "depth", "screen", "hidden"], ["Colour", "colour", "screen", "none"]]) {
    await page.locator(".stage", {hasText: stage}).focus();
    await press(page, "Enter");
    assert.deepEqual([await page.inputValue("#space-name"), await page.inputValue("#overlay")], [space, overlay], stage);
    assert.ok((await page.locator("#stages [aria-current=step]").innerText()).startsWith(stage));
    const [top, bottom, height] = await page.locator(`#step-${step}`).evaluate((section) => {
      const box = section.getBoundingClientRect(), panel = document.querySelector("aside").getBoundingClientRect();
      return [box.top - panel.top, panel.bottom - box.bottom, box.height];
    });
    assert.ok(top >= -1 && (bottom >= -1 || top < height), `${stage}: the step is in sight`);
    assert.equal(await page.evaluate(() => document.activeElement.textContent), stage, "and the focus stays");
  }
  const part = (label) => page.locator("button.part", {hasText: label}), verdict = () => page.textContent("#verdict");
  await part("culled").click();
  assert.match(await verdict(), /Culled/);
  const first = await page.inputValue("#triangle-number");
  await part("culled").click();
  assert.match(await verdict(), /Culled/);
  assert.notEqual(await page.inputValue("#triangle-number"), first, "the next one");
  await part("cut").first().click();
  assert.match(await verdict(), /Clipping made it/);
  assert.equal(await page.locator("#step-clipped[aria-current=step]").count(), 1);
  await part("hidden").click();
  assert.equal((await chosen(page)).fate, "hidden");
  const hash = new URL(page.url()).hash;
  await page.waitForFunction(() => location.hash.includes("step=depth"));
  const again = await openPage(made, {}, await page.evaluate(() => location.hash));
  assert.ok((await again.page.locator("#stages [aria-current=step]").innerText()).startsWith("Depth test"), hash);
  await again.close();
  return opened;
});

// Remembers what is written over the geometry: text, colour, and where its axis ends.
function watchMarks() {
  const {clearRect, fillText} = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.clearRect = function (...box) {
    if (this.canvas.id === "space-marks") window.marks = [];
    return clearRect.apply(this, box);
  };
  CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
    if (this.canvas.id === "space-marks") window.marks.push([text, this.fillStyle]);
    return fillText.call(this, text, ...rest);
  };
}

test("inspect: each space has its axes: the first red, the second green, the third blue, with where they end", async () => {
  const made = inspect("small", "teapot", ...small);
  for (const colorScheme of ["light", "dark"]) {
    const {page, problems, close} = await openPage(made, {colorScheme}, "", watchMarks);
    const expected = {object: "xyz", world: "xyz", eye: "xyz", clip: "xyw", ndc: "xyz", screen: "xyz"};
    for (const [space, names] of Object.entries(expected)) {
      await page.selectOption("#space-name", space);
      await settled(page);
      const axes = (await page.evaluate(() => window.marks)).filter(([text]) => text.includes(" = "));
      assert.deepEqual(axes.map(([text]) => text[0]).join(""), names, space);
      axes.forEach(([text, colour], k) => {
        const rgb = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
        assert.equal(rgb.indexOf(Math.max(...rgb)), k, `${space}: ${text} is ${colour}`);
        assert.ok(Number(text.slice(4)) > 0, text);
      });
      assert.equal((await page.evaluate(() => window.marks)).at(-1)[0], "A", "and the chosen corner its name");
    }
    assert.deepEqual(problems, []);
    await close();
  }
  // A scene far from the origin has them at itself.
  fs.writeFileSync(file("inspect", "far.obj"), "v 1000 0 0\nv 1001 0 0\nv 1000 1 0\nf 1 2 3\n");
  const far = await openPage(inspect("far", file("inspect", "far.obj"), ...small), {}, "#space=object", watchMarks);
  const [x] = (await far.page.evaluate(() => window.marks)).filter(([text]) => text.startsWith("x = "));
  assert.equal(x[0], "x = 1000.5");
  return far;
});

test("inspect: the 3-D view goes to the chosen triangle and back, shows what the run would show of a face, and sees into rooms", async () => {
  const opened = await openPage(inspect("room", "room", "--size", "640x360", "--pixel", "320,230"), {}, "", watchMarks), {page} = opened;
  const look = () => page.evaluate(() => document.getElementById("space").toDataURL());
  const all = await look();
  await page.click("#to-triangle");
  assert.notEqual(await look(), all);
  await page.click("#to-all");
  assert.equal(await look(), all);
  await page.locator("#space").focus();
  await press(page, "Enter");
  assert.notEqual(await look(), all);
  await press(page, "0");
  assert.equal(await look(), all);
  // From outside the room's walls turn their backs on the viewer; where nothing is culled they hide what is inside.
  const closed = await openPage(inspect("closed", "room", "--size", "640x360", "--pixel", "320,230", "--cull", "none"));
  assert.notEqual(await closed.page.evaluate(() => document.getElementById("space").toDataURL()), all);
  assert.deepEqual(closed.problems, []);
  await closed.close();
  return opened;
});

// Time that goes by frames, a tenth of a second each, however long they take.
function timeByFrames() {
  const {requestAnimationFrame} = window;
  let time = 0;
  performance.now = () => time;
  window.requestAnimationFrame = (act) => requestAnimationFrame.call(window, () => act((time += 100)));
}

test("inspect: the picture plays triangle by triangle, a triangle stage by stage, and a step stops it", async () => {
  const opened = await openPage(inspect("cube", "cube", ...small), {}, "", timeByFrames), {page} = opened;
  const playing = async () => /Stop/.test(await page.textContent("#play"));
  const ended = () => page.waitForFunction(() => /Play/.test(document.getElementById("play").textContent));
  await page.evaluate(() => {
    window.moments = [];
    const now = document.getElementById("now");
    new MutationObserver(() => window.moments.push(now.textContent)).observe(now, {childList: true});
  });
  await press(page, "p");
  await ended();
  const moments = await page.evaluate(() => window.moments), {stages} = JSON.parse(await page.locator("#manifest").textContent());
  assert.ok(moments[0].startsWith("After 0 of"), "from the end it begins again");
  const drawn = moments.slice(1).map((text) => text.match(/^After ([\d,]+) of .* triangle (\d+),/).slice(1));
  assert.equal(new Set(drawn.map(([, triangle]) => triangle)).size, drawn.length, "each moment is another triangle's");
  assert.equal(drawn.length, stages.set_up, "and none is left out");
  assert.equal(drawn.at(-1)[0], stages.covered.toLocaleString("en"), "to the end of the picture");

  // All in one go, so that nothing is played in between.
  const labels = await page.evaluate(() => ["p", "ArrowLeft", "p", "p"].map((key) => {
    document.body.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true}));
    return document.getElementById("play").textContent;
  }));
  assert.deepEqual(labels.map((label) => label.includes("Stop")), [true, false, true, false]);

  await page.selectOption("#play-what", "stages");
  await page.evaluate(() => {
    window.spaces = [];
    const stages = document.getElementById("stages"), name = document.getElementById("space-name");
    new MutationObserver(() => { if (stages.querySelector("[aria-current]")) window.spaces.push(name.value); })
      .observe(stages, {subtree: true, attributeFilter: ["aria-current"]});
  });
  await page.locator("#play").focus();
  await press(page, "Enter");
  assert.ok(await playing());
  await ended();
  assert.deepEqual([...new Set(await page.evaluate(() => window.spaces))], ["object", "world", "eye", "clip", "ndc", "screen"],
    "through all spaces");
  assert.ok((await page.locator("#stages [aria-current=step]").innerText()).startsWith("Colour"));
  return opened;
});
