// SPDX-License-Identifier: MIT
// Every kind of threat at characters in every stance, on the page in a real browser: usage:
//     node threats_test.mjs FLINCH VIEWER_FOLDER SELECTOR_WITH_STANCES FOLDER [SHOT.jpg]
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, rmSync } from "node:fs";
import { pathToFileURL } from "node:url";

import { openBrowser } from "./in_browser.mjs";

const [program, viewer, moving, folder, shot] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const flinch = (...parts) => execFileSync(program, parts.map(String), { cwd: folder, stdio: ["ignore", "pipe", "pipe"] });
flinch("author", "--out", "a.flinchlib");
flinch("simulate", "a.flinchlib", "--out", "kinds.flinchobs", "-n", 60, "--threats", "kinds");
flinch("train", "kinds.flinchobs", "--out", "kinds.flinch", "--model", "knn");

const { browser, watch, run } = await openBrowser(viewer);
async function open(selector, hash) {
  const name = /(\w+)\.flinch$/.exec(selector)[1];
  flinch("view", selector, "--out", name);
  const page = watch(await browser.newPage({ viewport: { width: 740, height: 600 } }));
  await page.goto(`${pathToFileURL(`${folder}/${name}/index.html`).href}${hash}`, { waitUntil: "commit" });
  await page.waitForFunction(() => globalThis.flinchPage?.takes.length > 0);
  return page;
}
const options = (list) => list.locator("option").allTextContents();

const kThrow = "#view=one&from=30,1.6&aim=0,0,1.1&ball=14,0.55,0.105,0.27";
const tests = {
  async "every kind can be chosen, hits, and is of its size"() {
    const page = await open("kinds.flinch", kThrow);
    const list = page.getByLabel("Kind of threat");
    const names = await options(list);
    assert.equal(names.length, 9);
    for (const [kind, name] of names.entries()) {
      await list.selectOption(name);
      const { threat, contact_s, shown } = await page.evaluate(() => {
        const [take] = globalThis.flinchPage.takes;
        take.at(0.3);
        const { library } = take.chooser.selector;
        return {
          threat: { kind: take.threat.kind, radius: take.threat.radius },
          contact_s: take.contact_s_at_rest,
          shown: library.kinds[take.threat.kind],
        };
      });
      assert.equal(threat.kind, kind);
      assert.equal(shown.name.replaceAll("_", " "), name);
      assert.ok(threat.radius >= shown.radius[0] - 1e-6 && threat.radius <= shown.radius[1] + 1e-6, name);
      assert.ok(contact_s > 0.3 && contact_s < 0.65, `${name} hits after ${contact_s} s`);
      assert.match(page.url(), /ball=/);
    }
    await page.close();
  },

  async "a character in any stance is at the origin at the impact, and is hit there"() {
    const page = await open(moving, kThrow);
    const list = page.getByLabel("Stance");
    assert.deepEqual(await options(list), ["idle", "guard", "walk"]);
    const idler = await page.evaluate(() => globalThis.flinchPage.choosers.findIndex(({ kind }) => kind === "idle"));
    await page.getByLabel("Who answers").selectOption({ index: idler });
    for (const [stance, name] of (await options(list)).entries()) {
      await list.selectOption(name);
      const { contact_s, pelvis } = await page.evaluate(() => {
        const [take] = globalThis.flinchPage.takes;
        take.at(0.5);
        return {
          contact_s: take.trial.contact_s,
          pelvis: take.frames.map(({ joints }) => Array.from(joints.position.slice(0, 2))),
        };
      });
      const from = Math.hypot(...pelvis[0]);
      const at_impact = Math.hypot(...pelvis[Math.floor(60 * (contact_s - 0.1))]);
      if (name === "walk") assert.ok(from > 0.35 && pelvis[0][0] < 0, `it starts ${pelvis[0]}`);
      else assert.ok(from < 0.1, `${name} starts ${from} m away`);
      assert.ok(at_impact < 0.2, `${name} is ${at_impact} m away at the impact`);
      assert.ok(Math.abs(contact_s - 0.55) < 0.06, `${name} is hit after ${contact_s} s`);
      await page.waitForFunction((part) => location.hash.includes(part), `stance=${stance}`);
    }
    if (shot) await page.screenshot({ path: shot, type: "jpeg", quality: 85 });
    await page.close();
  },

  async "the oracle answers from the stance that is shown"() {
    const page = await open(moving, `${kThrow.replace("one", "compare")}&stance=2&brawn=0`);
    const found = await page.waitForFunction(() => {
      const take = globalThis.flinchPage.takes.find(({ chooser }) => chooser.kind === "oracle");
      const { library, oracle } = take.chooser.selector;
      if (take.clip === library.info.idle_clip) return null; // the worker has not answered yet
      const { threat, delay, time } = take.conditions;
      // The clip of least damage for a character that comes to the origin; within 1 % of it, less work.
      const bestFrom = (stance) => {
        const character = library.createCharacter();
        character.place(0, 0, 0, 0, stance);
        const from = character.pose().root_position;
        character.update(time);
        const to = character.pose().root_position;
        character.place(from[0] - to[0], from[1] - to[1], 0, 0, stance);
        const exact = { bearing_noise: 0, distance_noise: 0, heading_noise: 0, speed_noise: 0, chance_to_fail: 0 };
        character.limitPerception({ reaction_delay_s: delay, ...exact });
        const { trials } = oracle.tryAll(character, threat);
        character.free();
        const least = Math.min(...trials.map(({ damage_ns }) => damage_ns));
        const near = trials.filter(({ damage_ns }) => damage_ns <= 1.01 * least);
        return near.reduce((best, trial) => (trial.work_j < best.work_j ? trial : best)).clip;
      };
      return { chosen: take.clip, walking: bestFrom(2), idle: bestFrom(0) };
    });
    const { chosen, walking, idle } = await found.jsonValue();
    assert.equal(chosen, walking);
    assert.notEqual(walking, idle, "this throw does not tell the stances apart");
    await page.close();
  },

  async "a link to a stance that there is not shows the last"() {
    const page = await open(moving, `${kThrow}&stance=77`);
    assert.equal(await page.evaluate(() => globalThis.flinchPage.view.stance), 2);
    await page.close();
  },
};

const failed = await run(tests);
await browser.close();
process.exit(failed ? 1 : 0);
