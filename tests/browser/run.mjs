// The pages of `glassbox bench --html`, `glassbox diff --html`, `glassbox inspect`, `glassbox stereo --html`, `glassbox study extremes
// --html`, `glassbox study report`, `glassbox study scene --html`, `glassbox study stiffness`, `glassbox views geometry --draw`,
// `glassbox views glyphs find --html`, `glassbox views klt --html`, `glassbox views layers draw --html`, `glassbox views match --html`,
// `glassbox views triangulate --html` and `glassbox views voxels --html` in a browser, and the recipe for Playwright.
//
//     node run.mjs PROGRAM DIRECTORY [WORDS]
//
// PROGRAM makes the pages; DIRECTORY takes pictures, pages and screenshots. With WORDS, only
// tests with these in their name. Ends with 0 if nothing failed.
import assert from "node:assert/strict";
import {closeBrowser} from "./browser.mjs";
import {tests} from "./cases.mjs";
import "./bench_tests.mjs";
import "./colours_tests.mjs";
import "./curve_tests.mjs";
import "./drawing_tests.mjs";
import "./geometry_tests.mjs";
import "./inspect_history_tests.mjs";
import "./inspect_space_tests.mjs";
import "./inspect_tests.mjs";
import "./inspect_ways_tests.mjs";
import "./layers_tests.mjs";
import "./match_tests.mjs";
import "./pairs_tests.mjs";
import "./recipe_tests.mjs";
import "./stereo_tests.mjs";
import "./stiffness_tests.mjs";
import "./study_tests.mjs";
import "./using_tests.mjs";
import "./surface_tests.mjs";
import "./triangulate_tests.mjs";
import "./voxels_tests.mjs";

let failed = 0;
const chosen = tests.filter(({name}) => name.includes(process.argv[4] ?? ""));
for (const {name, body} of chosen) {
  try {
    const opened = await body();
    if (opened) {
      assert.deepEqual(opened.problems, [], "nothing goes wrong, and nothing is asked of the network");
      await opened.close();
    }
    console.log(`passed: ${name}`);
  } catch (error) {
    failed++;
    console.log(`FAILED: ${name}\n${error.stack}`);
  }
}
await closeBrowser();
console.log(`${chosen.length - failed} passed, ${failed} failed`);
process.exitCode = failed || !chosen.length ? 1 : 0;
