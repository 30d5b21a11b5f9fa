// SPDX-License-Identifier: MIT
// Judging pushed motions on the page, in a real browser: usage:
// node label_test.mjs FLINCH VIEWER_FOLDER MAKE_LIBRARY FOLDER [SHOT]
// MAKE_LIBRARY writes a library with pushes. With SHOT writes a picture there.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

import { openBrowser } from "./in_browser.mjs";

const [program, viewer, make_library, folder, shot] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const flinch = (...parts) =>
  execFileSync(program, parts.map(String), { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
execFileSync(make_library, [`${folder}/a.flinchlib`, "pushes"]);
flinch("simulate", "a.flinchlib", "--out", "a.flinchobs", "-n", 12);
flinch("train", "a.flinchobs", "--out", "a.flinch", "--model", "knn");
flinch("view", "a.flinch", "--out", "page");
const address = pathToFileURL(`${folder}/page/index.html`).href;

const { browser, watch, run } = await openBrowser(viewer);
const context = await browser.newContext({ viewport: { width: 900, height: 560 }, acceptDownloads: true });
let opened = 0;
async function open(view = "label") {
  const page = watch(await context.newPage());
  // Motions are drawn by the time of the sitting.
  await page.clock.setFixedTime(Date.UTC(2026, 0, 1, 12, 0, opened++));
  await page.goto(`${address}#view=${view}`, { waitUntil: "commit" });
  await page.waitForFunction(() => globalThis.flinchPage?.alone);
  return page;
}
const count = async (page) => Number((await page.locator("#labelling").innerText()).match(/(\d+) labels[,.]/)[1]);
async function saved(page) {
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save labels" }).click(),
  ]);
  return readFileSync(await download.path(), "utf8");
}
const openLabels = (page, text, name = "a.flinchlabels") =>
  page.locator("#labelling input[type=file]").setInputFiles({ name, mimeType: "", buffer: Buffer.from(text) });

let page = await open();
const tests = {
  async "nobody answers without a name"() {
    await page.keyboard.press("5");
    assert.match(await page.locator("#message").innerText(), /who judges/);
    assert.equal(await count(page), 0);
    await page.locator("#labelling input[type=text]").fill("Eva");
    await page.locator("canvas").focus();
  },

  async "keys answer, and the motion, its estimate and the labels follow at once"() {
    const motion = () => page.evaluate(() => Array.from(globalThis.flinchPage.alone.frames[20].joints.position));
    const first = await motion();
    assert.match(await page.locator("#labelling").innerText(), /after 11 labels/);
    for (let i = 0; i < 10; ++i) await page.keyboard.press(String(i));
    assert.match(await page.locator("#labelling").innerText(), /after 11 labels/);
    await page.keyboard.press("9");
    assert.equal(await count(page), 11);
    assert.notDeepEqual(await motion(), first);
    assert.match(await page.locator("#labelling output").first().innerText(), /^0\.\d\d$/);
    const text = await saved(page);
    const labels = text.trim().split("\n").slice(1).map((line) => JSON.parse(line));
    assert.deepEqual(labels.map(({ realism }) => Math.round(9 * realism)), [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9]);
    assert.ok(labels.every(({ judge, sitting }) => judge === "Eva" && sitting.startsWith("Eva 20")));
  },

  async "the slider answers, and a skipped motion gets no label"() {
    await page.keyboard.press("s");
    assert.equal(await count(page), 11);
    await page.locator("#labelling .slider input[type=range]").fill("0.37");
    await page.getByRole("button", { name: "Answer" }).click();
    assert.equal(await count(page), 12);
    const last = (await saved(page)).trim().split("\n").at(-1);
    assert.ok(Math.abs(JSON.parse(last).realism - 0.37) < 1e-6, last);
  },

  async "a page that is closed loses no label, and another window adds its own"() {
    const other = await open();
    assert.equal(await count(other), 12);
    await other.locator("canvas").focus();
    await other.keyboard.press("4");
    await page.locator("canvas").focus();
    await page.keyboard.press("6");
    await page.close();
    await other.close();
    page = await open();
    assert.equal(await count(page), 14);
  },

  async "files are merged label by label, and refused in one line where they are not whole"() {
    const text = await saved(page);
    await openLabels(page, text);
    await page.waitForTimeout(200);
    assert.equal(await count(page), 14);
    const lines = text.split("\n");
    const foreign = [lines[0], lines[1].replace("Eva", "Otto"), ""].join("\n");
    await openLabels(page, foreign);
    await page.waitForFunction(() => /15 labels/.test(document.getElementById("labelling").innerText));
    for (const [bad, told] of [
      [text.slice(0, -5), /cut short/],
      [text.replace(/"library":"./, '"library":"x'), /another library/],
      ["HIERARCHY\n", /no label file/],
      [text.replace(/"state":"[^"]*"/, '"state":"nowhere"'), /has no state "nowhere"/],
    ]) {
      await openLabels(page, bad);
      await page.waitForFunction((t) => new RegExp(t).test(document.getElementById("message").textContent), told.source);
      assert.equal(await count(page), 15);
    }
  },

  async "the program reads what the page has saved"() {
    const text = await saved(page);
    writeFileSync(`${folder}/page.flinchlabels`, text);
    const trained = JSON.parse(flinch("train-realism", "page.flinchlabels", "--into", "a.flinch", "--json"));
    assert.equal(trained.labels, 15);
    assert.equal(trained.judge, "people");
    assert.equal(trained.sittings, 2); // the page closed after the first; Otto's label is of its time
  },

  async "the test asks whether a motion is a recording, and the program prints its table"() {
    flinch("label", "a.flinchlib", "--out", "a.flinchlabels", "--proxy", 60);
    flinch("train-realism", "a.flinchlabels", "--into", "a.flinch");
    flinch("view", "a.flinch", "--out", "page");
    const other = await open("study");
    await other.locator("canvas").focus();
    // So many that a recording comes twice and gets the same answer: both count.
    const keys = [..."ynuynyynunyy", ..."y".repeat(24)];
    for (const key of keys) await other.keyboard.press(key);
    await other.waitForFunction((n) => document.getElementById("study").innerText.includes(`${n} answers`), keys.length);
    const [download] = await Promise.all([
      other.waitForEvent("download"),
      other.getByRole("button", { name: "Save answers" }).click(),
    ]);
    writeFileSync(`${folder}/a.flinchstudy`, readFileSync(await download.path()));
    await other.close();
    const study = JSON.parse(flinch("label", "a.flinchlib", "--study", "a.flinchstudy", "--json"));
    const sum = (key) => study.rows.reduce((total, row) => total + row[key], 0);
    assert.deepEqual([sum("yes"), sum("unsure"), sum("no")], [30, 2, 4]);
    assert.equal(study.judges, 1);
    assert.match(flinch("label", "a.flinchlib", "--study", "a.flinchstudy"), /recordings as they are/);
  },

  async "it says when estimate and judge agree"() {
    // A judge who goes by the size of the deformation alone.
    await page.locator("canvas").focus();
    const begin_ms = performance.now();
    const { answers, text } = await page.evaluate(async () => {
      const state = document.querySelector("#labelling [role=status]");
      let answers = 0;
      for (; answers < 400 && !/agree: you may stop/.test(state.textContent); ++answers) {
        const { deformation } = globalThis.flinchPage.alone.labelling.example();
        const key = Math.hypot(...deformation) < 0.8 ? "9" : "0";
        dispatchEvent(new KeyboardEvent("keydown", { key }));
      }
      return { answers, text: state.textContent };
    });
    console.log(`  ${answers} answers: ${text} (${((performance.now() - begin_ms) / answers).toFixed(0)} ms each)`);
    assert.match(text, /agree: you may stop/);
    assert.ok(answers >= 50);
    if (shot) {
      await page.locator("#message").click(); // of the files that were refused
      await page.evaluate(() => {
        globalThis.flinchPage.player.pause();
        globalThis.flinchPage.player.seek(0.3);
      });
      await page.waitForTimeout(300);
      await page.screenshot({ path: shot, type: "jpeg", quality: 85 });
    }
  },
};

const failed = await run(tests);
await browser.close();
process.exit(failed ? 1 : 0);
