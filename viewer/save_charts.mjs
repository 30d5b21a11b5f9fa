// SPDX-License-Identifier: MIT
// Writes the charts of a report as SVG files: usage: node save_charts.mjs REPORT_FOLDER OUT_FOLDER.
// scripts/charts calls it.
import { mkdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [report, out] = process.argv.slice(2).map((folder) => resolve(folder));
const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: ["--no-sandbox"] });
try {
  const page = await browser.newPage();
  await page.goto(pathToFileURL(join(report, "report.html")).href);
  const files = await page.evaluate(() => globalThis.flinchReport?.files());
  if (!files?.length) throw new Error(`${report}/report.html holds no report`);
  mkdirSync(out, { recursive: true });
  for (const { name, text } of files) writeFileSync(join(out, name), text);
  console.log(`${files.length} charts are in ${out}`);
} catch (error) {
  console.error(`scripts/charts: ${error.message}`);
  process.exitCode = 1;
} finally {
  await browser.close();
}
