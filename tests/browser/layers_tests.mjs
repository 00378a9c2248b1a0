// The page of `glassbox views layers draw --html`: the layers from wherever they are looked at, as the program draws them.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {namelessControls, openPage, press} from "./browser.mjs";
import {file, test} from "./cases.mjs";

const program = path.resolve(process.argv[2]);
const folder = () => file("layers");
const run = (...words) => execFileSync(program, words, {stdio: "pipe", cwd: folder()});

function layersPage(name, scene, ...words) {
  fs.mkdirSync(folder(), {recursive: true});
  run("views", "layers", "build", scene, ...words, "-o", `${name}.ldi`);
  run("views", "layers", "draw", `${name}.ldi`, "--html", `${name}.html`);
  return path.join(folder(), `${name}.html`);
}

async function openLayers(...words) {
  const opened = await openPage(layersPage(...words));
  await opened.page.waitForFunction(() => document.body.dataset.ready);
  return opened;
}

// Red, green and blue of every pixel of a canvas.
const pixelsOf = (page, id) => page.evaluate((id) => {
  const canvas = document.getElementById(id);
  return [...canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data].filter((_, i) => i % 4 < 3);
}, id);

// What the program draws by the words that the page shows.
async function drawnByProgram(page) {
  const command = (await page.textContent("#command")).replace(/^glassbox/, `'${program}'`).replace("view.png", "view.ppm");
  execFileSync("sh", ["-c", command], {stdio: "pipe", cwd: folder()});
  const bytes = fs.readFileSync(path.join(folder(), "view.ppm"));
  const {width, height} = await page.evaluate(() => ({width: document.getElementById("picture").width, height: document.getElementById("picture").height}));
  return [...bytes.subarray(bytes.length - 3 * width * height)];
}
const shareThatDiffers = (a, b) => a.filter((value, i) => value !== b[i]).length / a.length;

const room = ["room", "room", "--size", "96x64", "--layers", "4"];

test("layers: from the camera the page shows the rasterizer's picture, byte for byte", async () => {
  const opened = await openLayers(...room), {page} = opened;
  run("render", "room", "--size", "96x64", "-o", "truth.ppm");
  const truth = fs.readFileSync(path.join(folder(), "truth.ppm"));
  assert.deepEqual(await pixelsOf(page, "picture"), [...truth.subarray(truth.length - 3 * 96 * 64)]);
  return opened;
});

test("layers: from elsewhere the page shows what the program draws by the words below it", async () => {
  const opened = await openLayers(...room), {page} = opened;
  await page.locator("#picture").focus();
  await press(page, "ArrowRight", "ArrowRight", "ArrowUp", "+");
  assert.match(await page.textContent("#readout"), /^Turned by 4\.0° and −2\.0°, 5 % nearer/);
  for (const splat of ["projected", "point", "three"]) {
    await page.locator(`#splats [value=${splat}]`).check({force: true});
    await press(page);
    // Seven digits of a camera, and doubles in place of floats: samples that fall between pixels.
    const off = shareThatDiffers(await pixelsOf(page, "picture"), await drawnByProgram(page));
    assert.ok(off < .02, `${splat}: ${off}`);
  }
  return opened;
});

test("layers: a lens that looks aside, and a file's name with a blank, are in the words below it", async () => {
  const opened = await openLayers("a side", "room", "--size", "120x100", "--frustum=-0.01,0.05,-0.02,0.03", "--near", "0.05");
  const {page} = opened, off = async () => shareThatDiffers(await pixelsOf(page, "picture"), await drawnByProgram(page));
  assert.match(await page.textContent("#command"), / 'a side\.ldi' .* --frustum=-0\.01,0\.05,-0\.02,0\.03 --near 0\.05/);
  assert.ok(await off() < .02);
  await page.locator("#picture").focus();
  await press(page, "ArrowLeft", "ArrowDown", "+");
  assert.ok(await off() < .02);
  return opened;
});

test("layers: a parallel view's words have its planes, and stored normals are those that the program draws by", async () => {
  const opened = await openLayers("parallel", "room", "--size", "96x64", "--ortho", "3", "--normals"), {page} = opened;
  await page.locator("#picture").focus();
  await press(page, "ArrowRight", "ArrowUp");
  assert.match(await page.textContent("#command"), / --ortho 3 --near=/);
  assert.ok(shareThatDiffers(await pixelsOf(page, "picture"), await drawnByProgram(page)) < .03);
  return opened;
});

test("layers: the mouse walks around, keys go home, show holes and go through the surfaces", async () => {
  const opened = await openLayers(...room), {page} = opened, picture = page.locator("#picture");
  const home = await pixelsOf(page, "picture");
  const box = await picture.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2, {steps: 4});
  await page.mouse.up();
  await press(page);
  assert.notDeepEqual(await pixelsOf(page, "picture"), home);
  await picture.focus();
  await press(page, "h");
  assert.equal(await page.getAttribute("#holes", "aria-pressed"), "true");
  const now = await pixelsOf(page, "picture");
  let magenta = 0;
  for (let i = 0; i < now.length; i += 3) magenta += now[i] === 255 && now[i + 1] === 0 && now[i + 2] === 255;
  const told = Number((await page.textContent("#readout")).match(/; ([\d.]+) % of the pixels/)[1]);
  assert.ok(magenta > 0 && Math.abs(100 * magenta / (96 * 64) - told) < .01, `${magenta}, ${told}`);
  await press(page, "h", "0");
  assert.deepEqual(await pixelsOf(page, "picture"), home);
  await press(page, "]");
  assert.match(await page.textContent("#layer-shown"), /^number 1 of 4/);
  await page.locator("#layers button").nth(1).click();
  await press(page);
  assert.equal(await page.inputValue("#layer"), "2");
  await picture.focus();
  await press(page, "[", "[");
  assert.deepEqual(await pixelsOf(page, "picture"), home);
  return opened;
});

test("layers: every control has a name, and nothing is wider than the screen", async () => {
  const pages = [layersPage(...room), layersPage("tiny", "cube", "--size", "8x8"), layersPage("deep", "forest", "--size", "480x270")];
  for (const made of pages) {
    for (const width of [360, 800, 1920]) {
      for (const colorScheme of ["light", "dark"]) {
        const {page, problems, close} = await openPage(made, {viewport: {width, height: 900}, colorScheme});
        await page.waitForFunction(() => document.body.dataset.ready);
        assert.deepEqual(await namelessControls(page), []);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${made}, ${width} px`);
        assert.deepEqual(problems, []);
        await close();
      }
    }
  }
});
