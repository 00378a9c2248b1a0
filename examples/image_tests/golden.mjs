// Golden images for tests in JavaScript. Needs Node.js and the program glassbox.
import {spawnSync} from "node:child_process";
import {existsSync, mkdirSync, rmSync} from "node:fs";
import path from "node:path";
import {fileURLToPath} from "node:url";

const golden = fileURLToPath(new URL("golden", import.meta.url));

// Throws unless the picture file equals the golden image of this name. The options are those of `glassbox
// diff`. GLASSBOX_APPROVE=1 makes a picture that differs, or is new, the golden image.
export function assertMatchesGolden(picture, name, ...options) {
  const diff = (...more) => {
    const words = ["diff", path.join(golden, name), picture, ...options, ...more];
    const run = spawnSync(process.env.GLASSBOX_PROGRAM || "glassbox", words, {encoding: "utf8"});
    if (run.error) throw run.error;
    return run;
  };
  const page = path.resolve(process.env.GLASSBOX_FAILURES || "golden-failures", `${name}.html`);
  rmSync(page, {force: true}); // that of an earlier failure
  const {status, stdout, stderr} = diff();
  if (status === 0) return;
  if (!["", "0", undefined].includes(process.env.GLASSBOX_APPROVE)) {
    const approval = diff("--approve");
    if (approval.status !== 0) throw new Error(approval.stderr); // refused where CI is set
    return;
  }
  mkdirSync(path.dirname(page), {recursive: true});
  diff("--html", page);
  const where = existsSync(page) ? `page: ${page}\n` : ""; // there is none if an option is refused
  throw new Error(`${stdout}${stderr}${where}If the picture is right, run the test again with GLASSBOX_APPROVE=1.`);
}
