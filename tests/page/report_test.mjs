// SPDX-License-Identifier: MIT
// The page of a report in a real browser: usage:
// node report_test.mjs FLINCH SOURCE_FOLDER MAKE_LIBRARY FOLDER [SHOTS REPORT_HTML]
// Everything it makes is in FOLDER. MAKE_LIBRARY writes a library with pushes. With SHOTS writes
// pictures of REPORT_HTML into that folder.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { pathToFileURL } from "node:url";

import { openBrowser } from "./in_browser.mjs";

const [program, source, make_library, folder, shots, pictured] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const run = (command, ...parts) =>
  execFileSync(command, parts.map(String), { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
run(program, "author", "--out", "a.flinchlib");
run(program, "simulate", "a.flinchlib", "--out", "a.flinchobs", "-n", 120, "--seed", 1);
run(program, "compare", "a.flinchobs", "--models", "knn,knn_cost,svm", "--report", "report", "--curves", "--transfer");
run(make_library, "p.flinchlib", "pushes");
run(program, "simulate", "p.flinchlib", "--out", "p.flinchobs", "-n", 12);
run(program, "train", "p.flinchobs", "--out", "p.flinch", "--model", "knn");
run(program, "label", "p.flinchlib", "--out", "p.flinchlabels", "--proxy", 120);
run(program, "train-realism", "p.flinchlabels", "--into", "p.flinch", "--report", "realism");
const report = JSON.parse(readFileSync(`${folder}/report/report.json`, "utf8"));
const timing = JSON.parse(readFileSync(`${folder}/report/timing.json`, "utf8"));

const { browser, watch, run: runTests } = await openBrowser(`${source}/viewer`);
async function open(width = 1180, colorScheme = "light", file = `${folder}/report/report.html`) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme });
  const page = watch(await context.newPage());
  await page.goto(pathToFileURL(file).href);
  if (file.endsWith(".html")) await page.locator("section table tbody tr").first().waitFor();
  return page;
}
const page = await open();

const cells = (table) => table.locator("tbody tr").evaluateAll((rows) =>
  rows.map((row) => [...row.children].map((cell) => cell.textContent)));
const number = (value, decimals) => (value === null ? "–" : value.toFixed(decimals).replace("-", "−"));

const tests = {
  async "the tables have the numbers of report.json and timing.json"() {
    const rows = await cells(page.locator("section", { has: page.getByRole("heading", { name: "All selectors" }) }).locator("table"));
    assert.equal(rows.length, report.rows.length);
    report.rows.forEach((row, i) => {
      assert.equal(rows[i][0], row.name);
      const keys = ["accuracy", "top_three", "mean_cost", "mean_damage", "regret"];
      assert.deepEqual(rows[i].slice(1, 6), keys.map((key) => number(row[key], 3)));
      assert.equal(rows[i][6], row.regret_ci.map((end) => number(end, 3)).join(" to "));
      assert.equal(rows[i][7], number(row.protection, 3));
    });
    const times = await cells(page.locator("section", { has: page.getByRole("heading", { name: "Time and size" }) }).locator("table"));
    assert.equal(times.length, report.methods.length);
    for (const [name, median] of times)
      assert.equal(median, number(timing.find((row) => row.name === name).median_us, 1));
  },

  async "a chart stands for each part of the report that has rows, and draws all of them"() {
    const ids = await page.locator("figure").evaluateAll((all) => all.map(({ id }) => id));
    assert.deepEqual(ids, [
      "protection", "regret", "frontier", "groups", "directions", "curves", "noise", "votes",
      "expected_cost", "confusion", "brawn", "prevention", "transfer",
    ]);
    const marks = (id, kind) => page.locator(`#${id} .drawing svg [aria-label="${kind}"] > *`).count();
    assert.equal(await marks("regret", "dot"), report.rows.length - 1);
    const ahead = report.look_ahead.length + report.methods.length;
    assert.equal(await marks("frontier", "dot"), ahead);
    assert.equal(await marks("curves", "dot"), report.curves.length);
    assert.equal(await marks("groups", "cell"), 4 * (report.rows.length - 1));
    const drawn = report.directions.filter((row) => row.name !== "oracle" && row.regret !== null);
    assert.equal(await page.locator("#directions .drawing svg path").count(), drawn.length);
    const filled = await page.locator('#confusion .drawing svg [aria-label="cell"]').last().locator("rect").count();
    assert.equal(filled, report.confusions.filter((row) => row.name === report.methods[0].name).length);
  },

  async "dots and bars stand where their numbers are"() {
    const places = await page.locator('#regret .drawing svg [aria-label="dot"] > *').evaluateAll((dots) =>
      dots.map((dot) => Number(dot.getAttribute("transform").match(/translate\(([^,]+)/)[1])));
    const rows = report.rows.filter((row) => row.name !== "oracle");
    const slope = (places[1] - places[0]) / (rows[1].regret - rows[0].regret);
    rows.forEach((row, i) => {
      const expected = places[0] + slope * (row.regret - rows[0].regret);
      assert.ok(Math.abs(places[i] - expected) < 0.6, `${row.name} at ${places[i]}, not ${expected}`);
    });
  },

  async "the numbers of a chart stand below it, and follow what is picked"() {
    const figure = page.locator("#groups");
    await figure.locator("summary").focus();
    await page.keyboard.press("Enter");
    await figure.locator("tbody tr").first().waitFor();
    for (const group of ["target", "time_to_impact_s"]) {
      await figure.locator("select").selectOption(group);
      const expected = report.groups.filter((row) => row.group === group && row.name !== "oracle");
      const shown = await cells(figure.locator("table"));
      assert.deepEqual(
        shown.map((row) => [row[1], row[3], row[6]]),
        expected.map((row) => [row.value, row.name, number(row.regret, 4)]),
      );
    }
  },

  async "a box takes a selector out of all charts"() {
    const dots = page.locator('#curves .drawing svg [aria-label="dot"] > *');
    const before = await dots.count();
    await page.getByLabel("svm", { exact: true }).focus();
    await page.keyboard.press("Space");
    assert.equal(await dots.count(), before - report.curves.filter((row) => row.name === "svm").length);
    assert.ok(!(await page.locator("#regret .drawing").textContent()).includes("svm"));
    await page.keyboard.press("Space");
    assert.equal(await dots.count(), before);
  },

  async "a column's title sorts by it"() {
    const table = page.locator("section table").first();
    await table.getByRole("button", { name: "regret, N s" }).click();
    const names = (await cells(table)).map(([name]) => name);
    const expected = [...report.rows].sort((a, b) => b.regret - a.regret).map(({ name }) => name);
    assert.deepEqual(names, expected);
  },

  async "pointing at a mark tells its numbers"() {
    await page.locator("#frontier").scrollIntoViewIfNeeded();
    const dot = await page.locator('#frontier .drawing svg [aria-label="dot"] > *').first().boundingBox();
    await page.mouse.move(dot.x + dot.width / 2, dot.y + dot.height / 2);
    await page.waitForFunction(() => /median us/.test(document.querySelector('#frontier [aria-label="tip"]')?.textContent));
  },

  async "it tells what made it"() {
    const text = await page.locator(".origin").textContent();
    for (const part of [report.version, report.library_hash, String(report.cost_model.brawn), "speed", "head 1"])
      assert.ok(text.includes(part), part);
  },

  async "a button saves a chart as the SVG file that scripts/charts writes, the same each time"() {
    const [saved] = await Promise.all([
      page.waitForEvent("download"),
      page.locator("#noise").getByRole("button", { name: "Save SVG" }).click(),
    ]);
    run(`${source}/scripts/charts`, `${folder}/report`);
    run(`${source}/scripts/charts`, `${folder}/report`, `${folder}/again`);
    const names = readdirSync(`${folder}/report/charts`);
    assert.deepEqual(names, readdirSync(`${folder}/again`));
    assert.ok(names.length > 13, names);
    for (const name of names) {
      const text = readFileSync(`${folder}/report/charts/${name}`, "utf8");
      assert.equal(text, readFileSync(`${folder}/again/${name}`, "utf8"));
      assert.match(text, /^<svg [^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/, name);
      assert.doesNotMatch(text, /NaN|undefined|var\(--(?!plot-background)/, name);
    }
    assert.equal(saved.suggestedFilename(), "noise.svg");
    assert.equal(readFileSync(await saved.path(), "utf8"), readFileSync(`${folder}/again/noise.svg`, "utf8"));
    // Alone, where no style applies from outside, it is drawn too.
    const alone = await open(640, "light", `${folder}/again/noise.svg`);
    const { width, height } = await alone.locator("svg").boundingBox();
    assert.equal(width, 640);
    assert.ok(height > 200);
  },

  async "the report of a realism model has its figures, its curves and whose labels they are"() {
    const realism = JSON.parse(readFileSync(`${folder}/realism/report.json`, "utf8"));
    const one = await open(1180, "light", `${folder}/realism/report.html`);
    assert.match(await one.locator("#proxy").textContent(), /proxy .*not of people/);
    assert.match(await one.locator("header").textContent(), new RegExp(`120 labels in ${realism.sittings} sittings`));
    const rows = await cells(one.locator("section table").first());
    assert.deepEqual(rows, [
      ...realism.rows.map((row, i) => [["ours, in the selector", "the paper's"][i], number(row.agreement, 3), number(row.auc, 3)]),
      ["nearest configuration", "–", number(realism.baseline_auc, 3)],
      ["chance", number(realism.chance, 3), "0.500"],
    ]);
    assert.deepEqual(realism.curve.map(({ labels }) => labels), [50, 100, 50, 100]);
    // A dot for each point of both curves, and for the level line.
    for (const id of ["auc", "agreement"])
      assert.equal(await one.locator(`#${id} .drawing svg [aria-label="dot"] > *`).count(), realism.curve.length + 2);
    await one.locator("#auc summary").click();
    await one.locator("#auc tbody tr").first().waitFor();
    const numbers = await cells(one.locator("#auc table"));
    assert.deepEqual(numbers[0].slice(0, 2), ["ours", "50"]);
    const [saved] = await Promise.all([
      one.waitForEvent("download"),
      one.locator("#auc").getByRole("button", { name: "Save SVG" }).click(),
    ]);
    assert.equal(saved.suggestedFilename(), "auc.svg");
    const phone = await open(390, "dark", `${folder}/realism/report.html`);
    assert.equal(await phone.evaluate(() => document.documentElement.scrollWidth), 390);
  },

  async "nothing is wider than a phone, and dark screens get dark charts"() {
    const phone = await open(390);
    assert.equal(await phone.evaluate(() => document.documentElement.scrollWidth), 390);
    const dark = await open(1180, "dark");
    const colour = (one) => one.locator("#regret .drawing svg").evaluate((svg) => svg.style.backgroundColor);
    assert.equal(await colour(page), "rgb(255, 255, 255)");
    assert.equal(await colour(dark), "rgb(30, 36, 45)");
    if (shots) {
      mkdirSync(shots, { recursive: true });
      for (const [name, width, scheme] of [["light", 1180, "light"], ["dark", 1180, "dark"], ["phone", 390, "light"]]) {
        const one = await open(width, scheme, pictured);
        await one.screenshot({ path: `${shots}/report_${name}.jpg`, type: "jpeg", quality: 80 });
      }
    }
  },
};

const failed = await runTests(tests);
await browser.close();
process.exit(failed ? 1 : 0);
