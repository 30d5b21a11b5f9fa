// SPDX-License-Identifier: MIT
// Puts selector files into the page: usage: node fill.mjs PAGE OUT SELECTOR...
import { readFileSync, renameSync, writeFileSync } from "node:fs";
import { basename, resolve } from "node:path";

const [page, out, ...selectors] = process.argv.slice(2);
const kMark = "<!-- selectors -->";
try {
  const html = readFileSync(page, "utf8");
  if (!html.includes(kMark)) throw new Error(`${page} is not the page that scripts/page builds`);
  const data = selectors.map((file) => {
    const name = basename(file).replace(/[^\w. -]/g, "_");
    const bytes = readFileSync(file).toString("base64");
    return `<script type="application/octet-stream" data-selector="${name}">${bytes}</script>\n`;
  });
  writeFileSync(`${out}.partial`, html.replace(kMark, () => data.join("")));
  renameSync(`${out}.partial`, out);
  console.log(`${out}: open it in a browser, file://${resolve(out)}`);
} catch (error) {
  console.error(`scripts/page: ${error.message}`);
  process.exit(1);
}
