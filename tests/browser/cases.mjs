// What the tests share: pictures, pages made of them by the program, and ways to look at them.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {canvasBox, colourAt, crosshair, hover, openPage, press, readout, settled} from "./browser.mjs";
import {encodePfm, encodePng, makePicture, pixelOf} from "./pictures.mjs";

export const program = path.resolve(process.argv[2]);
const directory = path.resolve(process.argv[3]);
export const file = (...names) => path.join(directory, ...names);
export const tests = [];
export const test = (name, body) => tests.push({name, body});

export function write(name, bytes) {
  fs.mkdirSync(path.dirname(file(name)), {recursive: true});
  fs.writeFileSync(file(name), bytes);
}

// Runs `glassbox diff` and gives the page's path. Pictures that differ make it end with 1, missing ones with 2.
export function makePage(name, reference, made, ...options) {
  try {
    execFileSync(program, ["diff", file(reference), file(made), "--html", file(name), ...options], {stdio: "pipe"});
  } catch (error) {
    if (![1, 2].includes(error.status)) throw error;
  }
  return file(name);
}

export function copyWith(picture, changes) {
  const copy = {...picture, samples: [...picture.samples]};
  for (const [x, y, samples] of changes) {
    copy.samples.splice((y * picture.width + x) * picture.channels, samples.length, ...samples);
  }
  return copy;
}

// A page of two pictures, opened.
export async function openPair(name, reference, made, settings = {}, options = []) {
  const [encode, extension] = reference.bits === 32 ? [encodePfm, "pfm"] : [encodePng, "png"];
  write(`${name}/reference.${extension}`, encode(reference));
  write(`${name}/test.${extension}`, encode(made));
  const page = makePage(`${name}/page.html`, `${name}/reference.${extension}`, `${name}/test.${extension}`, ...options);
  return openPage(page, settings);
}

// Points of the page spread over a part of the canvas, given in fractions of it: the same every time.
export async function pointsOver(page, left, top, right, bottom, count = 100) {
  const box = await canvasBox(page);
  return Array.from({length: count}, (_, i) => {
    const u = (i * 0.618034) % 1, v = (i + 0.5) / count;
    return [box.x + box.width * (left + (right - left) * u), box.y + box.height * (top + (bottom - top) * v)];
  });
}

// Hovers over points of a part of the canvas; what is drawn there has to be the picture's pixel that is read out.
export async function checkDrawn(page, picture, part, toColour = (samples) => samples) {
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

export const colours = makePicture(60, 40, 3, 8, (x, y) => [(x * 4) & 255, (y * 6) & 255, (x * 37 + y * 91) & 255]);
export const colourChanges = [[30, 20, [255, 0, 255]], [5, 3, [0, 0, 0]], [6, 3, [1, 1, 1]], [50, 35, [201, 211, 77]]];
export const changedColours = copyWith(colours, colourChanges);

export const light = makePicture(24, 16, 3, 32, (x, y) => [Math.fround(x / 8), Math.fround(y / 16), 0.5]);
export const unlikelyLight = copyWith(light, [
  [2, 2, [NaN, 1, 1]], [12, 2, [Infinity, 1, 1]], [20, 2, [1, -Infinity, 1]],
  [2, 10, [0.25, 0.625, 0.5 + 2 ** -24]], [12, 10, [-0, 1e-45, 3.4028235e38]]]);

export const hostile = `<img src=x onerror=alert(1)> "'&amp;${"long".repeat(40)}.png`;

export function writeFolder() {
  fs.rmSync(file("many"), {recursive: true, force: true});
  const pairs = {
    "slight.png": [colours, copyWith(colours, [[1, 1, [5, 7, 128]]])],
    "strong.png": [colours, changedColours],
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

export const signed = (value) => (value > 0 ? `+${value}` : value < 0 ? `−${-value}` : "0");

// Moves the crosshair to a pixel with the keys.
export async function goTo(page, x, y) {
  await page.locator("#view").focus();
  await press(page, "0", "ArrowRight");
  const at = await readout(page);
  for (const [distance, less, more] of [[x - at.x, "ArrowLeft", "ArrowRight"], [y - at.y, "ArrowUp", "ArrowDown"]]) {
    for (let i = 0; i < Math.abs(distance); i++) await page.keyboard.press(distance < 0 ? less : more);
  }
  await settled(page);
}
