// The pages of `glassbox diff --html` in a browser.
//
//     node run.mjs PROGRAM DIRECTORY [WORDS]
//
// PROGRAM makes the pages from pictures made here; DIRECTORY takes pictures, pages and screenshots. With WORDS, only tests
// with these in their name. Ends with 0 if nothing failed.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {canvasBox, closeBrowser, colourAt, crosshair, hover, openPage, press, readout, settled, textsAround} from "./browser.mjs";
import {decodePng, encodePfm, encodePng, makePicture, pixelOf} from "./pictures.mjs";

const program = path.resolve(process.argv[2]), directory = path.resolve(process.argv[3]);
const file = (...names) => path.join(directory, ...names);
const tests = [];
const test = (name, body) => tests.push({name, body});

function write(name, bytes) {
  fs.mkdirSync(path.dirname(file(name)), {recursive: true});
  fs.writeFileSync(file(name), bytes);
}

// Runs `glassbox diff` and gives the page's path. Pictures that differ make it end with 1, missing ones with 2.
function makePage(name, reference, made, ...options) {
  try {
    execFileSync(program, ["diff", file(reference), file(made), "--html", file(name), ...options], {stdio: "pipe"});
  } catch (error) {
    if (![1, 2].includes(error.status)) throw error;
  }
  return file(name);
}

function copyWith(picture, changes) {
  const copy = {...picture, samples: [...picture.samples]};
  for (const [x, y, samples] of changes) copy.samples.splice((y * picture.width + x) * picture.channels, samples.length, ...samples);
  return copy;
}

// A page of two pictures, opened.
async function openPair(name, reference, made, settings = {}, options = []) {
  const [encode, extension] = reference.bits === 32 ? [encodePfm, "pfm"] : [encodePng, "png"];
  write(`${name}/reference.${extension}`, encode(reference));
  write(`${name}/test.${extension}`, encode(made));
  const page = makePage(`${name}/page.html`, `${name}/reference.${extension}`, `${name}/test.${extension}`, ...options);
  return openPage(page, settings);
}

// Points of the page spread over a part of the canvas, given in fractions of it: the same every time.
async function pointsOver(page, left, top, right, bottom, count = 60) {
  const box = await canvasBox(page);
  return Array.from({length: count}, (_, i) => {
    const u = (i * 0.618034) % 1, v = (i + 0.5) / count;
    return [box.x + box.width * (left + (right - left) * u), box.y + box.height * (top + (bottom - top) * v)];
  });
}

// Hovers over points of a part of the canvas; what is drawn there has to be the picture's pixel that is read out.
async function checkDrawn(page, picture, part, toColour = (samples) => samples) {
  let found = 0;
  for (const [x, y] of await pointsOver(page, ...part)) {
    await hover(page, x, y);
    const at = await readout(page);
    if (Number.isNaN(at.x)) continue;
    const [cx, cy, size] = await crosshair(page, x, y);
    if (Math.max(Math.abs(x - cx), Math.abs(y - cy)) > size / 2 - 1.2) continue; // on a line between pixels
    assert.deepEqual(await colourAt(page, x, y), toColour(pixelOf(picture, at.x, at.y)), `pixel ${at.x}, ${at.y}`);
    found++;
  }
  assert.ok(found >= 8, `only ${found} points are on the picture`);
}

const colours = makePicture(60, 40, 3, 8, (x, y) => [(x * 4) & 255, (y * 6) & 255, (x * 37 + y * 91) & 255]);
const colourChanges = [[30, 20, [255, 0, 255]], [5, 3, [0, 0, 0]], [6, 3, [1, 1, 1]], [50, 35, [201, 211, 77]]];
const changedColours = copyWith(colours, colourChanges);

test("the four ways to compare draw the pixels of the PNG files and of the heat map", async () => {
  const {page, problems, close} = await openPair("drawn", colours, changedColours, {}, ["-o", file("heat.png")]);
  const heat = decodePng(fs.readFileSync(file("heat.png"))), all = [0, 0, 1, 1];
  await page.uncheck("#boxes");
  await press(page, "h");
  await checkDrawn(page, heat, all);
  await press(page, "f");
  await checkDrawn(page, colours, all);
  await page.locator("#view").focus();
  await press(page, " ");
  await checkDrawn(page, changedColours, all);
  await press(page, "w");
  await checkDrawn(page, colours, [0, 0, 0.49, 1]);
  await checkDrawn(page, changedColours, [0.51, 0, 1, 1]);
  return {problems, close};
});

test("side by side shows reference, test and heat map at the same place", async () => {
  const tall = makePicture(20, 60, 3, 8, (x, y) => [x * 12, y * 4, (x * y) & 255]); // so the panes stand in a row
  const changed = copyWith(tall, [[10, 30, [9, 9, 9]], [11, 30, [250, 9, 9]]]);
  const {page, problems, close} = await openPair("side", tall, changed, {}, ["-o", file("side.png")]);
  const heat = decodePng(fs.readFileSync(file("side.png")));
  await page.uncheck("#boxes");
  for (const zoom of [0, 1, 2]) {
    for (let i = 0; i < zoom; i++) await press(page, "+");
    await checkDrawn(page, tall, [0, 0.1, 0.33, 1]);
    await checkDrawn(page, changed, [0.34, 0.1, 0.66, 1]);
    await checkDrawn(page, heat, [0.67, 0.1, 1, 1]);
  }
  return {problems, close};
});

test("screens with more than one device pixel a CSS pixel show the same", async () => {
  for (const deviceScaleFactor of [1.25, 2, 3]) {
    const {page, problems, close} = await openPair("dense", colours, changedColours, {deviceScaleFactor});
    await page.uncheck("#boxes");
    await press(page, "f");
    await checkDrawn(page, colours, [0, 0, 1, 1]);
    assert.deepEqual(problems, []);
    await close();
  }
});

test("the readout has the exact samples of 8 bits and their difference", async () => {
  const {page, problems, close} = await openPair("readout", colours, changedColours);
  for (const [x, y, samples] of colourChanges) {
    await goTo(page, x, y);
    const before = pixelOf(colours, x, y), at = await readout(page);
    assert.deepEqual([at.x, at.y], [x, y]);
    assert.equal(at.reference, `R ${before[0]}  G ${before[1]}  B ${before[2]}`);
    assert.equal(at.test, `R ${samples[0]}  G ${samples[1]}  B ${samples[2]}`);
    assert.equal(at.difference, ["R", "G", "B"].map((letter, i) => `${letter} ${signed(samples[i] - before[i])}`).join("  "));
  }
  return {problems, close};
});

test("16 bits are read out in full, where 8 would show no difference", async () => {
  const grey = makePicture(60, 40, 1, 16, (x, y) => [(x * 2111 + y * 7) & 65535]);
  const {page, problems, close} = await openPair("bits16", grey, copyWith(grey, [[7, 9, [pixelOf(grey, 7, 9)[0] + 1]]]));
  await page.uncheck("#boxes");
  await press(page, "n");
  const at = await readout(page), value = pixelOf(grey, 7, 9)[0];
  assert.deepEqual(at, {x: 7, y: 9, reference: `${value}`, test: `${value + 1}`, difference: "+1"});
  await press(page, "f", "0");
  await checkDrawn(page, grey, [0, 0, 1, 1], ([v]) => Array(3).fill(Math.round(v / 257)));
  return {problems, close};
});

const light = makePicture(24, 16, 3, 32, (x, y) => [Math.fround(x / 8), Math.fround(y / 16), 0.5]);
const unlikelyLight = copyWith(light, [[2, 2, [NaN, 1, 1]], [12, 2, [Infinity, 1, 1]], [20, 2, [1, -Infinity, 1]],
  [2, 10, [0.25, 0.625, 0.5 + 2 ** -24]], [12, 10, [-0, 1e-45, 3.4028235e38]]]);

test("floats are read out to the last bit, with NaN, infinities, subnormals and zeros of both signs", async () => {
  const {page, problems, close} = await openPair("floats", light, unlikelyLight);
  const expected = [
    [2, 2, "R NaN  G 1  B 1"], [12, 2, "R +∞  G 1  B 1"], [20, 2, "R 1  G −∞  B 1"],
    [2, 10, "R 0.25  G 0.625  B 0.50000006"], [12, 10, "R −0  G 1e−45  B 3.4028235e+38"],
  ];
  for (const [x, y, text] of expected) {
    await goTo(page, x, y);
    assert.equal((await readout(page)).test, text);
  }
  await goTo(page, 2, 10);
  assert.equal((await readout(page)).difference, "R 0  G 0  B +1 ulp");
  await goTo(page, 2, 2);
  assert.match((await readout(page)).difference, /^R ∞ /);
  return {problems, close};
});

test("floats are drawn from black to white over the range that is set, NaN and infinities in their colours", async () => {
  const grey = makePicture(60, 40, 1, 32, (x) => [Math.fround(x / 8)]);
  const made = copyWith(grey, [[2, 2, [NaN]], [12, 2, [Infinity]], [20, 2, [-Infinity]]]);
  const {page, problems, close} = await openPair("range", grey, made);
  await page.uncheck("#boxes");
  await press(page, "f");
  await page.click("#swap");
  const drawn = (low, high) => ([v]) => Number.isNaN(v) ? [255, 0, 255] : v === Infinity ? [255, 150, 0]
    : v === -Infinity ? [0, 140, 255] : Array(3).fill(Math.round(Math.min(Math.max((v - low) / (high - low), 0), 1) * 255));
  await checkDrawn(page, made, [0, 0, 1, 1], drawn(0, 59 / 8));
  for (const [x, colour] of [[2, [255, 0, 255]], [12, [255, 150, 0]], [20, [0, 140, 255]]]) {
    await goTo(page, x, 2);
    const [cx, cy] = await crosshair(page);
    assert.deepEqual(await colourAt(page, cx, cy), colour);
  }
  await press(page, "0");
  await page.fill("#low", "1");
  await page.fill("#high", "2");
  await page.locator("#high").blur();
  await checkDrawn(page, made, [0, 0, 1, 1], drawn(1, 2));
  await page.click("#range-auto");
  await checkDrawn(page, made, [0, 0, 1, 1], drawn(0, 59 / 8));
  return {problems, close};
});

test("what is transparent shows squares, or its colour when alpha is ignored", async () => {
  const clear = makePicture(60, 45, 4, 8, (x, y) => [x * 4, y * 5, 99, 0]);
  const {page, problems, close} = await openPair("alpha", clear, copyWith(clear, [[3, 3, [1, 2, 3, 0]]]));
  await page.uncheck("#boxes");
  await press(page, "f");
  for (const [x, y] of await pointsOver(page, 0.3, 0.2, 0.7, 0.8)) {
    const [grey, ...others] = await colourAt(page, x, y);
    assert.deepEqual(others, [grey, grey]);
  }
  await page.check("#opaque");
  await checkDrawn(page, clear, [0, 0, 1, 1], (samples) => samples.slice(0, 3));
  await goTo(page, 3, 3);
  assert.equal((await readout(page)).test, "R 1  G 2  B 3  A 0");
  return {problems, close};
});

test("at 64x the values of reference and test and the difference are printed in the pixels", async () => {
  const {page, problems, close} = await openPair("printed", colours, changedColours);
  const before = pixelOf(colours, 30, 20), lines = (samples) => ["R", "G", "B"].map((letter, i) => `${letter} ${samples[i]}`);
  for (const [keys, expected] of [[["f"], lines(before)], [["f", "Space"], lines([255, 0, 255])],
    [["h"], lines([255, 0, 255].map((value, i) => signed(value - before[i])))]]) {
    await goTo(page, 30, 20);
    await page.locator("#view").focus();
    await press(page, ...keys, "+", "+", "+", "+", "+", "+");
    assert.equal(await page.textContent("#zoom-level"), "64×");
    assert.deepEqual(await textsAround(page, ...(await crosshair(page))), expected);
    await press(page, "0", "s");
  }
  return {problems, close};
});

test("flicker swaps by key and by timer, and by itself only where motion is welcome", async () => {
  const shown = async (page) => (await page.evaluate(() => window.texts.map(({text}) => text)))
    .find((text) => ["Reference", "Test"].includes(text));
  const swapsWithin = (page, ms) => page.evaluate((time) => new Promise((done) => {
    let swaps = 0;
    const original = window.swapWatch = setInterval(() => {
      const title = window.texts.find(({text}) => ["Reference", "Test"].includes(text))?.text;
      if (window.lastTitle && title !== window.lastTitle) swaps++;
      window.lastTitle = title;
    }, 5);
    setTimeout(() => { clearInterval(original); done(swaps); }, time);
  }), ms);

  const calm = await openPair("flicker", colours, changedColours);
  await press(calm.page, "f");
  assert.equal(await swapsWithin(calm.page, 1200), 0);
  assert.equal(await shown(calm.page), "Reference");
  await calm.page.locator("#view").focus();
  await press(calm.page, " ");
  assert.equal(await shown(calm.page), "Test");
  await press(calm.page, "p");
  const slow = await swapsWithin(calm.page, 2000);
  assert.ok(slow >= 2 && slow <= 5, `${slow} swaps in two seconds`);
  await calm.page.locator("#speed").focus();
  await press(calm.page, "End");
  const fast = await swapsWithin(calm.page, 2000);
  assert.ok(fast >= 8 && fast <= 13, `${fast} swaps in two seconds`);
  await calm.page.click("#play");
  assert.equal(await swapsWithin(calm.page, 700), 0);
  await calm.close();

  const lively = await openPair("flicker", colours, changedColours, {reducedMotion: "no-preference"});
  await press(lively.page, "f");
  assert.ok(await swapsWithin(lively.page, 1500) >= 1);
  await press(lively.page, "s");
  assert.deepEqual(lively.problems, []);
  return {problems: calm.problems, close: lively.close};
});

test("the divider of the wipe moves by mouse, by its slider and by keys", async () => {
  const {page, problems, close} = await openPair("wipe", colours, changedColours);
  const divider = async () => Number(await page.inputValue("#divider"));
  await press(page, "w");
  const box = await canvasBox(page), middle = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width / 2, middle);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.25, middle, {steps: 4});
  await page.mouse.up();
  assert.ok(Math.abs(await divider() - 25) < 0.5, `the divider is at ${await divider()}`);
  await press(page, ".", ".");
  assert.ok(Math.abs(await divider() - 29) < 0.5);
  await page.locator("#divider").focus();
  await press(page, "Home");
  assert.equal(await divider(), 0);
  await page.uncheck("#boxes");
  await checkDrawn(page, changedColours, [0.02, 0, 1, 1]);
  return {problems, close};
});

test("regions are listed worst first; a click, Enter and N jump to them", async () => {
  const {page, problems, close} = await openPair("regions", colours, changedColours);
  const rows = await page.locator("#region-list button").allTextContents();
  assert.equal(rows.length, 3);
  const largest = rows.map((row) => parseInt(row));
  assert.deepEqual(largest, [...largest].sort((a, b) => b - a));
  const json = JSON.parse(await page.locator("#manifest").textContent()).pairs[0].differences.regions;
  await page.locator("#region-list button").nth(1).click();
  await settled(page);
  let at = await readout(page);
  assert.deepEqual({x: at.x, y: at.y}, json[1].worst);
  await page.locator("#region-list button").nth(2).focus();
  await press(page, "Enter");
  at = await readout(page);
  assert.deepEqual({x: at.x, y: at.y}, json[2].worst);
  await press(page, "n");
  at = await readout(page);
  assert.deepEqual({x: at.x, y: at.y}, json[0].worst, "after the last comes the first");
  await press(page, "N");
  at = await readout(page);
  assert.deepEqual({x: at.x, y: at.y}, json[2].worst);
  assert.equal(await page.locator("#region-list [aria-current]").count(), 1);
  return {problems, close};
});

test("keys move the crosshair, the wheel zooms where the mouse is, dragging moves all views", async () => {
  const {page, problems, close} = await openPair("keys", colours, changedColours);
  await goTo(page, 30, 20);
  await page.locator("#view").focus();
  await press(page, "ArrowRight", "ArrowDown", "Shift+ArrowLeft");
  let at = await readout(page);
  assert.deepEqual([at.x, at.y], [21, 21]);
  for (let i = 0; i < 30; i++) await press(page, "Shift+ArrowUp");
  at = await readout(page);
  assert.deepEqual([at.x, at.y], [21, 0]);

  await press(page, "f", "0");
  const box = await canvasBox(page), x = box.x + box.width * 0.4, y = box.y + box.height * 0.6;
  await hover(page, x, y);
  const before = await readout(page), level = await page.textContent("#zoom-level");
  for (const turn of [-100, -100, -100, 100]) {
    await page.mouse.wheel(0, turn);
    await settled(page);
    await hover(page, x, y);
    at = await readout(page);
    assert.deepEqual([at.x, at.y], [before.x, before.y]);
  }
  assert.notEqual(await page.textContent("#zoom-level"), level);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 40, {steps: 3});
  await page.mouse.up();
  await settled(page);
  at = await readout(page);
  assert.deepEqual([at.x, at.y], [before.x, before.y], "the picture follows the mouse");
  for (let i = 0; i < 20; i++) await press(page, "-");
  assert.equal(await page.textContent("#zoom-level"), "1×", "a small picture gets no smaller than it is");
  return {problems, close};
});

const hostile = `<img src=x onerror=alert(1)> "'&amp;${"long".repeat(40)}.png`;

function writeFolder() {
  fs.rmSync(file("many"), {recursive: true, force: true});
  const pairs = {"slight.png": [colours, copyWith(colours, [[1, 1, [5, 7, 128]]])], "strong.png": [colours, changedColours],
    [hostile]: [colours, copyWith(colours, [[0, 0, [1, 0, 0]]])],
    "sizes.png": [colours, makePicture(50, 40, 3, 8, (x, y) => [x, y, 0])],
    "light.pfm": [light, unlikelyLight]};
  for (const [name, [reference, made]] of Object.entries(pairs)) {
    const encode = reference.bits === 32 ? encodePfm : encodePng;
    write(`many/reference/${name}`, encode(reference));
    write(`many/test/${name}`, encode(made));
  }
  for (const name of ["same-1.png", "same-2.png"]) {
    for (const side of ["reference", "test"]) write(`many/${side}/${name}`, encodePng(colours));
  }
  write("many/reference/missing.png", encodePng(colours));
  write("many/test/new.png", encodePng(colours));
  write("many/reference/corrupt.png", encodePng(colours));
  write("many/test/corrupt.png", encodePng(colours).subarray(0, 80));
  return makePage("many/page.html", "many/reference", "many/test");
}

test("a page of many pairs lists the worst first, opens each, and keeps names as text", async () => {
  const {page, problems, close} = await openPage(writeFolder());
  const names = await page.locator(".pair-name").allTextContents();
  assert.deepEqual([...names].sort(), ["corrupt.png", hostile, "light.pfm", "missing.png", "new.png", "sizes.png", "slight.png", "strong.png"].sort());
  assert.equal(names[0], "sizes.png");
  assert.ok(names.indexOf("strong.png") < names.indexOf("slight.png"));
  assert.deepEqual(await page.locator("#same li").allTextContents(), ["same-1.png", "same-2.png"]);
  assert.match(await page.textContent("#summary"), /5 different.*2 same/);
  assert.equal(await page.evaluate(() => document.images.length), 0);

  for (let i = 0; i < names.length; i++) {
    await page.locator(`#pairs button >> nth=${i}`).click();
    await settled(page);
    assert.equal(await page.textContent("#name"), names[i]);
    assert.equal(await page.locator("#pairs [aria-current] .pair-name").textContent(), names[i]);
    assert.notEqual(await page.textContent("#decisive"), "", `${names[i]} says why`);
  }
  const heatWorks = async (name) => {
    await page.locator("#pairs button", {hasText: name}).click();
    await settled(page);
    return page.locator("input[value=heat]").isEnabled();
  };
  assert.equal(await heatWorks("sizes.png"), false);
  assert.equal(await heatWorks("strong.png"), true);
  for (const name of ["missing.png", "new.png", "corrupt.png"]) {
    assert.equal(await heatWorks(name), false);
    const box = await canvasBox(page);
    await hover(page, box.x + box.width / 2, box.y + box.height / 2);
    const at = await readout(page), [r, g, b] = pixelOf(colours, at.x, at.y);
    assert.equal(name === "new.png" ? at.test : at.reference, `R ${r}  G ${g}  B ${b}`, "the picture that is there is shown");
  }
  await page.locator("#pairs button >> nth=0").click();
  await press(page, "j", "j", "k");
  assert.equal(await page.textContent("#name"), names[1]);
  return {problems, close};
});

test("of a picture beyond 2^24 pixels the page shows what surrounds the differences", async () => {
  const [width, height] = [4200, 4100], header = Buffer.from(`P5\n${width} ${height}\n255\n`);
  const reference = Buffer.alloc(width * height, 77), made = Buffer.from(reference);
  made[4000 * width + 3000] = 80;
  made[10 * width + 20] = 200;
  write("large/reference.pgm", Buffer.concat([header, reference]));
  write("large/test.pgm", Buffer.concat([header, made]));
  const {page, problems, close} = await openPage(makePage("large/page.html", "large/reference.pgm", "large/test.pgm"));
  assert.ok(fs.statSync(file("large/page.html")).size < 200_000);
  assert.ok(await page.locator("#cropped").isVisible());
  const {difference, ...first} = await readout(page);
  assert.deepEqual(first, {x: 20, y: 10, reference: "77", test: "200"}, "it opens at the worst region");
  await press(page, "n");
  assert.deepEqual(await readout(page), {x: 3000, y: 4000, reference: "77", test: "80", difference: "+3"});
  await press(page, "f", "0");
  const box = await canvasBox(page);
  await hover(page, box.x + box.width / 2, box.y + box.height / 2);
  assert.equal((await readout(page)).difference, "not in this page");
  return {problems, close};
});

test("both colour schemes have the contrast that small text needs", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const {page, problems, close} = await openPair("scheme", colours, changedColours, {colorScheme});
    const ratios = await page.evaluate(() => {
      const probe = document.body.appendChild(document.createElement("i"));
      const luminance = (name) => {
        probe.style.color = `var(${name})`;
        const rgb = getComputedStyle(probe).color.match(/\d+/g).slice(0, 3).map((value) => value / 255);
        const [r, g, b] = rgb.map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const result = {};
      for (const text of ["--text", "--quiet", "--accent", "--bad", "--warn", "--good", "--other"]) {
        for (const ground of ["--page", "--panel"]) {
          const [a, b] = [luminance(text), luminance(ground)].sort((x, y) => y - x);
          result[`${text} on ${ground}`] = (a + 0.05) / (b + 0.05);
        }
      }
      return {result, page: luminance("--page")};
    });
    assert.ok(colorScheme === "dark" ? ratios.page < 0.05 : ratios.page > 0.8);
    for (const [pair, ratio] of Object.entries(ratios.result)) assert.ok(ratio >= 4.5, `${colorScheme}: ${pair}: ${ratio}`); // WCAG 2, 1.4.3
    assert.deepEqual(problems, []);
    await close();
  }
});

test("nothing is wider than a narrow window, and every control has a name", async () => {
  const {page, problems, close} = await openPage(writeFolder(), {viewport: {width: 360, height: 700}});
  for (const name of await page.locator(".pair-name").allTextContents()) {
    await page.locator("#pairs button", {hasText: name}).click();
    await settled(page);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), name);
  }
  const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, canvas[tabindex]")]
    .filter((control) => !(control.ariaLabel || control.textContent.trim() || control.labels?.[0]?.textContent.trim()))
    .map((control) => control.id));
  assert.deepEqual(nameless, []);
  return {problems, close};
});

test("screenshots", async () => {
  const many = writeFolder();
  fs.mkdirSync(file("screenshots"), {recursive: true});
  for (const [name, settings, pair, ...keys] of [
    ["many-light", {}, "strong.png"], ["many-dark", {colorScheme: "dark"}, "light.pfm", "n"],
    ["zoomed", {}, "strong.png", "n", "+"], ["wipe", {}, "strong.png", "w"], ["heat", {colorScheme: "dark"}, "strong.png", "h"],
    ["narrow", {viewport: {width: 400, height: 800}, deviceScaleFactor: 2}, "strong.png", "n"]]) {
    const {page, problems, close} = await openPage(many, settings);
    await page.locator("#pairs button", {hasText: pair}).click();
    await settled(page);
    await press(page, ...keys);
    await page.screenshot({path: file("screenshots", `${name}.png`), fullPage: name === "narrow"});
    assert.deepEqual(problems, []);
    await close();
  }
});

const signed = (value) => (value > 0 ? `+${value}` : value < 0 ? `−${-value}` : "0");

// Moves the crosshair to a pixel with the keys.
async function goTo(page, x, y) {
  await page.locator("#view").focus();
  await press(page, "0", "ArrowRight");
  const at = await readout(page);
  for (const [distance, less, more] of [[x - at.x, "ArrowLeft", "ArrowRight"], [y - at.y, "ArrowUp", "ArrowDown"]]) {
    for (let i = 0; i < Math.abs(distance); i++) await page.keyboard.press(distance < 0 ? less : more);
  }
  await settled(page);
}

let failed = 0;
const chosen = tests.filter(({name}) => name.includes(process.argv[4] ?? ""));
for (const {name, body} of chosen) {
  try {
    const opened = await body();
    if (opened) {
      assert.deepEqual(opened.problems, [], "nothing goes wrong, and nothing is asked of the network");
      await opened.close();
    }
    console.log(`passed: ${name}`);
  } catch (error) {
    failed++;
    console.log(`FAILED: ${name}\n${error.stack}`);
  }
}
await closeBrowser();
console.log(`${chosen.length - failed} passed, ${failed} failed`);
process.exitCode = failed || !chosen.length ? 1 : 0;
