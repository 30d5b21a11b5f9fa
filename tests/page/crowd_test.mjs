// SPDX-License-Identifier: MIT
// Twenty characters that push each other on the page, in a real browser: usage:
//     node crowd_test.mjs FLINCH VIEWER_FOLDER MAKE_LIBRARY CROWD FOLDER [SHOT.jpg]
// MAKE_LIBRARY writes a library with pushes and walks, CROWD is examples/crowd.cpp. With SHOT writes a
// picture there.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, rmSync } from "node:fs";
import { pathToFileURL } from "node:url";

import { openBrowser } from "./in_browser.mjs";

const [program, viewer, make_library, crowd, folder, shot] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const execute = (file, ...parts) =>
  execFileSync(file, parts.map(String), { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
const flinch = (...parts) => execute(program, ...parts);
execute(make_library, `${folder}/a.flinchlib`, "walks");
flinch("simulate", "a.flinchlib", "--out", "a.flinchobs", "-n", 12);
flinch("train", "a.flinchobs", "--out", "a.flinch", "--model", "knn");
copyFileSync(`${folder}/a.flinch`, `${folder}/unlabelled.flinch`);
flinch("label", "a.flinchlib", "--out", "a.flinchlabels", "--proxy", 150);
flinch("train-realism", "a.flinchlabels", "--into", "a.flinch");

const { browser, watch, run } = await openBrowser(viewer);
async function open(name, hash) {
  flinch("view", `${name}.flinch`, "--out", name);
  const page = watch(await browser.newPage({ viewport: { width: 760, height: 300 } }));
  await page.goto(`${pathToFileURL(`${folder}/${name}/index.html`).href}${hash}`, { waitUntil: "commit" });
  await page.waitForFunction(() => globalThis.flinchPage?.selectors.length > 0);
  return page;
}
const page = await open("a", "#view=crowd&seed=3");
await page.waitForFunction(() => globalThis.flinchPage.alone);

/** A minute of the crowd of a seed, simulated anew in the page: a hash of all of its numbers. */
const minute = (seed) =>
  page.evaluate((of) => {
    const { alone } = globalThis.flinchPage;
    const crowd = new alone.constructor(alone.library, of);
    const begin_ms = performance.now();
    crowd.at(60);
    const took_ms = performance.now() - begin_ms;
    let [hash, count, finite] = [0x811c9dc5, 0, true];
    for (const { joints } of crowd.frames)
      for (const numbers of [joints.position, joints.orientation]) {
        const bits = new Uint32Array(numbers.buffer, numbers.byteOffset, numbers.length);
        for (let i = 0; i < bits.length; ++i) {
          hash = Math.imul(hash ^ bits[i], 0x01000193);
          finite &&= Number.isFinite(numbers[i]);
        }
        count += bits.length;
      }
    const { bumps, walls, answered, physical, half_side_m } = crowd.stateAt(60);
    const farthest_m = Math.max(
      ...crowd.frames.flatMap(({ joints }) =>
        Array.from({ length: 20 }, (_, i) => Math.max(...[0, 1].map((k) => Math.abs(joints.position[63 * i + k])))),
      ),
    );
    crowd.free();
    return { hash, count, finite, bumps, walls, answered, physical, outside_m: farthest_m - half_side_m, took_ms };
  }, seed);

const tests = {
  async "a minute has the same bits twice, another seed others, and every number is finite"() {
    const { took_ms, ...first } = await minute(3);
    const { took_ms: again_ms, ...again } = await minute(3);
    assert.deepEqual(again, first);
    const { hash } = await minute(4);
    assert.notEqual(hash, first.hash);
    assert.equal(first.finite, true);
    assert.equal(first.count, 3602 * 20 * 21 * 7);
    assert.ok(first.bumps > 20 && first.walls > 0, JSON.stringify(first));
    assert.ok(first.answered > 20 && first.physical > 0, JSON.stringify(first));
    assert.ok(first.outside_m < 0.6, `${first.outside_m} m outside`);
    console.log(`  60 s take ${Math.min(took_ms, again_ms).toFixed(0)} ms to simulate; ${JSON.stringify(first)}`);
  },

  async "it is the crowd that the example records"() {
    await page.evaluate(() => {
      location.hash = "#view=crowd&seed=1&t=5";
    });
    await page.waitForFunction(() => globalThis.flinchPage.alone.seed === 1);
    const own = await page.evaluate(() => globalThis.flinchPage.alone.stateAt(5));
    const said = execute(crowd, `${folder}/a.flinch`, `${folder}/crowd.glb`, 5);
    const [bumps, walls] = said.match(/(\d+) bumps, (\d+) touches/).slice(1).map(Number);
    const [answered, physical] = said.match(/(\d+) pushes answered, (\d+) by physics/).slice(1).map(Number);
    assert.ok(bumps > 0);
    assert.deepEqual([own.bumps, own.walls, own.answered, own.physical], [bumps, walls, answered, physical]);
    assert.match(await page.locator("#captions").innerText(), new RegExp(`Crowd 1\\n+${bumps} bumps, ${walls} touches`));
  },

  async "every push has an arrow at who is pushed, the way of the push, for half a second"() {
    const seen = await page.evaluate(async () => {
      const { alone, player, crowdFigures } = globalThis.flinchPage;
      player.pause();
      alone.at(20);
      const frames = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      const result = [];
      for (const push of alone.pushes.slice(0, 12)) {
        player.seek(push.time + 0.1);
        await frames();
        const shown = alone.pushesAt(player.time);
        const arrows = crowdFigures.mesh.children.find(({ isInstancedMesh }) => isInstancedMesh);
        const matrix = Array.from(arrows.instanceMatrix.array.slice(16 * shown.findIndex((one) => one.push === push)));
        const chest = alone.library.flinch.joints.indexOf("chest");
        const { joints } = alone.frames[Math.round(60 * push.time)];
        const at = 63 * push.character + 3 * chest;
        result.push({
          count: [crowdFigures.arrowCount, shown.length],
          along: [matrix[0], matrix[1]],
          from: [matrix[12], matrix[13]],
          velocity: Array.from(push.velocity),
          chest: [joints.position[at], joints.position[at + 1]],
        });
      }
      player.seek(alone.pushes[0].time - 0.02);
      await frames();
      return { result, before: crowdFigures.arrowCount };
    });
    assert.equal(seen.before, 0);
    assert.equal(seen.result.length, 12);
    for (const { count, along, from, velocity, chest } of seen.result) {
      assert.ok(count[0] > 0);
      assert.equal(count[0], count[1]);
      const cosine = (along[0] * velocity[0] + along[1] * velocity[1]) / (Math.hypot(...along) * Math.hypot(...velocity));
      assert.ok(cosine > 0.999, `the arrow's direction is off: cosine ${cosine}`);
      const away = Math.hypot(from[0] - chest[0], from[1] - chest[1]);
      assert.ok(away > 0.1 && away < 0.35, `the arrow begins ${away} m from the chest`);
    }
  },

  async "another crowd has a seed of its own, and its link shows it again"() {
    const first = await page.evaluate(() => globalThis.flinchPage.alone.seed);
    await page.getByRole("button", { name: "Another crowd" }).click();
    await page.waitForFunction((seed) => globalThis.flinchPage.alone.seed !== seed, first);
    await page.waitForFunction((seed) => location.hash.includes(`seed=${seed + 1}`), first);
    assert.ok(await page.evaluate(() => globalThis.flinchPage.player.isPlaying));
  },

  async "a crowd is seen from farther away, and who goes back sees one figure as before"() {
    const distance = () => page.evaluate(() => globalThis.flinchPage.view.camera[2]);
    assert.ok((await distance()) > 10);
    await page.locator("#modes").getByRole("button", { name: "Throw" }).click();
    assert.ok((await distance()) < 5);
    await page.locator("#modes").getByRole("button", { name: "Crowd" }).click();
    assert.ok((await distance()) > 10);
  },

  async "script takes at most 8 ms of CPU a frame"() {
    const session = await page.context().newCDPSession(page);
    await session.send("Performance.enable", { timeDomain: "threadTicks" });
    const cpu_ms = async () =>
      1000 * (await session.send("Performance.getMetrics")).metrics.find(({ name }) => name === "ScriptDuration").value;
    const play = (count) =>
      page.evaluate(async (n) => {
        const { player, frame_ms } = globalThis.flinchPage;
        player.start();
        frame_ms.length = 0;
        while (frame_ms.length < n) await new Promise((done) => setTimeout(done, 50));
        player.pause(); // drawing in software holds up the other tests
        return frame_ms.length;
      }, count);
    await play(4); // compiles what the others run
    const before_ms = await cpu_ms();
    const frames = await play(16);
    const each_ms = ((await cpu_ms()) - before_ms) / frames;
    console.log(`  script of twenty: ${each_ms.toFixed(2)} ms of CPU a frame (mean of ${frames})`);
    assert.ok(each_ms <= 8, `${each_ms} ms`);
  },

  async "without recorded pushes, or without their realism, one line says what is missing and what makes it"() {
    execute(make_library, `${folder}/still.flinchlib`);
    flinch("simulate", "still.flinchlib", "--out", "still.flinchobs", "-n", 12);
    flinch("train", "still.flinchobs", "--out", "still.flinch", "--model", "knn");
    for (const name of ["still", "unlabelled"]) {
      const other = await open(name, "");
      await other.locator("#modes").getByRole("button", { name: "Crowd" }).click();
      const said = await other.locator("#message").innerText();
      assert.match(said, /no recorded pushes, or no realism model for them; flinch import, label and train-realism/);
      await other.locator("#modes").getByRole("button", { name: "Throw" }).click(); // which goes on
      await other.waitForFunction(() => globalThis.flinchPage.takes.length > 0);
      await other.close();
    }
  },
};

const failed = await run(tests);
if (shot) {
  await page.setViewportSize({ width: 1000, height: 600 });
  await page.evaluate(() => {
    location.hash = "#view=crowd&seed=3";
  });
  await page.waitForFunction(() => globalThis.flinchPage.alone.seed === 3);
  await page.evaluate(() => {
    const { alone, player } = globalThis.flinchPage;
    alone.at(40); // the moment with the most arrows
    const times = alone.pushes.map(({ time }) => time + 0.15);
    player.seek(times.reduce((a, b) => (alone.pushesAt(b).length > alone.pushesAt(a).length ? b : a)));
  });
  await page.waitForTimeout(1500);
  await page.screenshot({ path: shot, type: "jpeg", quality: 85 });
}
await browser.close();
process.exit(failed ? 1 : 0);
