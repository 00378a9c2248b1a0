// A picture of a page, for the docs:
//
//     node shoot.mjs PAGE.html[#...] WIDTHxHEIGHT PICTURE.png [light|dark] [SELECTOR ...]
//
// Clicks what the selectors name, in order, before it takes the picture. Needs playwright-core beside it (npm install), as
// the tests do.
import path from "node:path";
import {closeBrowser, openPage, settled} from "./browser.mjs";

const [, , page, size, picture, colorScheme = "light", ...clicks] = process.argv;
const [file, hash = ""] = page.split("#"), [width, height] = size.split("x").map(Number);
const opened = await openPage(path.resolve(file), {viewport: {width, height}, colorScheme}, hash && "#" + hash);
for (const selector of clicks) await opened.page.click(selector);
await settled(opened.page);
await opened.page.screenshot({path: picture});
await closeBrowser();
if (opened.problems.length) console.error(opened.problems.join("\n"));
process.exitCode = opened.problems.length ? 1 : 0;
