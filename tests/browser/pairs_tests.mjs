// A page of many pairs: the list and what it is asked for, the address, approval, files beside the page, and boxes.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import {namelessControls, openPage, press, readout, settled} from "./browser.mjs";
import {colours, copyWith, file, makePage, openPair, program, test, write, writeFolder} from "./cases.mjs";
import {encodePng, makePicture} from "./pictures.mjs";

const namesIn = (page) => page.locator(".pair-name").allTextContents();
const openName = (page) => page.textContent("#name");
const pairsOf = async (page) => JSON.parse(await page.locator("#manifest").textContent()).pairs;

// Pictures 1 to 12: each differs in as many pixels as its number, by 20 less its number. 13 is new, 14 and 15 are the same.
function writeNumbers(name, ...options) {
  return writeNumbersOn(colours, name, ...options);
}

function writeNumbersOn(ground, name, ...options) {
  fs.rmSync(file(name), {recursive: true, force: true});
  for (let i = 1; i <= 15; i++) {
    const changes = Array.from({length: i}, (_, k) => [k, 3 * k]);
    if (i !== 13) write(`${name}/reference/view ${i}.png`, encodePng(copyWith(ground, changes.map(([x, y]) => [x, y, [0, 0, 0]]))));
    const made = copyWith(ground, changes.map(([x, y]) => [x, y, [0, i < 13 ? 20 - i : 0, 0]]));
    write(`${name}/test/view ${i}.png`, encodePng(made));
  }
  return makePage(`${name}/page.html`, `${name}/reference`, `${name}/test`, ...options);
}

const numbered = (...numbers) => numbers.map((number) => `view ${number}.png`);
const upwards = Array.from({length: 15}, (_, i) => i + 1);

test("the list is sorted by name as people count, by size and by state", async () => {
  const {page, problems, close} = await openPage(writeNumbers("numbers"));
  const order = async (by) => { await page.selectOption("#sort", by); return namesIn(page); };
  assert.deepEqual(await order("name"), numbered(...upwards));
  // New pictures have no size to compare: they come before all sizes.
  assert.deepEqual(await order("pixels"), numbered(13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 14, 15));
  assert.deepEqual(await order("largest"), numbered(13, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 15));
  assert.deepEqual(await order("state"), numbered(...upwards));
  assert.deepEqual(await order("worst"), numbered(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
  return {problems, close};
});

test("the list shows the states and the names that are asked for, and keys go through what it shows", async () => {
  const {page, problems, close} = await openPage(writeNumbers("numbers"));
  assert.equal(await page.textContent("#list-count"), "15 pairs");
  await page.locator("#states label", {hasText: "Different"}).click();
  await page.locator("#states label", {hasText: "Same"}).click();
  assert.deepEqual(await namesIn(page), numbered(13));
  assert.equal(await page.textContent("#place"), "not in the list");
  await press(page, "j");
  assert.equal(await openName(page), "view 13.png");
  await page.locator("#states label", {hasText: "Different"}).click();
  await press(page, "/");
  await page.keyboard.type("W 1");
  assert.deepEqual(await namesIn(page), numbered(1, 10, 11, 12, 13));
  assert.equal(await page.textContent("#list-count"), "5 of 15 pairs");
  assert.equal(await openName(page), "view 13.png", "letters in the field are no commands");
  await press(page, "Enter", "k");
  assert.equal(await openName(page), "view 12.png");
  await press(page, "j", "j");
  assert.equal(await openName(page), "view 13.png", "after the last comes nothing");
  assert.ok(await page.locator("#next").isDisabled());
  assert.equal(await page.textContent("#place"), "5 of 5");
  await page.click("#previous");
  assert.equal(await openName(page), "view 12.png");
  return {problems, close};
});

test("the address has the pair and the list's state: it leads there, and Back goes back", async () => {
  const made = writeNumbers("numbers");
  const {page, problems, close} = await openPage(made);
  const hash = () => page.evaluate(() => location.hash);
  assert.equal(await hash(), "");
  await press(page, "j", "j");
  await page.selectOption("#sort", "name");
  await page.fill("#name-filter", "1");
  await page.locator("#states label", {hasText: "Same"}).click();
  await settled(page);
  const kept = await hash(), names = await namesIn(page);
  assert.deepEqual(names, numbered(1, 10, 11, 12, 13));

  const other = await openPage(made, {}, kept);
  assert.equal(await openName(other.page), "view 3.png");
  assert.deepEqual(await namesIn(other.page), names);
  assert.equal(await other.page.inputValue("#sort"), "name");
  assert.equal(await other.page.inputValue("#name-filter"), "1");
  assert.deepEqual(other.problems, []);
  await other.close();

  await page.goBack();
  await settled(page);
  assert.equal(await openName(page), "view 2.png");
  await page.goBack();
  await settled(page);
  assert.equal(await openName(page), "view 1.png");
  await page.goForward();
  await settled(page);
  assert.equal(await openName(page), "view 2.png");

  for (const nonsense of ["#pair=nothing", "#show=&sort=constructor", "#%ff%", "#show=same", "#name=no%20such%20name"]) {
    const strange = await openPage(made, {}, nonsense);
    assert.equal(await openName(strange.page), nonsense === "#show=same" ? "view 14.png" : "view 1.png", nonsense);
    assert.deepEqual(strange.problems, []);
    await strange.close();
  }
  return {problems, close};
});

test("a link leads to a pair whose name the address cannot have", async () => {
  fs.rmSync(file("bytes"), {recursive: true, force: true});
  // Names that are not UTF-8, and one that is: the page shows all as the same text.
  const named = (folder, start) => Buffer.concat([Buffer.from(`${file("bytes", folder)}/`), Buffer.from(start), Buffer.from(".png")]);
  for (const [start, number] of [[[0xfe], 3], [[0xff], 5], ["\ufffd", 1]]) {
    const changes = Array.from({length: number}, (_, x) => [7 * x, 7, [0, 0, 0]]);
    for (const folder of ["reference", "test"]) fs.mkdirSync(file("bytes", folder), {recursive: true});
    fs.writeFileSync(named("reference", start), encodePng(colours));
    fs.writeFileSync(named("test", start), encodePng(copyWith(colours, changes)));
  }
  const made = makePage("bytes/page.html", "bytes/reference", "bytes/test");
  const {page, problems, close} = await openPage(made);
  const pairs = await pairsOf(page);
  assert.equal(new Set(pairs.map(({name}) => name)).size, 1);
  const notes = [], links = [];
  for (let i = 0; i < 3; i++) {
    if (i) await press(page, "j");
    notes.push(await page.textContent("#regions-note"));
    links.push(await page.evaluate(() => location.hash));
  }
  assert.equal(new Set(notes).size, 3);
  for (let i = 0; i < 3; i++) {
    const other = await openPage(made, {}, links[i]);
    assert.equal(await other.page.textContent("#regions-note"), notes[i], links[i]);
    assert.deepEqual(other.problems, []);
    await other.close();
  }
  await page.goBack();
  await settled(page);
  assert.equal(await page.textContent("#regions-note"), notes[1]);
  for (const nonsense of ["#at=length", "#at=2", "#at=3", "#at=-1", "#at=", "#at=__proto__"]) {
    const strange = await openPage(made, {}, nonsense);
    assert.equal(await strange.page.textContent("#place"), "1 of 3", nonsense);
    assert.deepEqual(strange.problems, []);
    await strange.close();
  }
  return {problems, close};
});

async function saved(page) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#approved-save")]);
  assert.equal(download.suggestedFilename(), "approved.txt");
  return fs.readFileSync(await download.path(), "utf8");
}

test("pairs that differ or are new are chosen by box and by key, and their names are saved as a list", async () => {
  const {page, problems, close} = await openPage(writeNumbers("numbers"));
  assert.equal(await page.locator("#pairs input").count(), 13);
  assert.ok(await page.locator("#approved-part").isHidden());
  await press(page, "a");
  await page.locator("#pairs li", {hasText: "view 13.png"}).locator("input").check();
  await page.locator("#pairs li", {hasText: "view 10.png"}).locator("input").check();
  await press(page, "j");
  assert.equal(await page.isChecked("#approve"), false);
  await page.check("#approve");
  await press(page, "a");
  assert.equal(await saved(page), "# glassbox diff --approve-list\nview 1.png\nview 10.png\nview 13.png\n");
  const commands = await page.locator("#approved-commands code").allTextContents();
  const folders = `${file("numbers/reference")} ${file("numbers/test")}`;
  assert.deepEqual(commands, [`glassbox diff ${folders} --approve-list approved.txt`,
    "printf '%s\\n' '# glassbox diff --approve-list' 'view 1.png' 'view 10.png' 'view 13.png' | " +
    `glassbox diff ${folders} --approve-list -`]);
  await page.fill("#name-filter", "12");
  await page.click("#approve-all");
  assert.match(await page.textContent("#approved-count"), /^4 pairs/);
  await page.click("#approve-none");
  assert.ok(await page.locator("#approved-part").isHidden());
  await page.fill("#name-filter", "14");
  await press(page, "Enter", "j", "a");
  assert.equal(await openName(page), "view 14.png");
  assert.ok(await page.locator("#approved-part").isHidden(), "what is the same cannot be approved");
  return {problems, close};
});

test("the list of approved pairs has each name as it is, and no name that it cannot have", async () => {
  fs.rmSync(file("names"), {recursive: true, force: true});
  const plain = ["#a.png", " b.png", "it's $HOME.png", "-n.png", "\u001b[1m.png", "\u202egnp.png"];
  const impossible = ["two\nlines.png", "return\r.png"];
  for (const name of [...plain, ...impossible]) {
    write(`names/reference/${name}`, encodePng(colours));
    write(`names/test/${name}`, encodePng(copyWith(colours, [[3, 3, [0, 0, 0]]])));
  }
  const {page, problems, close} = await openPage(makePage("names/page.html", "names/reference", "names/test"));
  await page.click("#approve-all");
  const lines = (await saved(page)).split("\n");
  // A line that begins with # is a comment.
  assert.deepEqual(lines.slice(1, -1).sort(), ["./#a.png", ...plain.slice(1)].sort());
  assert.equal(await page.locator("#pairs input:disabled").count(), 2);
  assert.equal(await page.locator("#approved-commands code").count(), 1, "a command line cannot show all of these names");
  await page.fill("#name-filter", "two");
  await press(page, "Enter", "j");
  assert.match(await page.textContent("#why-not-listed"), /line break/);
  return {problems, close};
});

test("the command without a file has each name as it is, with the blanks at its end", async () => {
  fs.rmSync(file("blanks"), {recursive: true, force: true});
  for (const name of ["a.png", "last  "]) {
    write(`blanks/reference/${name}`, encodePng(colours));
    write(`blanks/test/${name}`, encodePng(copyWith(colours, [[3, 3, [0, 0, 0]]])));
  }
  const {page, problems, close} = await openPage(makePage("blanks/page.html", "blanks/reference", "blanks/test"));
  await page.click("#approve-all");
  assert.equal(await saved(page), "# glassbox diff --approve-list\na.png\nlast  \n");
  const commands = await page.locator("#approved-commands code").allTextContents();
  assert.ok(commands[1].startsWith("printf '%s\\n' '# glassbox diff --approve-list' a.png 'last  ' | "), commands[1]);
  return {problems, close};
});

// A picture that is too large to be whole in a page with files beside it.
const large = makePicture(200, 100, 3, 8, (x, y) => [x, y, (x * 37 + y * 91) & 255]);

test("pictures beside the page are loaded when they are looked at, sample by sample", async () => {
  const made = writeNumbersOn(large, "beside", "--html-files");
  const requests = [];
  const {page, problems, close} = await openPage(made, {}, "", null, (each) => each.on("request", (request) => requests.push(request.url())));
  const loaded = () => requests.filter((url) => url.endsWith(".js")).length;
  assert.equal(loaded(), 1, "only what is looked at");
  await press(page, "j");
  assert.equal(loaded(), 2);
  await press(page, "n");
  const at = await readout(page);
  assert.equal(at.test, "R 0  G 18  B 0");
  assert.equal(at.difference, "R 0  G +18  B 0");
  assert.ok(await page.locator("#cropped").isHidden());
  assert.deepEqual(await namelessControls(page), []);
  return {problems, close};
});

test("a page is loaded from files beside it whatever its name, and says what is missing", async () => {
  fs.rmSync(file("strange"), {recursive: true, force: true});
  write("strange/reference.png", encodePng(large));
  write("strange/test.png", encodePng(copyWith(large, [[3, 3, [90, 90, 90]]])));
  // Node cannot pass a name that is not UTF-8 to a program.
  const names = {"p\\377": "p?-files/0001.js", "100%%": "100%-files/0001.js", "a b#?": "a b#?-files/0001.js"};
  for (const [name, path] of Object.entries(names)) {
    const script = `page=$(printf '${name}.html'); "$0" diff reference.png test.png --html "$page" --html-files; cp "$page" copy.html`;
    execFileSync("sh", ["-c", script, program], {cwd: file("strange"), stdio: "pipe"});
    const whole = await openPage(file("strange/copy.html"));
    assert.equal(await whole.page.locator("#cropped").isHidden(), true, name);
    await press(whole.page, "n");
    assert.equal((await readout(whole.page)).test, "R 90  G 90  B 90", name);
    await whole.close();
    execFileSync("sh", ["-c", "rm -r *-files"], {cwd: file("strange")});
    const lost = await openPage(file("strange/copy.html"));
    assert.ok((await lost.page.textContent("#cropped")).includes(`There is no file ${path} beside this page.`), name);
    await lost.close();
  }
});

test("where the page has a part of a picture, it says so, along whichever side that is", async () => {
  for (const [width, height] of [[60, 400], [400, 60], [200, 200]]) {
    const name = `part ${width}`, ground = makePicture(width, height, 3, 8, (x, y) => [x & 255, y & 255, 9]);
    fs.rmSync(file(name), {recursive: true, force: true});
    write(`${name}/reference.png`, encodePng(ground));
    write(`${name}/test.png`, encodePng(copyWith(ground, [[width >> 1, height >> 1, [0, 0, 0]]])));
    const made = makePage(`${name}/page.html`, `${name}/reference.png`, `${name}/test.png`, "--html-files");
    fs.rmSync(file(name, "page-files"), {recursive: true});
    const {page, close} = await openPage(made);
    assert.match(await page.textContent("#cropped"), /^Here is what surrounds the worst differences\. There is no file/, name);
    const {x, y} = await readout(page);
    assert.deepEqual([x, y], [width >> 1, height >> 1], "it opens at the worst region");
    await close();
  }
});

test("without its files the page shows the crops that it has, and says what is missing", async () => {
  const ground = makePicture(300, 260, 3, 8, (x, y) => [x & 255, y & 255, 9]);
  fs.rmSync(file("lost"), {recursive: true, force: true});
  for (const name of ["a.png", "b.png"]) {
    write(`lost/reference/${name}`, encodePng(ground));
    write(`lost/test/${name}`, encodePng(copyWith(ground, [[200, 100, [0, 0, 0]]])));
  }
  const made = makePage("lost/page.html", "lost/reference", "lost/test", "--html-files");
  fs.copyFileSync(file("lost/page-files/0001.js"), file("lost/page-files/0002.js"));
  fs.rmSync(file("lost/page-files/0001.js"));
  const {page, problems, close} = await openPage(made);
  assert.match(await page.textContent("#cropped"), /no file page-files\/0001\.js/);
  assert.deepEqual(await readout(page), {x: 200, y: 100, reference: "R 200  G 100  B 9", test: "R 0  G 0  B 0",
    difference: "R −200  G −100  B −9"});
  await press(page, "j");
  const sameBytes = (await pairsOf(page)).map(({beside}) => beside.stamp);
  assert.equal(sameBytes[0], sameBytes[1], "the two pairs have the same pictures");
  fs.writeFileSync(file("lost/page-files/0002.js"), fs.readFileSync(file("lost/page-files/0002.js"), "utf8").replace(/"[0-9a-f]{8}"/, '"01234567"'));
  await press(page, "k", "j");
  assert.match(await page.textContent("#cropped"), /belongs to another page/);
  // The browser itself reports the file that is not there.
  assert.deepEqual(problems.filter((problem) => !problem.includes("ERR_FILE_NOT_FOUND")), []);
  return {problems: [], close};
});

test("a new picture whose file is not there has its thumbnail, and says what is missing", async () => {
  fs.rmSync(file("unseen"), {recursive: true, force: true});
  fs.mkdirSync(file("unseen/reference"), {recursive: true});
  write("unseen/test/new.png", encodePng(makePicture(300, 260, 3, 8, (x, y) => [x & 255, y & 255, 9])));
  const made = makePage("unseen/page.html", "unseen/reference", "unseen/test", "--html-files");
  fs.rmSync(file("unseen/page-files"), {recursive: true});
  const {page, problems, close} = await openPage(made);
  assert.match(await page.textContent("#message"), /no file page-files\/0001\.js/);
  assert.ok(await page.locator("#message img").isVisible());
  assert.ok(await page.locator("#readout").isHidden());
  assert.equal(problems.length, 1, "the browser itself reports the file that is not there");
  return {problems: [], close};
});

// What the page says of its boxes: how many there are, and how far apart pixels may be that share one.
async function boxes(page) {
  const text = await page.textContent("#boxes-text");
  return {number: Number(text.replaceAll(",", "").match(/^\d+/)[0]), reach: Number(text.match(/up to (\d+) px/)?.[1] ?? 1)};
}

// Notes the white boxes that the page draws in the last frame, in device pixels.
function watchBoxes() {
  window.drawnBoxes = [];
  const {fillRect, strokeRect} = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.strokeRect = function (x, y, width, height) {
    if (this.strokeStyle === "#ffffff") window.drawnBoxes.push([x + 1.5, y + 1.5, width - 3, height - 3]);
    return strokeRect.call(this, x, y, width, height);
  };
  CanvasRenderingContext2D.prototype.fillRect = function (x, y, width, height) {
    if (width === this.canvas.width && height === this.canvas.height) window.drawnBoxes = [];
    return fillRect.call(this, x, y, width, height);
  };
}

// The boxes on the heat map in px of the picture, where a pixel is 8 of the screen: there no box is drawn larger than it is.
async function boxesInPicture(page) {
  await press(page, "h", "0");
  while (await page.textContent("#zoom-level") !== "8×") await press(page, "-");
  await page.locator("#view").focus();
  await press(page, "ArrowRight");
  const {x, y} = await readout(page), [[cx, cy, cell]] = await page.evaluate(() => window.crosshairs);
  const drawn = await page.evaluate(() => window.drawnBoxes);
  return drawn.map(([left, top, width, height]) => [left - (cx - (x + .5) * cell), top - (cy - (y + .5) * cell), width, height]
    .map((value) => value / cell));
}

test("boxes share no pixel, and pixels within the reach have one box, which is no larger than they need", async () => {
  const ground = makePicture(60, 40, 1, 8, () => [90]);
  let random = 5;
  const below = (end) => (random = (random * 48271) % 2147483647) % end;
  for (const number of [1, 20, 60, 200]) {
    const pixels = Array.from({length: number}, () => [below(60), below(40)]);
    write("reach/reference.png", encodePng(ground));
    write("reach/test.png", encodePng(copyWith(ground, pixels.map(([x, y]) => [x, y, [120]]))));
    const made = makePage("reach/page.html", "reach/reference.png", "reach/test.png");
    const {page, problems, close} = await openPage(made, {}, "", watchBoxes);
    const found = await boxesInPicture(page), says = await boxes(page);
    assert.equal(says.number, found.length);
    const holds = ([left, top, width, height], [x, y]) => x >= left && y >= top && x < left + width && y < top + height;
    const boxOf = (pixel) => {
      const around = found.filter((box) => holds(box, pixel));
      assert.equal(around.length, 1, `${number} pixels: ${pixel} is in one box`);
      return around[0];
    };
    for (const a of pixels) {
      for (const b of pixels) {
        const apart = Math.max(Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1]));
        if (apart <= says.reach) assert.equal(boxOf(a), boxOf(b), `${a} and ${b} share a box`);
      }
    }
    for (const [left, top, width, height] of found) {
      const inside = pixels.filter((pixel) => holds([left, top, width, height], pixel)), [xs, ys] = [0, 1].map((k) => inside.map((pixel) => pixel[k]));
      assert.deepEqual([Math.min(...xs), Math.min(...ys), Math.max(...xs) + 1, Math.max(...ys) + 1], [left, top, left + width, top + height]);
    }
    assert.deepEqual(problems, []);
    await close();
  }
});

test("thousands of scattered pixels have few boxes, and at the largest zoom each region has its own", async () => {
  const ground = makePicture(400, 300, 1, 8, () => [90]);
  const scattered = Array.from({length: 3000}, (_, i) => [(i * 7919) % 400, (i * 104729 + (i >> 3)) % 300, [120]]);
  const {page, problems, close} = await openPair("scattered", ground, copyWith(ground, scattered));
  const fitted = await boxes(page);
  assert.ok(fitted.reach > 1 && fitted.number < 20, JSON.stringify(fitted));
  for (let i = 0; i < 20; i++) await press(page, "+");
  assert.equal((await boxes(page)).reach, 1);
  const regions = (await pairsOf(page))[0].differences.region_count;
  assert.equal((await boxes(page)).number, regions, "at the largest zoom each region has its box");
  await page.uncheck("#boxes");
  await settled(page);
  assert.equal(await page.textContent("#boxes-text"), "");
  return {problems, close};
});

test("a picture has no more boxes than the page can draw, and says how far apart pixels are that share one", async () => {
  const ground = makePicture(1600, 1600, 1, 8, () => [90]);
  const isolated = Array.from({length: 320 * 320}, (_, i) => [5 * (i % 320), 5 * Math.floor(i / 320), [120]]);
  const {page, problems, close} = await openPair("isolated", ground, copyWith(ground, isolated));
  for (let i = 0; i < 20; i++) await press(page, "+");
  // With squares of 4 px, 4 x 4 of these pixels lie in squares that touch.
  assert.deepEqual(await boxes(page), {number: 80 * 80, reach: 4});
  assert.equal((await pairsOf(page))[0].differences.region_count, 320 * 320);
  return {problems, close};
});

test("two pixels have one box where they are near on the screen, and two where they are far", async () => {
  const ground = makePicture(1000, 600, 1, 8, () => [90]);
  const {page, problems, close} = await openPair("two", ground, copyWith(ground, [[100, 100, [0]], [140, 100, [0]], [900, 500, [0]]]));
  await press(page, "1");
  assert.deepEqual(await boxes(page), {number: 3, reach: 1}, "each region has its box");
  await press(page, "0");
  const {reach, number} = await boxes(page);
  assert.ok(reach >= 40 && number === 2, `40 px apart, with a reach of ${reach} px`);
  return {problems, close};
});

test("edges that moved and what is below the threshold are counted apart, with their colours", async () => {
  const ramp = (shift) => makePicture(64, 64, 1, 8, (x) => [Math.round(255 * Math.min(Math.max(x - 30 - shift, 0), 1))]);
  const {page, problems, close} = await openPair("aside", ramp(0.5), copyWith(ramp(0.7), [[5, 5, [3]], [50, 50, [20]]]), {},
    ["--ignore-antialiasing", "--threshold", "0.02"]);
  const lines = await page.locator("#set-aside li").allTextContents();
  assert.match(lines[0], /^6\d pixels at moved edges, by up to \d+\/255/);
  assert.match(lines[1], /^1 pixel below the threshold, by up to 3\/255/);
  assert.ok(await page.locator("#moved-edge").isVisible());
  assert.ok(await page.locator("#below-threshold").isVisible());
  const [below, moved] = JSON.parse(await page.locator("#manifest").textContent()).heat_colours.slice(252, 254);
  assert.deepEqual(problems, []);
  await close();

  // The squares have the colours of the heat map, whatever these are.
  write("aside/other.html", fs.readFileSync(file("aside/page.html"), "utf8").replace(moved, "#123456").replace(below, "#654321"));
  const other = await openPage(file("aside/other.html"));
  const drawn = await other.page.locator(".swatch").evaluateAll((all) => all.map((each) => getComputedStyle(each).backgroundColor));
  assert.deepEqual(new Set(drawn), new Set(["rgb(18, 52, 86)", "rgb(101, 67, 33)"]));
  return other;
});

test("in a narrow window, choosing a pair or a region does not scroll the page away from the pictures", async () => {
  const {page, problems, close} = await openPage(writeNumbers("numbers"), {viewport: {width: 420, height: 700}});
  await press(page, ...Array(11).fill("j"), "n", "n", "N");
  assert.equal(await page.evaluate(() => scrollY), 0);
  const [list, row] = await page.evaluate(() => ["#pairs", "#pairs li:has([aria-current])"].map((each) => document.querySelector(each).getBoundingClientRect()));
  assert.ok(row.top >= list.top - 1 && row.bottom <= list.bottom + 1, "the open pair is seen in the list");
  return {problems, close};
});

test("a window with no room for the pictures does not stop the page", async () => {
  const {page, problems, close} = await openPage(writeNumbers("numbers"), {viewport: {width: 320, height: 100}, deviceScaleFactor: 3});
  await page.evaluate(() => Object.assign(document.getElementById("stage").style, {height: "12px", minHeight: "0", flex: "none"}));
  await press(page, "j", "0", "h", "s", "n", "0");
  assert.equal(await openName(page), "view 2.png");
  return {problems, close};
});
