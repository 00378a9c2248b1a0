// Pages of `glassbox inspect`, and what is read of them.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {settled} from "./browser.mjs";
import {file} from "./cases.mjs";
import {decodePng} from "./pictures.mjs";

const program = path.resolve(process.argv[2]);

// Runs the program; the name of a page is also that of its picture.
export function inspect(name, scene, ...options) {
  fs.mkdirSync(file("inspect"), {recursive: true});
  execFileSync(program, ["inspect", scene, ...options, "-o", file("inspect", `${name}.html`)], {stdio: "pipe"});
  return file("inspect", `${name}.html`);
}
export function render(name, scene, ...options) {
  execFileSync(program, ["render", scene, ...options, "-o", file("inspect", `${name}.png`)], {stdio: "pipe"});
  return decodePng(fs.readFileSync(file("inspect", `${name}.png`)));
}

export const now = (page) => page.textContent("#now");
export const note = (page) => page.textContent("#pixel-note");
// "Fragment 1,234: triangle 5, pixel (6, 7), written".
export async function chosen(page) {
  const [, fragment, triangle, x, y, fate] = (await now(page)).match(/Fragment ([\d,]+): triangle (\d+), pixel \((\d+), (\d+)\), (\w+)/) ?? [];
  return {fragment: Number(fragment?.replaceAll(",", "")), triangle: Number(triangle), x: Number(x), y: Number(y), fate};
}
export async function choosePixel(page, x, y) {
  for (const [id, value] of [["#pixel-x", x], ["#pixel-y", y]]) {
    await page.fill(id, String(value));
    await page.press(id, "Enter");
  }
  await settled(page);
}
export const small = ["--size", "320x180"];
