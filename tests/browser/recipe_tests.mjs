// The recipe for Playwright of docs/image_tests.md: a screenshot that is new, approved, the same, and different.
import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {fileURLToPath} from "node:url";
import {file, program, test, write} from "./cases.mjs";

const examples = fileURLToPath(new URL("../../examples/image_tests", import.meta.url));

test("Playwright's recipe fails, is approved except on servers, passes, and finds another heading", async () => {
  const recipe = fs.readFileSync(path.join(examples, "heading.test.mjs"), "utf8");
  write("recipe/heading.test.mjs", recipe);
  write("recipe/golden.mjs", fs.readFileSync(path.join(examples, "golden.mjs")));
  // Chromium has no sandbox for root.
  const options = process.getuid() === 0 ? "--no-sandbox" : "";
  write("recipe/chromium.sh", `#!/bin/sh\nexec "${process.env.CHROMIUM ?? "/usr/bin/chromium"}" ${options} "$@"\n`);
  fs.chmodSync(file("recipe/chromium.sh"), 0o755);
  for (const old of ["golden", "golden-failures"]) fs.rmSync(file("recipe", old), {recursive: true, force: true});

  const {CI, GLASSBOX_APPROVE, GLASSBOX_FAILURES, ...inherited} = process.env;
  const run = (more = {}) => spawnSync(process.execPath, ["heading.test.mjs"], {
    cwd: file("recipe"), encoding: "utf8",
    env: {...inherited, GLASSBOX_PROGRAM: program, CHROMIUM: file("recipe/chromium.sh"), ...more}});
  const fails = ({status, stdout}, ...texts) => {
    assert.equal(status, 1, stdout);
    for (const text of texts) assert.ok(stdout.includes(text), `"${text}" in ${stdout}`);
  };
  const page = file("recipe/golden-failures/heading.png.html");
  fails(run(), "there is no such reference", `page: ${page}`, "GLASSBOX_APPROVE=1");
  fails(run({GLASSBOX_APPROVE: "1", CI: "true"}), "CI is set");
  assert.ok(!fs.existsSync(file("recipe/golden")));
  for (const more of [{GLASSBOX_APPROVE: "1"}, {}]) {
    const {status, stdout} = run(more);
    assert.equal(status, 0, stdout);
    assert.ok(!fs.existsSync(page), "the page of the failure is deleted");
  }
  assert.ok(fs.existsSync(file("recipe/golden/heading.png")));
  write("recipe/heading.test.mjs", recipe.replace("A heading", "Another"));
  fails(run(), "pixels differ", `page: ${page}`);
  assert.ok(fs.existsSync(page));

  write("recipe/heading.test.mjs", recipe.replace("--ignore-antialiasing", "--sise"));
  const {status, stdout} = run();
  assert.equal(status, 1, stdout);
  assert.ok(stdout.includes("--sise") && !stdout.includes("page:"), stdout);
});
