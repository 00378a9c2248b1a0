// What the pages draw and read out: the pixels of the files, and nothing else.
import assert from "node:assert/strict";
import fs from "node:fs";
import {colourAt, crosshair, press, readout, textsAround} from "./browser.mjs";
import {changedColours, checkDrawn, colourChanges, colours, copyWith, file, goTo, light, openPair, pointsOver, signed,
  test, unlikelyLight} from "./cases.mjs";
import {decodePng, makePicture, pixelOf} from "./pictures.mjs";

// Of another colour everywhere, so that no pixel of one picture can stand for one of the other.
const inverted = ({samples, ...rest}) => ({...rest, samples: samples.map((value) => 255 - value)});

test("the four ways to compare draw the pixels of the PNG files and of the heat map", async () => {
  const other = inverted(colours), all = [0, 0, 1, 1];
  const {page, problems, close} = await openPair("drawn", colours, other, {}, ["-o", file("heat.png")]);
  await page.uncheck("#boxes");
  await press(page, "h");
  await checkDrawn(page, decodePng(fs.readFileSync(file("heat.png"))), all);
  await press(page, "f");
  await checkDrawn(page, colours, all);
  await page.locator("#view").focus();
  await press(page, " ");
  await checkDrawn(page, other, all);
  await press(page, "w");
  await checkDrawn(page, colours, [0, 0, 0.49, 1]);
  await checkDrawn(page, other, [0.51, 0, 1, 1]);
  return {problems, close};
});

test("side by side shows reference, test and heat map at the same place", async () => {
  const tall = makePicture(20, 60, 3, 8, (x, y) => [x * 12, y * 4, (x * y) & 255]); // so the panes stand in a row
  const {page, problems, close} = await openPair("side", tall, inverted(tall), {}, ["-o", file("side.png")]);
  const heat = decodePng(fs.readFileSync(file("side.png")));
  await page.uncheck("#boxes");
  for (const zoom of [0, 1, 2]) {
    for (let i = 0; i < zoom; i++) await press(page, "+");
    await checkDrawn(page, tall, [0, 0.1, 0.33, 1]);
    await checkDrawn(page, inverted(tall), [0.34, 0.1, 0.66, 1]);
    await checkDrawn(page, heat, [0.67, 0.1, 1, 1]);
    await goTo(page, 3, 50);
    const places = await page.evaluate(() => ["Reference", "Test", "Heat map"].map((title, pane) => {
      const corner = window.texts.find(({text}) => text === title), [x, y] = window.crosshairs[pane];
      return [Math.round(x - corner.x), Math.round(y - corner.y)];
    }));
    assert.deepEqual(places[1], places[0]);
    assert.deepEqual(places[2], places[0]);
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
    const steps = samples.map((value, i) => signed(value - before[i]));
    assert.equal(at.reference, `R ${before[0]}  G ${before[1]}  B ${before[2]}`);
    assert.equal(at.test, `R ${samples[0]}  G ${samples[1]}  B ${samples[2]}`);
    assert.equal(at.difference, `R ${steps[0]}  G ${steps[1]}  B ${steps[2]}`);
  }
  return {problems, close};
});

test("16 bits are read out in full, where 8 would show no difference", async () => {
  const grey = makePicture(60, 40, 1, 16, (x, y) => [(x * 2111 + y * 7) & 65535]);
  const [value] = pixelOf(grey, 7, 9);
  const {page, problems, close} = await openPair("bits16", grey, copyWith(grey, [[7, 9, [value + 1]]]));
  await page.uncheck("#boxes");
  await press(page, "n");
  assert.deepEqual(await readout(page), {x: 7, y: 9, reference: `${value}`, test: `${value + 1}`, difference: "+1"});
  await press(page, "f", "0");
  await checkDrawn(page, grey, [0, 0, 1, 1], ([v]) => Array(3).fill(Math.round(v / 257)));
  return {problems, close};
});

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

test("the page and the program count the same steps between samples", async () => {
  const ends = [-3, -1e-45, -0, 0, 1e-45, 0.1, 2.5, 3e38];
  const grid = (value) => makePicture(5 * ends.length, 5 * ends.length, 1, 32, (x, y) =>
    x % 5 === 2 && y % 5 === 2 ? [Math.fround(value(Math.floor(x / 5), Math.floor(y / 5)))] : [1]);
  const {page, problems, close} = await openPair("steps", grid((x) => ends[x]), grid((x, y) => ends[y]));
  const {regions} = JSON.parse(await page.textContent("#manifest")).pairs[0].differences;
  assert.equal(regions.length, ends.length * (ends.length - 1));
  for (const region of regions) {
    await press(page, "n");
    const at = await readout(page), up = ends[Math.floor(at.y / 5)] > ends[Math.floor(at.x / 5)] ||
      Object.is(ends[Math.floor(at.x / 5)], -0) && ends[Math.floor(at.y / 5)] === 0;
    assert.deepEqual({x: at.x, y: at.y}, region.worst);
    assert.equal(at.difference, `${signed(up ? region.largest : -region.largest)} ulp`);
  }
  return {problems, close};
});

test("floats are drawn from black to white over the range set, NaN and infinities in their colours", async () => {
  const grey = makePicture(60, 40, 1, 32, (x) => [Math.fround(x / 8)]);
  const made = copyWith(grey, [[2, 2, [NaN]], [12, 2, [Infinity]], [20, 2, [-Infinity]]]);
  const {page, problems, close} = await openPair("range", grey, made);
  await page.uncheck("#boxes");
  await press(page, "f");
  await page.click("#swap");
  const drawn = (low, high) => ([value]) => {
    if (!Number.isFinite(value)) return Number.isNaN(value) ? [255, 0, 255] : value > 0 ? [255, 150, 0] : [0, 140, 255];
    return Array(3).fill(Math.round(Math.min(Math.max((value - low) / (high - low), 0), 1) * 255));
  };
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
  const before = pixelOf(colours, 30, 20), lines = ([r, g, b]) => [`R ${r}`, `G ${g}`, `B ${b}`];
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
