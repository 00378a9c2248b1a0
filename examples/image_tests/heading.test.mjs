import test from "node:test"; // or from "@playwright/test", whose tests have the page as an argument
import {chromium} from "playwright-core";
import {assertMatchesGolden} from "./golden.mjs";

test("the heading looks as it was approved", async () => {
  const browser = await chromium.launch({executablePath: process.env.CHROMIUM});
  const page = await browser.newPage({viewport: {width: 320, height: 120}});
  await page.setContent("<h1 style='color: teal'>A heading</h1>");
  await page.screenshot({path: "heading.png"});
  await browser.close();
  assertMatchesGolden("heading.png", "heading.png", "--ignore-antialiasing", "--threshold", "0.1");
});
