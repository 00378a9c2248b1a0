// The pages of `glassbox study report` and `study extremes`: their charts are drawn, tell what they show, and fit every screen, scheme and paper.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {coloured, namelessControls, openPage, shadowsOf} from "./browser.mjs";
import {file, hostile, test} from "./cases.mjs";

const program = path.resolve(process.argv[2]);
const run = (...words) => execFileSync(program, ["study", ...words], {stdio: "pipe", cwd: file("study")});

// Results of everything that a chart can have: zeros, infinities, findings, theory, two numbers of threads, any text.
function results() {
  const time = (threads, ns, standing) => ({threads, repetitions: 11, ns, ns_quartiles: [ns * .9, ns * 1.1], ns_octiles: [ns * .85, ns * 1.15], disturbed: 0, standing});
  const configuration = (series, parameter, error, predicted, times, explanation = "") => ({series, parameter, scene: "", measure: "", error, predicted_error: predicted,
    ratio: null, finding: false, explanation, explains: explanation ? [2, 100] : null, times});
  const experiment = (id, name, configurations, rest = {}) => ({id, name, question: "Is it drawn?", axis: "steps", axis_unit: "m", logarithmic_axis: true,
    axis_is_chosen: true, error: "largest error", error_unit: "px", reference: "arithmetic", theory: "1/steps", item: "pixel", load: 1.5, mhz: "nan", measures: [], configurations, ...rest});
  const signal = {name: "signal", error: "signal over noise", error_unit: "dB", axis: "distance", axis_unit: "km", logarithmic_axis: true, more_is_better: true};
  return {format: "glassbox study results 3", version: "1", machine: "a machine", target: "avx2", caches: "32 KiB and 1 MiB", compiler: "a compiler", flags: "-O9", effort: "quick", threads: 2, part: [1, 1],
    experiments: [
      experiment("D-901", "Everything", [1, 10, 100].flatMap((steps) => [
        configuration("float", steps, 1 / steps, 1 / steps, [time(1, 10 * steps, "front"), time(2, 6 * steps, "front")]),
        configuration("exact", steps, 0, 0, [time(1, 2000, "front"), time(2, 1500, "front")]),
        configuration("broken", steps, "infinity", 1, [time(1, 5000, "dominated"), time(2, 4000, "dominated")], "it overflows")])),
      experiment("D-902", hostile, [configuration(hostile, 0, 0, null, []), configuration("b", -3, 0, null, [])], {logarithmic_axis: false}),
      experiment("D-903", "Two measures", [configuration("float", 1, 2, 2, [time(1, 10, "front")]),
        {...configuration("float", 5, 30, null, [time(1, 10, "front")]), measure: "signal"}], {measures: [signal]}),
    ]};
}

function report() {
  fs.mkdirSync(file("study"), {recursive: true});
  fs.writeFileSync(file("study", "results.json"), JSON.stringify(results()));
  run("report", "--from", "results.json", "-o", "page.html");
  return file("study", "page.html");
}

const time = '#D-901 canvas[aria-label^="Error against time;"]', axis = '#D-901 canvas[aria-label^="Error against the axis;"]';

test("study: each series is drawn in its colour, what is dominated is grey, and nothing is timed without times", async () => {
  const opened = await openPage(report()), {page} = opened;
  for (const chart of [time, axis]) {
    for (const colour of [[0, 0x72, 0xb2], [0xd5, 0x5e, 0]]) assert.ok(await coloured(page, chart, colour) > 100, `${chart} ${colour}`);
    assert.ok(await coloured(page, chart, [0x8a, 0x8f, 0x98]) > 20, chart);
  }
  assert.equal(await page.locator("#D-902 canvas").count(), 1);
  assert.equal(await page.locator("#D-902 h2").textContent(), `D-902 ${hostile}`);
  assert.equal(await page.locator("#D-901 tbody tr").count(), 9);
  assert.match(await page.locator("#D-901 .about").first().innerText(), /load 1.5/);
  assert.match(await page.locator("#origin").innerText(), /avx2[^]*32 KiB and 1 MiB/);
  assert.match(await page.locator("#D-901 .findings").innerText(), /it overflows/);
  assert.match(await page.locator("#D-901 code").innerText(), /study run D-901 --quick --threads 2/);
  assert.ok(!/NaN|undefined/.test(await page.locator("main").innerText()));
  assert.deepEqual(await namelessControls(page), []);
  return opened;
});

test("study: each measure has charts and a table of its own", async () => {
  const opened = await openPage(report()), {page} = opened;
  assert.equal(await page.locator("#D-903 canvas").count(), 4);
  assert.deepEqual(await page.locator("#D-903 h3").allTextContents(), ["Error", "Signal"]);
  assert.deepEqual(await page.locator("#D-903 tbody").evaluateAll((all) => all.map((each) => each.rows.length)), [1, 1]);
  assert.match(await page.locator("#D-903").innerText(), /signal over noise \[dB\]; more is better/);
  assert.match(await page.locator("#D-903").innerText(), /distance \[km\]/);
  return opened;
});

test("study: hovering over a point tells its configuration", async () => {
  const opened = await openPage(report()), {page} = opened;
  const at = await page.locator(axis).evaluate((canvas) => {
    const chart = Chart.getChart(canvas), point = chart.getDatasetMeta(0).data[1], box = chart.canvas.getBoundingClientRect();
    return [box.left + point.x, box.top + point.y];
  });
  await page.mouse.move(...at);
  const lines = await page.waitForFunction((canvas) => {
    const {tooltip} = Chart.getChart(document.querySelector(canvas));
    return tooltip.opacity > 0 && tooltip.body.flatMap(({lines: all}) => all);
  }, axis);
  const text = (await lines.jsonValue()).join("\n");
  for (const part of ["float", "steps: 10 m", "error: 0.1 px", "theory: 0.1, ratio 1", "100 ns", "on the Pareto front"]) assert.ok(text.includes(part), text);
  return opened;
});

test("study: the times of other numbers of threads are one key away", async () => {
  const opened = await openPage(report()), {page} = opened;
  const title = () => page.locator(time).evaluate((canvas) => Chart.getChart(canvas).options.scales.x.title.text);
  assert.match(await title(), /1 thread$/);
  await page.locator("#threads input").first().focus();
  await page.keyboard.press("ArrowRight");
  assert.match(await title(), /2 threads$/);
  return opened;
});

test("study: the page fits narrow and wide screens, dark ones, and paper", async () => {
  const made = report();
  for (const width of [360, 768, 1280, 1920]) {
    for (const colorScheme of ["light", "dark"]) {
      const {page, problems, close} = await openPage(made, {viewport: {width, height: 900}, colorScheme});
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${width} px`);
      assert.ok(await coloured(page, axis, colorScheme === "dark" ? [0x56, 0xb4, 0xe9] : [0, 0x72, 0xb2]) > 100, colorScheme);
      assert.deepEqual(problems, []);
      await close();
    }
  }
  const opened = await openPage(made, {colorScheme: "dark"}), {page} = opened;
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.ok(await coloured(page, axis, [0, 0x72, 0xb2]) > 100, "paper has the colours of light pages");
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  assert.ok(await coloured(page, axis, [0x56, 0xb4, 0xe9]) > 100);
  return opened;
});

test("study: a sweep's chart has a cross where a series gives up, and the cases their table", async () => {
  fs.mkdirSync(file("study"), {recursive: true});
  run("extremes", "--sweep", "near-far", "--case", "C-43", "--html", "extremes.html");
  const opened = await openPage(file("study", "extremes.html")), {page} = opened;
  const {crosses, ends} = await page.locator("#near-far canvas").evaluate((canvas) => ({
    crosses: Chart.getChart(canvas).data.datasets.filter(({pointRadius, pointStyle}) => pointStyle === "crossRot" && pointRadius === 14).map(({key, data}) => [key, data[0].x]),
    ends: JSON.parse(document.getElementById("manifest").textContent).sweeps[0].series.filter(({gives_up: at}) => at !== null).map(({name, gives_up: at}) => [name, at])}));
  assert.ok(ends.length >= 2);
  assert.deepEqual(crosses.sort(), ends.sort());
  assert.match(await page.locator("#near-far canvas").getAttribute("aria-label"), /the table below has the same numbers$/);
  assert.ok(await coloured(page, "#near-far canvas", [0, 0x72, 0xb2]) > 100);
  assert.match(await page.locator("#table").innerText(), /C-43.*73200.*4 of 4\s*\d+ of \d+\s*pass/s);
  assert.ok(await page.locator("#near-far tbody tr").count() > 20);
  return opened;
});

test("study: where a table is wider than the window, a shadow shows on which side there is more", async () => {
  const reported = report();
  run("extremes", "C-43", "C-20", "--html", "cases.html");
  for (const made of [reported, file("study", "cases.html")]) {
    for (const colorScheme of ["light", "dark"]) {
      const {page, problems, close} = await openPage(made, {viewport: {width: 420, height: 800}, colorScheme}), shadows = await shadowsOf(page, ".scroll");
      assert.ok(shadows.length >= 1);
      for (const each of shadows) assert.deepEqual(each, [[false, true], [true, false]], `${path.basename(made)}, ${colorScheme}`);
      assert.deepEqual(problems, []);
      await close();
    }
  }
});

test("study: screenshots", async () => {
  fs.mkdirSync(file("screenshots"), {recursive: true});
  fs.mkdirSync(file("study"), {recursive: true});
  try {
    run("run", "D-13", "D-2", "--quick", "--json", "real.json");
  } catch (error) {
    if (error.status !== 1) throw error; // findings
  }
  run("report", "--from", "real.json", "-o", "real.html");
  for (const [name, settings] of [["study-light", {}], ["study-dark", {colorScheme: "dark", viewport: {width: 1920, height: 1080}}]]) {
    const {page, problems, close} = await openPage(file("study", "real.html"), settings);
    await page.screenshot({path: file("screenshots", `${name}.png`), fullPage: true});
    assert.deepEqual(problems, []);
    await close();
  }
});
