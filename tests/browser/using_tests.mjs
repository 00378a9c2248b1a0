// What people do with the pages: by mouse, by keys, with many pairs, on any screen.
import assert from "node:assert/strict";
import fs from "node:fs";
import {canvasBox, crosshair, hover, namelessControls, openPage, press, readout, settled} from "./browser.mjs";
import {changedColours, checkDrawn, colours, file, goTo, hostile, makePage, openPair, test, write,
  writeFolder} from "./cases.mjs";
import {pixelOf} from "./pictures.mjs";

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

test("a page of many pairs lists the worst first, opens each, and keeps names as text", async () => {
  const {page, problems, close} = await openPage(writeFolder());
  const names = await page.locator(".pair-name").allTextContents();
  assert.deepEqual([...names].sort(), [hostile, "corrupt.png", "light.pfm", "missing.png", "new.png", "same-1.png",
    "same-2.png", "sizes.png", "slight.png", "strong.png"]);
  assert.equal(names[0], "sizes.png");
  assert.ok(names.indexOf("strong.png") < names.indexOf("slight.png"));
  assert.deepEqual(names.slice(-2), ["same-1.png", "same-2.png"]);
  assert.match(await page.textContent("#summary"), /5 different.*2 same/);
  assert.deepEqual(await page.evaluate(() => [...document.images].filter((image) => !image.src.startsWith("data:"))), []);

  for (let i = 0; i < names.length; i++) {
    await page.locator(`#pairs button >> nth=${i}`).click();
    await settled(page);
    assert.equal(await page.textContent("#name"), names[i]);
    assert.equal(await page.locator("#pairs [aria-current] .pair-name").textContent(), names[i]);
    const why = names[i].startsWith("same") ? "#message" : "#decisive";
    assert.notEqual(await page.textContent(why), "", `${names[i]} says why`);
  }
  const heatWorks = async (name) => {
    await page.locator("#pairs button", {hasText: name}).click();
    await settled(page);
    return page.locator("input[value=heat]").isEnabled();
  };
  assert.equal(await heatWorks("sizes.png"), true);
  assert.equal(await heatWorks("strong.png"), true);
  for (const name of ["missing.png", "new.png", "corrupt.png"]) {
    assert.equal(await heatWorks(name), false);
    const box = await canvasBox(page);
    await hover(page, box.x + box.width / 2, box.y + box.height / 2);
    const at = await readout(page), [r, g, b] = pixelOf(colours, at.x, at.y);
    const shown = name === "new.png" ? at.test : at.reference; // the picture that is there
    assert.equal(shown, `R ${r}  G ${g}  B ${b}`, name);
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
    for (const [pair, ratio] of Object.entries(ratios.result)) {
      assert.ok(ratio >= 4.5, `${colorScheme}: ${pair}: ${ratio}`); // WCAG 2, 1.4.3
    }
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
  assert.deepEqual(await namelessControls(page), []);
  return {problems, close};
});

test("screenshots", async () => {
  const many = writeFolder();
  fs.mkdirSync(file("screenshots"), {recursive: true});
  for (const [name, settings, pair, ...keys] of [
    ["many-light", {}, "strong.png"], ["many-dark", {colorScheme: "dark"}, "light.pfm", "n"],
    ["zoomed", {}, "strong.png", "n", "+"], ["wipe", {}, "strong.png", "w"],
    ["heat", {colorScheme: "dark"}, "strong.png", "h"],
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
