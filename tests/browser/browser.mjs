// A page in Chromium, watched: what it asks for, what goes wrong in it, and what it draws.
import {chromium} from "playwright-core";
import {decodePng} from "./pictures.mjs";

const running = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: process.getuid() === 0 ? ["--no-sandbox"] : [],
});
export const closeBrowser = () => running.close();

// Notes what the page draws into its canvas in the last frame: texts with their places, and where the crosshair is.
function watchCanvas() {
  const {fillText, fillRect, strokeRect} = CanvasRenderingContext2D.prototype;
  Object.assign(window, {texts: [], crosshairs: []});
  CanvasRenderingContext2D.prototype.fillText = function (text, x, y, ...rest) {
    if (this.canvas.id === "view") window.texts.push({text, x, y});
    return fillText.call(this, text, x, y, ...rest);
  };
  CanvasRenderingContext2D.prototype.strokeRect = function (x, y, width, height) {
    const line = 3 * Math.max(1, Math.round(devicePixelRatio)); // the outline's width, half of it on either side
    if (this.strokeStyle === "#3df5ff") window.crosshairs.push([x + width / 2, y + height / 2, width - line]);
    return strokeRect.call(this, x, y, width, height);
  };
  CanvasRenderingContext2D.prototype.fillRect = function (x, y, width, height) {
    const all = this.canvas.id === "view" && width === this.canvas.width && height === this.canvas.height;
    if (all) Object.assign(window, {texts: [], crosshairs: []});
    return fillRect.call(this, x, y, width, height);
  };
}

// Opens the file; settings are Playwright's, `script` runs before those of the page, `before` has the page before it is
// opened. `problems` has what no page may do.
export async function openPage(file, settings = {}, hash = "", script = null, before = null) {
  const context = await running.newContext({
    viewport: {width: 1280, height: 800}, reducedMotion: "reduce", colorScheme: "light", ...settings});
  const page = await context.newPage(), problems = [], address = "file://" + encodeURI(file);
  const beside = address.replace(/\.html$/, "-files/"); // where `diff --html-files` puts pictures
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("dialog", (dialog) => { problems.push("a dialog: " + dialog.message()); dialog.dismiss(); });
  page.on("request", (request) => {
    const url = request.url(), own = url.split("#")[0] === address || url.startsWith(beside);
    if (!own && !url.startsWith("data:")) problems.push("a request: " + url);
  });
  await page.addInitScript(watchCanvas);
  if (script) await page.addInitScript(script);
  if (before) await before(page);
  await page.goto(address + hash);
  await settled(page);
  return {page, problems, close: () => context.close()};
}

// Until the pictures are decoded and drawn.
export async function settled(page) {
  await page.waitForFunction(() => document.getElementById("message")?.textContent !== "Decoding …");
  await drawn(page);
}

// The page draws in the next frame.
const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));

export async function press(page, ...keys) {
  for (const key of keys) await page.keyboard.press(key);
  await settled(page);
}

export async function hover(page, x, y) {
  await page.mouse.move(x, y);
  await drawn(page);
}

// The readout: the pixel, and what stands under each heading.
export function readout(page) {
  return page.evaluate(() => {
    const text = (id) => document.getElementById(id).textContent.replaceAll("\u00a0", " ");
    const [x, y] = text("at").split(", ").map(Number);
    return {x, y, reference: text("reference-value"), test: text("test-value"), difference: text("difference-value")};
  });
}

// The box of the canvas on the page, in CSS pixels.
export const canvasBox = (page) => page.locator("#view").boundingBox();

// Red, green and blue of the canvas under a point of the page.
export function colourAt(page, x, y) {
  return page.evaluate(([px, py]) => {
    const canvas = document.getElementById("view"), box = canvas.getBoundingClientRect();
    const at = [(px - box.left) * devicePixelRatio, (py - box.top) * devicePixelRatio].map(Math.floor);
    return Array.from(canvas.getContext("2d").getImageData(...at, 1, 1).data.slice(0, 3));
  }, [x, y]);
}

// The centre of the pixel with the crosshair, as a point of the page, and the pixel's size on it: of the panes, the one
// nearest to a point.
export function crosshair(page, nearX = 0, nearY = 0) {
  return page.evaluate(([x, y]) => {
    const box = document.getElementById("view").getBoundingClientRect();
    return window.crosshairs.map((at) => at.map((value) => value / devicePixelRatio))
      .map(([cx, cy, size]) => [cx + box.left, cy + box.top, size])
      .sort((a, b) => Math.hypot(a[0] - x, a[1] - y) - Math.hypot(b[0] - x, b[1] - y))[0];
  }, [nearX, nearY]);
}

// What is printed in a pixel of the picture with this centre and size.
export function textsAround(page, x, y, size) {
  return page.evaluate(([px, py, reach]) => {
    const box = document.getElementById("view").getBoundingClientRect();
    const near = (text) => Math.abs(text.x / devicePixelRatio + box.left - px) < reach / 2 &&
      Math.abs(text.y / devicePixelRatio + box.top - py) < reach / 2;
    return window.texts.filter(near).map(({text}) => text.replaceAll("\u00a0", " "));
  }, [x, y, size]);
}

// Counts how often the page's script goes through its functions and loops, from before it is opened: the work that it does,
// which is the same on every machine. What it gives has the work since it was called last.
export async function countWork(page) {
  const session = await page.context().newCDPSession(page);
  await session.send("Profiler.enable");
  await session.send("Profiler.startPreciseCoverage", {callCount: true, detailed: true});
  return async () => {
    const {result} = await session.send("Profiler.takePreciseCoverage");
    const counts = result.filter(({url}) => url.startsWith("file:")).flatMap(({functions}) => functions)
      .flatMap(({ranges}) => ranges.map(({count}) => count));
    return counts.reduce((sum, count) => sum + count, 0);
  };
}

// Controls of which a screen reader would not know what to say.
export function namelessControls(page) {
  return page.evaluate(() => [...document.querySelectorAll("button, input, select, canvas[tabindex]")]
    .filter((control) => !(control.ariaLabel || control.textContent.trim() && control.tagName === "BUTTON" || control.labels?.[0]?.textContent.trim()))
    .map((control) => control.id || control.outerHTML.slice(0, 80)));
}

// How many pixels of a canvas have a colour near this one.
export const coloured = (page, canvas, colour) => page.locator(canvas).evaluate((node, [r, g, b]) => {
  const {data} = node.getContext("2d").getImageData(0, 0, node.width, node.height);
  let found = 0;
  for (let i = 0; i < data.length; i += 4) found += data[i + 3] > 200 && Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 24;
  return found;
}, colour);

// A click on what the canvas #shape shows: in the middle of its pixels that are not empty.
export async function clickOnShape(page) {
  const position = await page.evaluate(() => {
    const canvas = document.getElementById("shape"), {width, height} = canvas;
    const {data} = canvas.getContext("2d").getImageData(0, 0, width, height), filled = [];
    for (let at = 0; at < width * height; at++) if (data[4 * at + 3] !== 0) filled.push(at);
    const at = filled[filled.length >> 1], scale = canvas.clientWidth / width;
    return {x: (at % width + .5) * scale, y: (Math.floor(at / width) + .5) * scale};
  });
  await page.locator("#shape").click({position});
}

// For each element that scrolls sideways: whether a shadow lies over its left and over its right edge, at either end of the way. There is one
// where most rows of the picture do not have the colour of the panel.
export async function shadowsOf(page, selector) {
  const found = [];
  for (const each of await page.locator(selector).all()) {
    if (!await each.isVisible() || await each.evaluate((node) => node.scrollWidth <= node.clientWidth)) continue;
    const under = (await each.evaluate((node) => getComputedStyle(node).backgroundColor)).match(/\d+/g).map(Number), ends = [];
    for (const end of ["start", "end"]) {
      await each.evaluate((node, at) => { node.scrollLeft = at === "end" ? node.scrollWidth : 0; }, end);
      await drawn(page);
      const {width, height, channels, samples} = decodePng(await each.screenshot());
      const isPanel = (x, y) => [0, 1, 2].every((k) => Math.abs(samples[(y * width + x) * channels + k] - under[k]) < 24);
      const shadowAt = (x) => Array.from({length: height}, (_, y) => !isPanel(x, y)).filter(Boolean).length > height / 2;
      ends.push([shadowAt(1), shadowAt(width - 2)]);
    }
    found.push(ends);
  }
  return found;
}
