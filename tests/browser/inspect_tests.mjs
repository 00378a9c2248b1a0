// The page of `glassbox inspect`: what it shows is what the run made, and it can be used in every way it says.
import assert from "node:assert/strict";
import fs from "node:fs";
import {canvasBox, colourAt, namelessControls, openPage, press, settled} from "./browser.mjs";
import {file, test} from "./cases.mjs";
import {chosen, choosePixel, inspect, note, now, render, small} from "./inspect_cases.mjs";
import {pixelOf} from "./pictures.mjs";

test("inspect: a click chooses the pixel under the mouse, and shows the bytes of the picture", async () => {
  const opened = await openPage(inspect("small", "teapot", ...small), {}, "#pixel=0,0"), {page} = opened;
  const picture = render("small", "teapot", ...small), box = await canvasBox(page);
  const points = [[0.5, 0.5], [0.4, 0.6], [0.62, 0.4], [0.1, 0.2]].map(([u, v]) => [box.x + box.width * u, box.y + box.height * v]);
  const drawn = [];
  for (const [x, y] of points) drawn.push(await colourAt(page, x, y)); // before the crosshair is there
  for (const [i, [x, y]] of points.entries()) {
    await page.mouse.click(x, y);
    await settled(page);
    const pixel = ["#pixel-x", "#pixel-y"].map((id) => page.inputValue(id).then(Number));
    const [r, g, b] = pixelOf(picture, ...await Promise.all(pixel));
    assert.ok((await note(page)).includes(`shows (${r}, ${g}, ${b})`));
    assert.deepEqual(drawn[i], [r, g, b]);
  }
  return opened;
});

test("inspect: arrow keys step through the fragments either way, with Shift on the pixel, and the picture follows", async () => {
  const opened = await openPage(inspect("small", "teapot", ...small)), {page} = opened;
  await choosePixel(page, 160, 90);
  const first = await chosen(page), before = await now(page);
  assert.deepEqual([first.x, first.y], [160, 90]);
  await page.locator("#view").focus();
  await press(page, "ArrowRight");
  assert.equal((await chosen(page)).fragment, first.fragment + 1);
  await press(page, "ArrowLeft");
  assert.equal((await chosen(page)).fragment, first.fragment);
  assert.notEqual(await now(page), before, "the picture is that after the fragment now");
  await press(page, "Shift+ArrowRight");
  const next = await chosen(page);
  assert.ok(next.fragment > first.fragment && next.x === 160 && next.y === 90);
  await press(page, "Shift+ArrowLeft");
  assert.equal((await chosen(page)).fragment, first.fragment);
  // Before its first fragment the pixel shows the background, after it what that wrote.
  await press(page, "ArrowLeft");
  await choosePixel(page, 160, 90);
  assert.match(await note(page), /shows \(26, 31, 38\)/);
  await page.locator("#view").focus();
  await press(page, "Home");
  assert.match(await now(page), /^After 0 of/);
  await page.locator("#scrubber").focus();
  await press(page, "End");
  assert.match(await now(page), /^After 36,314 of 36,314/);
  return opened;
});

test("inspect: matrices open into their factors and parameters, and stay open from pixel to pixel", async () => {
  const opened = await openPage(inspect("camera", "teapot", ...small, "--eye", "4,3,6", "--look-at", "0,1,0", "--fov", "40", "--near", "0.5", "--far", "50")), {page} = opened;
  await choosePixel(page, 160, 90);
  assert.equal(await page.locator("#view-matrix table").first().isVisible(), false);
  await page.click("#view-matrix summary");
  await page.click("#projection summary");
  const view = await page.locator("#view-matrix").innerText(), projection = await page.locator("#projection").innerText();
  for (const words of ["eye\n(4, 3, 6)", "asked for: --look-at", "R: right, up and minus the gaze as rows", "T: the eye moves"]) assert.ok(view.includes(words), `${words} in ${view}`);
  for (const words of ["vertical angle of view, degrees\n40", "near\n0.5", "far\n50", "320 / 180"]) assert.ok(projection.includes(words), `${words} in ${projection}`);
  await press(page, "ArrowRight");
  assert.equal(await page.locator("#view-matrix table").first().isVisible(), true);
  // R times T is the view matrix, and its first row is perpendicular to the gaze.
  const [whole, r, t] = await page.locator("#view-matrix table").evaluateAll((tables) => tables.map((table) =>
    [...table.querySelectorAll("td")].map((cell) => Number(cell.textContent.replace("−", "-")))));
  for (let i = 0; i < 16; i++) {
    const sum = [0, 1, 2, 3].reduce((total, k) => total + r[(i & 12) + k] * t[4 * k + (i & 3)], 0);
    assert.ok(Math.abs(sum - whole[i]) <= 1e-5 * 20, `entry ${i}: ${sum} and ${whole[i]}`); // six digits of sums up to 10
  }
  await page.check("#hex");
  assert.match(await page.locator("#chain .bits").first().innerText(), /^0x[0-9a-f]{8}$/);
  return opened;
});

test("inspect: the address leads back to pixel, fragment, vertex, overlay and space", async () => {
  const made = inspect("small", "teapot", ...small), first = await openPage(made);
  await choosePixel(first.page, 150, 100);
  await press(first.page, "Shift+ArrowRight");
  await first.page.selectOption("#overlay", "depth");
  await first.page.selectOption("#space-name", "eye");
  await first.page.locator("#vertices input").nth(1).focus();
  await press(first.page, " ");
  await first.page.waitForTimeout(300);
  const hash = new URL(first.page.url()).hash, second = await openPage(made, {}, hash);
  for (const id of ["#now", "#pixel-note", "#overlay-note", "#chain"]) {
    assert.equal(await second.page.textContent(id), await first.page.textContent(id), `${id} of ${hash}`);
  }
  assert.equal(await second.page.inputValue("#space-name"), "eye");
  assert.equal(await second.page.locator("#vertices input:checked").inputValue(), "1");
  await first.close();
  // Nonsense leads to the page as it opens.
  const third = await openPage(made, {}, "#pixel=-1,1e9&fragment=x&overlay=constructor&space=__proto__&vertex=99");
  assert.match(await now(third.page), /^After 36,314 of/);
  assert.deepEqual(third.problems, []);
  await third.close();
  return second;
});

test("inspect: the page's arithmetic gives the run's numbers to the bit, and its bounds", async () => {
  const scenes = [["cut", "room", "--size", "640x360", "--eye", "0,0.7,0", "--look-at", "1,0.4,0.2", "--fov", "80", "--near", "0.1", "--rect", "180,160,270,200"],
    ["many", "forest", "--size", "640x360", "--rect", "300,150,340,180"], ["parallel", "forest", "--size", "640x360", "--ortho", "3", "--cull", "none", "--depth", "d24", "--rect", "300,150,340,180"],
    ["reversed", "room", "--size", "640x360", "--depth", "d32r", "--rect", "300,150,320,180"], ["coarse", "teapot", ...small, "--depth", "d16", "--rect", "100,60,200,120"]];
  let numbers = 0;
  for (const [name, ...words] of scenes) {
    const opened = await openPage(inspect(`check-${name}`, ...words)), {page} = opened;
    await page.click("#check-button");
    const found = await page.textContent("#check-note");
    assert.match(found, /all are equal to the run's records/, `${name}: ${found}`);
    numbers += Number(found.match(/^[\d,]+/)[0].replaceAll(",", ""));
    assert.deepEqual(opened.problems, []);
    await opened.close();
  }
  assert.ok(numbers > 100000, `${numbers} numbers`);
});

test("inspect: the check sees a matrix that is off by one bit", async () => {
  const made = inspect("check-coarse", "teapot", ...small, "--rect", "100,60,120,70"), page = fs.readFileSync(made, "utf8");
  const entry = page.match(/"clip_from_anchored":\[([-\d.e]+),/), bits = new DataView(new ArrayBuffer(4));
  bits.setFloat32(0, Number(entry[1]));
  bits.setUint32(0, bits.getUint32(0) + 1);
  fs.writeFileSync(file("inspect/planted.html"), page.replace(entry[0], `"clip_from_anchored":[${bits.getFloat32(0)},`));
  const opened = await openPage(file("inspect/planted.html"));
  await opened.page.click("#check-button");
  assert.match(await opened.page.textContent("#check-note"), /differ from the run's records/);
  return opened;
});

test("inspect: two runs stand side by side and part at the first fragment that differs", async () => {
  const a = inspect("small", "teapot", ...small), b = inspect("flat", "teapot", ...small, "--shade", "flat");
  const moved = inspect("moved", "teapot", ...small, "--fov", "44"), large = inspect("other-size", "teapot", "--size", "160x90");
  const opened = await openPage(a), {page} = opened;
  const open = async (name) => {
    await page.setInputFiles("#other-file", name);
    await page.waitForFunction(() => !document.getElementById("compare-note").textContent.startsWith("Reading"));
    await settled(page);
    return page.textContent("#compare-note");
  };
  assert.match(await open(a), /equal, to the last byte/);
  assert.match(await open(b), /in the order of the stages/);
  assert.deepEqual(await page.locator("#divergences li").allTextContents(), ["Fragment 1 is the first that differs: another colour."]);
  await page.screenshot({path: file("inspect", "two.png")});
  await open(moved);
  assert.match((await page.locator("#divergences li").allTextContents())[0], /The view matrices differ/);
  const divergent = await chosen(page);
  await press(page, "End");
  await page.click("#first-divergence");
  assert.deepEqual(await chosen(page), divergent);
  assert.ok(await page.locator("#chain tr.differs").count() > 0, "numbers that differ are marked");
  assert.match(await open(large), /160 × 90 pixels, but this page's has 320 × 180/);
  fs.writeFileSync(file("inspect/none.html"), "<script>parent.alert(1)</script><p>no page of this kind");
  assert.match(await open(file("inspect/none.html")), /it is not a page of glassbox inspect/);
  const broken = fs.readFileSync(b, "utf8").replace(/"fragment.x","u16",\d+/, `"fragment.x","u16",12`);
  fs.writeFileSync(file("inspect/broken.html"), broken);
  assert.match(await open(file("inspect/broken.html")), /cannot be compared with this page/);
  await page.click("#close-other");
  assert.equal(await page.locator("#divergences li").count(), 0);
  return opened;
});

test("inspect: every overlay says what it shows", async () => {
  const opened = await openPage(inspect("cut", "room", "--size", "320x180", "--eye", "0,0.7,0", "--look-at", "1,0.4,0.2", "--fov", "80", "--near", "0.1")), {page} = opened;
  const stages = JSON.parse(await page.locator("#manifest").textContent()).stages, notes = {};
  for (const value of await page.locator("#overlay option").evaluateAll((options) => options.map((option) => option.value))) {
    await page.selectOption("#overlay", value);
    await settled(page);
    notes[value] = await page.textContent("#overlay-note");
    if (value !== "none") assert.notEqual(notes[value], "");
  }
  assert.ok(notes.clipped.startsWith(`${stages.clipped} triangles cut`), notes.clipped);
  assert.match(notes.culled, /would have covered [\d,]+ pixels/);
  const hidden = await openPage(inspect("hidden", "room", "--size", "320x180", "--show", "overdraw"));
  assert.equal(await hidden.page.inputValue("#overlay"), "overdraw");
  await hidden.page.selectOption("#overlay", "hidden");
  const failed = JSON.parse(await hidden.page.locator("#manifest").textContent()).stages.depth_failed;
  assert.ok((await hidden.page.textContent("#overlay-note")).startsWith(failed.toLocaleString("en")));
  assert.deepEqual(hidden.problems, []);
  await hidden.close();
  return opened;
});

test("inspect: a triangle that is not to be seen says why", async () => {
  const opened = await openPage(inspect("cut", "room", "--size", "320x180", "--eye", "0,0.7,0", "--look-at", "1,0.4,0.2", "--fov", "80", "--near", "0.1")), {page} = opened;
  const found = new Set(), total = JSON.parse(await page.locator("#manifest").textContent()).stages.triangles;
  for (let number = 0; number < total; number += 7) {
    await page.fill("#triangle-number", String(number));
    await page.press("#triangle-number", "Enter");
    const verdict = await page.textContent("#verdict");
    for (const word of ["outside the near plane", "Culled", "Clipping made it", "covers no pixel", "written"]) if (verdict.includes(word)) found.add(word);
    assert.ok(verdict.length > 10, `triangle ${number}: ${verdict}`);
  }
  assert.deepEqual([...found].sort(), ["Clipping made it", "Culled", "covers no pixel", "outside the near plane", "written"]);
  return opened;
});

test("inspect: the keyboard reaches everything and is never caught, and the 3-D view turns", async () => {
  const opened = await openPage(inspect("small", "teapot", ...small), {}, "#pixel=160,90"), {page} = opened;
  assert.deepEqual(await namelessControls(page), []);
  const stops = [];
  await page.evaluate(() => document.activeElement.blur());
  for (let i = 0; i < 120; i++) {
    await page.keyboard.press("Tab");
    const id = await page.evaluate(() => document.activeElement === document.body ? "end" : document.activeElement.id || document.activeElement.tagName);
    if (id === "end") break;
    stops.push(id);
  }
  for (const id of ["other-file", "overlay", "view", "space", "space-name", "play", "play-what", "pixel-x", "triangle-number", "hex", "scrubber", "fragment-number", "pixel-forward"]) assert.ok(stops.includes(id), `${id} in ${stops}`);
  assert.ok(stops.length < 120, "Tab comes to an end");
  const look = () => page.evaluate(() => document.getElementById("space").toDataURL());
  await page.locator("#space").focus();
  const before = await look(), at = await now(page);
  await press(page, "ArrowRight", "ArrowDown");
  assert.notEqual(await look(), before);
  assert.equal(await now(page), at, "turning does not step");
  for (const name of ["object", "world", "eye", "clip", "screen"]) {
    const last = await look();
    await page.selectOption("#space-name", name);
    await settled(page);
    assert.notEqual(await look(), last, name);
  }
  const faces = await look();
  await page.check("#edges-only");
  assert.notEqual(await look(), faces, "edges in place of faces");
  await page.locator("#view").focus();
  await press(page, "d", "s");
  assert.deepEqual([await page.inputValue("#pixel-x"), await page.inputValue("#pixel-y")], ["161", "91"]);
  return opened;
});

test("inspect: without WebGL the page says so and all else works", async () => {
  const opened = await openPage(inspect("small", "teapot", ...small), {}, "", () => {
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return kind.startsWith("webgl") ? null : original.call(this, kind, ...rest); };
  }), {page} = opened;
  assert.equal(await page.isVisible("#no-webgl"), true);
  await choosePixel(page, 160, 90);
  assert.equal((await chosen(page)).x, 160);
  return opened;
});

test("inspect: nothing is wider than a narrow window", async () => {
  const opened = await openPage(inspect("small", "teapot", ...small), {viewport: {width: 360, height: 740}}, "#pixel=160,90"), {page} = opened;
  await page.locator("details").evaluateAll((all) => all.forEach((each) => { each.open = true; }));
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  return opened;
});

test("inspect: in a narrow window the timeline is slim, lies over everything, and the other controls are in the page", async () => {
  const height = 740, opened = await openPage(inspect("small", "teapot", ...small), {viewport: {width: 420, height}}, "#pixel=160,90"), {page} = opened;
  for (const down of [0, 100, 200, 300, 600, 1e6]) {
    await page.evaluate((y) => scrollTo(0, y), down);
    const {top, bottom, covered} = await page.evaluate(() => {
      const {top, bottom} = document.getElementById("timeline").getBoundingClientRect(), controls = document.querySelectorAll("#timeline button, #timeline input");
      const isSeen = (node) => { const box = node.getBoundingClientRect(); return document.elementFromPoint(box.left + 3, box.top + box.height / 2) === node; };
      return {top, bottom, covered: [...controls].filter((node) => !isSeen(node)).map(({id}) => id)};
    });
    assert.ok(Math.abs(bottom - height) < 1, `it stays at the bottom at ${down} px: ${bottom}`);
    assert.ok(bottom - top < 0.1 * height, `it is ${bottom - top} px high`);
    assert.deepEqual(covered, [], `at ${down} px`);
  }
  for (const id of ["#play-what", "#fragment-number", "#pixel-back", "#pixel-forward"]) {
    await page.locator(id).scrollIntoViewIfNeeded();
    assert.ok(await page.locator(id).isVisible(), id);
  }
  await page.fill("#triangle-number", "99999999");
  await page.press("#triangle-number", "Enter");
  assert.ok(await page.locator("#now").evaluate((node) => node.scrollWidth <= node.clientWidth), "what it has to say is not cut off");
  return opened;
});

test("inspect: screenshots", async () => {
  fs.mkdirSync(file("screenshots"), {recursive: true});
  const made = inspect("room", "room", "--size", "640x360", "--pixel", "320,200"), open = "#pixel=320,200&space=world";
  for (const [name, settings, hash, ...clicks] of [["inspect-light", {}, open, "#projection summary"], ["inspect-dark", {colorScheme: "dark"}, `${open}&overlay=overdraw`],
    ["inspect-zoomed", {}, open, ...Array(9).fill("#zoom-in")], ["inspect-narrow", {viewport: {width: 400, height: 800}, deviceScaleFactor: 2}, open],
    ["inspect-projector", {viewport: {width: 2560, height: 1440}}, `${open}&overlay=depth`]]) {
    const {page, problems, close} = await openPage(made, settings, hash);
    for (const click of clicks) await page.click(click);
    await settled(page);
    await page.screenshot({path: file("screenshots", `${name}.png`), fullPage: name === "inspect-narrow"});
    assert.deepEqual(problems, []);
    await close();
  }
});
