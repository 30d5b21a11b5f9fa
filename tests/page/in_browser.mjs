// SPDX-License-Identifier: MIT
// What the tests of pages in a real browser share.
import assert from "node:assert/strict";
import { createRequire } from "node:module";

/** Debian's Chromium, which draws in software, and what its pages complain of. VIEWER is the folder
 * of the page's sources, whose packages have been installed. */
export async function openBrowser(viewer) {
  const { chromium } = createRequire(`${viewer}/package.json`)("playwright-core");
  const browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
  const complaints = [];
  return {
    browser,
    /** Collects the errors of a page of this browser, and gives it time on a loaded machine. */
    watch(page) {
      page.setDefaultTimeout(90000);
      page.on("console", (message) => {
        if (message.type() === "error") complaints.push(message.text());
      });
      page.on("pageerror", (error) => complaints.push(String(error)));
      return page;
    },
    /** Runs the functions of an object in turn, each a test with its name. A test fails that throws,
     * or while which a page complains. Returns how many failed. */
    async run(tests) {
      let failed = 0;
      for (const [name, test] of Object.entries(tests)) {
        const begin = performance.now();
        try {
          await test();
          assert.deepEqual(complaints, [], "the console has errors");
          console.log(`ok      ${name} (${((performance.now() - begin) / 1000).toFixed(1)} s)`);
        } catch (error) {
          ++failed;
          console.log([`FAILED  ${name}`, error.stack, ...complaints].join("\n"));
        }
        complaints.length = 0;
      }
      console.log(`${Object.keys(tests).length} tests, ${failed} failed`);
      return failed;
    },
  };
}
