// The pixel's history on the page of `glassbox inspect`: it lists what `glassbox pixel` lists, turned-away and clipped triangles too.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import path from "node:path";
import {openPage, press} from "./browser.mjs";
import {test} from "./cases.mjs";
import {chosen, choosePixel, inspect, note, now, small} from "./inspect_cases.mjs";

const program = path.resolve(process.argv[2]);

// The events that `glassbox pixel` gives, and those that the page lists, in the same form.
function eventsOfCommand(scene, words, x, y) {
  const text = execFileSync(program, ["pixel", scene, ...words, "--at", `${x},${y}`, "--json", "-"], {stdio: ["ignore", "pipe", "ignore"]});
  return JSON.parse(text).history.events.map(({fate, triangle, plane, inside, shows, area_px2: area}) =>
    [triangle, fate, ...(fate === "clipped" ? [plane, shows, Number((-inside).toPrecision(9))] : fate === "turned-away" ? [shows, Number(area.toPrecision(9))] : [])]);
}
const eventsOnPage = async (page) => {
  const rows = await page.locator("#pixel-fragments button").evaluateAll((all) => all.map((button) => Array.from(button.children, ({textContent}) => textContent)));
  return rows.map(([triangle, fate, , why = ""]) => {
    const [, ...words] = why.match(/^the (.+) plane cut off its (\w+), which would be at this pixel \(it is (\S+) outside\)$/) ??
      why.match(/^shows its (\w+): signed area (\S+) px², counter-clockwise is positive$/) ?? [];
    return [Number(triangle.match(/^triangle (\d+)$/)[1]), fate, ...words.map((word) => (/\d/.test(word) ? Number(word.replace("−", "-")) : word))];
  });
};

test("inspect: a pixel's history has the events of glassbox pixel, turned-away and clipped triangles too", async () => {
  const cases = [["near", "room", "--eye", "0.3,1.2,0.4", "--look-at", "-1,0.8,-1", "--near", "1.5"], ["far", "room", "--far", "4.5"], ["crowd", "forest"],
    ["inside", "room", "--eye", "0,0.7,0", "--look-at", "1,0.4,0.2", "--fov", "80", "--near", "0.1"], ["front", "teapot:4", "--cull", "front", "--near", "4.8"],
    ["parallel", "forest", "--ortho", "3", "--near", "6"], ["back", "room", "--depth", "d32r", "--near", "2"], ["part", "room", "--near", "4", "--rect", "100,60,200,140"]];
  const found = {};
  let seed = 1;
  const below = (limit) => (seed = (seed * 48271) % 2147483647) % limit;
  for (const [name, scene, ...words] of cases) {
    const {page, problems, close} = await openPage(inspect(`history-${name}`, scene, ...small, ...words));
    const options = words.filter((word, i) => word !== "--rect" && words[i - 1] !== "--rect");
    for (let i = 0; i < 10; i++) {
      const [x, y] = [100 + below(100), 60 + below(80)];
      await choosePixel(page, x, y);
      const listed = await eventsOnPage(page);
      assert.deepEqual(listed, eventsOfCommand(scene, [...small, ...options], x, y), `${name}, pixel (${x}, ${y})`);
      for (const [, fate, plane] of listed) found[fate === "clipped" ? plane : fate] = (found[fate === "clipped" ? plane : fate] ?? 0) + 1;
    }
    assert.deepEqual(problems, []);
    await close();
  }
  for (const kind of ["near", "far", "turned-away", "hidden", "written"]) assert.ok(found[kind] >= 10, `${kind} in ${JSON.stringify(found)}`);
});

test("inspect: an empty pixel says what was cut there and by which plane, and its list leads to the triangle", async () => {
  const opened = await openPage(inspect("history-empty", "cube", ...small, "--near", "20", "--far", "40")), {page} = opened;
  await choosePixel(page, 160, 90);
  assert.match(await note(page), /^0 fragments; shows \(26, 31, 38\); without a fragment: (\d+ turned-away, )?\d+ clipped$/);
  const text = await page.textContent("#chain");
  assert.match(text, /the near plane cut off its front, which would be at this pixel \(it is [\d.]+ outside\)/);
  assert.doesNotMatch(text, /Click on something/);
  const number = text.match(/Triangle (\d+): the near/)[1];
  await page.locator("#pixel-fragments button", {hasText: `triangle ${number}`}).first().focus();
  await press(page, "Enter");
  assert.equal(await page.textContent("#chain h2"), `Triangle ${number}`);
  assert.match(await page.textContent("#verdict"), /outside the near plane/);
  assert.deepEqual([await page.inputValue("#pixel-x"), await page.inputValue("#pixel-y")], ["160", "90"], "the pixel stays");
  assert.equal(await page.locator("#pixel-fragments [aria-current]").count(), 1);
  await choosePixel(page, 2, 2);
  assert.match(await page.textContent("#chain"), /Click on something that is drawn/);
  return opened;
});

test("inspect: Home and End go through time and leave the chosen pixel where it is", async () => {
  const opened = await openPage(inspect("small", "teapot", ...small)), {page} = opened;
  await choosePixel(page, 150, 100);
  const pixel = async () => [await page.inputValue("#pixel-x"), await page.inputValue("#pixel-y"), await page.textContent("#pixel-title")];
  const before = await pixel(), shown = await chosen(page);
  for (const from of ["#scrubber", "#view"]) {
    for (const [key, moment] of [["Home", /^After 0 of/], ["End", /^After 36,314 of/]]) {
      await page.locator(from).focus();
      await press(page, key);
      assert.match(await now(page), moment);
      assert.deepEqual(await pixel(), before, `${key} in ${from}`);
    }
    assert.deepEqual(await chosen(page), shown, "at the end it shows the pixel's fragment again");
  }
  for (const button of ["#first", "#last"]) {
    await page.click(button);
    assert.deepEqual(await pixel(), before, button);
  }
  await page.click("#first");
  await page.locator("#view").focus();
  await press(page, "ArrowRight");
  assert.equal((await chosen(page)).fragment, 1, "from before the first fragment a step leads to it");
  return opened;
});
