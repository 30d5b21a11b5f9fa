// SPDX-License-Identifier: MIT
// The page in a real browser: usage:
//     node page_test.mjs FLINCH VIEWER_FOLDER PACKAGE SELECTOR [SHOTS SHOWN_SELECTOR...]
// FLINCH is the program, which writes the page with SELECTOR. With SHOTS writes pictures of all views, of
// a page with the SHOWN_SELECTORs, into that folder. Drawing is done in software here, so frames are small
// and few.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync } from "node:fs";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";

import { openBrowser } from "./in_browser.mjs";

const [program, viewer, packageFolder, selector_file, shots, ...shown_selectors] = process.argv.slice(2);
const { loadFlinch } = await import(pathToFileURL(`${packageFolder}/flinch.js`));
const selector = await readFile(selector_file);
const folder = await mkdtemp(`${tmpdir()}/flinch-page-`);
const page_file = `${folder}/index.html`;
execFileSync(program, ["view", selector_file, "--out", folder]);
const address = pathToFileURL(page_file).href;

const { browser, watch, run } = await openBrowser(viewer);

async function open(where) {
  const context = await browser.newContext({ viewport: { width: 740, height: 340 } });
  const made = watch(await context.newPage());
  const session = await context.newCDPSession(made);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  /** CPU time of the page's thread so far: in all (TaskDuration), or in scripts (ScriptDuration). */
  made.cpu_ms = async (wanted) =>
    1000 * (await session.send("Performance.getMetrics")).metrics.find(({ name }) => name === wanted).value;
  await made.goto(where, { waitUntil: "commit" });
  await made.waitForFunction(() => globalThis.flinchPage?.takes.length > 0);
  return made;
}
const begin_ms = performance.now();
const page = await open(address);
const load_ms = performance.now() - begin_ms;
console.log(`the page loads in ${load_ms.toFixed(0)} ms, of which its thread computes ${(await page.cpu_ms("TaskDuration")).toFixed(0)} ms`);

/** Follows a link to a view within a page. */
async function show(hash, shown = page) {
  await shown.evaluate((link) => {
    history.replaceState(null, "", "#");
    location.hash = link;
  }, hash);
  await shown.evaluate(frames);
}
const frames = () =>
  new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50))));
/** What a frame of the playback costs in script: by the clock, which also counts what else the machine
 * does (here it draws in software), and as CPU time of the page's thread, which must be within
 * `most_ms`. */
async function scriptPerFrame(what, count, most_ms) {
  const play = (count) =>
    page.evaluate(async (n) => {
      const { player, frame_ms } = globalThis.flinchPage;
      player.start();
      frame_ms.length = 0;
      while (frame_ms.length < n) {
        if (!player.isPlaying) player.start();
        await new Promise((done) => setTimeout(done, 50));
      }
      player.pause();
      return [...frame_ms];
    }, count);
  await play(count >> 2); // compiles what the others run
  const before_ms = await page.cpu_ms("ScriptDuration");
  const by_clock_ms = await play(count);
  const cpu_ms = ((await page.cpu_ms("ScriptDuration")) - before_ms) / by_clock_ms.length;
  console.log(`  script of ${what}: ${median(by_clock_ms).toFixed(2)} ms a frame by the clock (median), ${cpu_ms.toFixed(2)} ms of CPU (mean)`);
  assert.ok(cpu_ms <= most_ms, `${what} take ${cpu_ms} ms a frame, more than ${most_ms}`);
}
/** The number of the first chooser of a kind. */
const chooser = (wanted) =>
  page.evaluate((name) => globalThis.flinchPage.choosers.findIndex(({ kind }) => kind === name), wanted);
const throwNow = () => page.locator("#panel").getByRole("button", { name: "Throw", exact: true }).click();
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

const kThrow = "#view=one&from=30,1.6&aim=0.05,0.02,1.5&ball=14,0.55,0.105,0.27";
const tests = {
  async "a throw plays, and the head is where the native library has it"() {
    await show(kThrow);
    await throwNow();
    await page.waitForFunction(() => globalThis.flinchPage.player.time > 0.2);
    await page.evaluate(() => globalThis.flinchPage.player.pause());
    // The same in Node, whose results equal the native library's (js.throws).
    const flinch = await loadFlinch();
    const library = flinch.load(selector);
    const { clip, contact_s, threat, heads } = await page.evaluate(() => {
      const [take] = globalThis.flinchPage.takes;
      take.at(0.5);
      return {
        clip: take.clip,
        contact_s: take.trial.contact_s,
        threat: JSON.parse(JSON.stringify(take.threat)),
        heads: take.frames.map(({ joints }) => Array.from(joints.position)),
      };
    });
    const character = library.createCharacter();
    assert.equal(character.perceive(threat), "ok");
    assert.equal(character.candidates()[0].clip, clip);
    const head = flinch.joints.indexOf("head");
    let compared = 0;
    for (let frame = 0; frame < heads.length && frame / 60 < contact_s - 0.1; ++frame) {
      const expected = character.jointFrames().position.slice(3 * head, 3 * head + 3);
      for (let i = 0; i < 3; ++i)
        assert.ok(Math.abs(heads[frame][3 * head + i] - expected[i]) < 1e-3, `frame ${frame}`);
      character.update(1 / 60);
      ++compared;
    }
    assert.ok(compared > 15, `compared ${compared} frames`);
  },

  async "scrubbing back and forth shows the same"() {
    await show(kThrow);
    // Read in the same task, as the browser keeps no picture that it has shown.
    const picture = (time) =>
      page.evaluate((t) => {
        const { player, stage } = globalThis.flinchPage;
        player.seek(t);
        stage.draw(player.time);
        return stage.canvas.toDataURL();
      }, time);
    const first = await picture(0.6);
    assert.ok((await picture(2.4)) !== first, "other times look alike");
    assert.ok((await picture(0.6)) === first, "the same time looks otherwise");
  },

  async "the trail is the way of the ball so far, wherever one scrubs"() {
    await show(kThrow);
    for (const time of [0.3, 0.95, 0.5, 1.2]) {
      const { shown, expected } = await page.evaluate((t) => {
        const { stage, takes, player } = globalThis.flinchPage;
        player.seek(t);
        stage.draw(t);
        const { geometry } = stage.trails[0].line;
        const [take] = takes;
        const way = take.frames.slice(0, Math.floor(t * 60) + 1).flatMap(({ balls }) => balls[0].position);
        const { from, to, share } = take.at(t);
        const [a, b] = [from, to].map(({ balls }) => balls[0].position);
        const end = a.map((value, i) => value + share * (b[i] - value));
        const { count } = geometry.drawRange;
        return {
          shown: Array.from(geometry.attributes.position.array.slice(0, 3 * count)),
          expected: [...way, ...end],
        };
      }, time);
      assert.equal(shown.length, expected.length, `at ${time} s`);
      shown.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < 1e-5, `number ${i} at ${time} s`));
    }
  },

  async "the predicted contact is where the ball comes to"() {
    await show(kThrow);
    await page.getByLabel("predicted contact").check();
    await page.evaluate(frames);
    const joint = (await loadFlinch()).joints.indexOf("head");
    const { centre, extrapolated, head, lines } = await page.evaluate((joint) => {
      const { stage, takes } = globalThis.flinchPage;
      const { children } = stage.overlay;
      const points = children.at(-1).geometry.attributes.position.array;
      const centre = [0, 1, 2].map((axis) => {
        const values = Array.from(points).filter((_, i) => i % 3 === axis);
        return (Math.max(...values) + Math.min(...values)) / 2;
      });
      // The parabola through three places of the ball in free flight.
      const [take] = takes;
      take.at(0.4);
      const t = 60 * take.contact_s_at_rest;
      const [a, b, c] = [4, 14, 24];
      const shares = [
        ((t - b) * (t - c)) / ((a - b) * (a - c)),
        ((t - a) * (t - c)) / ((b - a) * (b - c)),
        ((t - a) * (t - b)) / ((c - a) * (c - b)),
      ];
      const places = [a, b, c].map((frame) => take.frames[frame].balls[0].position);
      const extrapolated = [0, 1, 2].map((i) => shares.reduce((sum, share, k) => sum + share * places[k][i], 0));
      // The skin of the standing figure's head, about its joint.
      const head = take.frames[0].joints.position.slice(3 * joint, 3 * joint + 3);
      return { centre, extrapolated, head: Array.from(head), lines: children.length };
    }, joint);
    await page.getByLabel("predicted contact").uncheck();
    assert.equal(lines, 4); // support, weight, and two circles of the ball
    centre.forEach((value, i) => assert.ok(Math.abs(value - extrapolated[i]) < 2e-3, `${centre} for ${extrapolated}`));
    const gap = Math.hypot(...centre.map((value, i) => value - head[i]));
    assert.ok(gap > 0.14 && gap < 0.26, `the ball's centre is ${gap} m from the head's joint`);
  },

  async "a link reproduces what is shown"() {
    await show(kThrow);
    await page.getByRole("button", { name: "Random throw" }).click();
    await page.waitForFunction(() => globalThis.flinchPage.player.time > 0.1);
    await page.evaluate(() => {
      globalThis.flinchPage.player.pause();
      globalThis.flinchPage.set({ camera: [-70, 20, 4], delay: 0.1 });
      globalThis.flinchPage.player.seek(0.55);
    });
    await page.waitForTimeout(300);
    const state = () => {
      const { view, takes } = globalThis.flinchPage;
      return [view, takes[0].clip, Array.from(takes[0].at(view.time).from.balls[0].position)];
    };
    const shown = await page.evaluate(state);
    const other = await open(page.url());
    const reproduced = await other.evaluate(state);
    await other.context().close();
    const numbers = (value) => JSON.stringify(value).match(/-?\d+(\.\d+)?(e-?\d+)?/g).map(Number);
    const words = (value) => JSON.stringify(value).replace(/[-\d.e]+/g, "#");
    assert.equal(words(reproduced), words(shown));
    const [a, b] = [numbers(reproduced), numbers(shown)];
    a.forEach((number, i) => assert.ok(Math.abs(number - b[i]) < 0.01, `${number} for ${b[i]}`));
  },

  async "absurd links are shown as the nearest possible"() {
    await show("#view=x&from=1e99,NaN&aim=a,b,c&ball=-5,1e9,Infinity,&who=99&t=-3&camera=1,,9e9&brawn=7");
    const view = await page.evaluate(() => globalThis.flinchPage.view);
    assert.equal(view.mode, "one");
    assert.equal(view.thrown.speed, 3);
    assert.equal(view.thrown.time, 1.5);
    assert.equal(view.thrown.mass, 0.27);
    assert.equal(view.camera[2], 15);
    assert.equal(view.brawn, 1);
  },

  async "a damaged selector gives its message, and the page lives on"() {
    await show(kThrow);
    const damaged = Buffer.from(selector);
    damaged[damaged.length >> 1] ^= 1;
    const newer = Buffer.from(selector);
    ++newer[7]; // the version
    for (const [buffer, text] of [
      [damaged, /damaged/],
      [newer, /another version/],
      [selector.subarray(0, 1000), /cut short/],
      [Buffer.from("HIERARCHY"), /not a selector/],
    ]) {
      await page.locator('input[accept=".flinch"]').setInputFiles({ name: "bad.flinch", mimeType: "", buffer });
      await page.waitForFunction((t) => new RegExp(t).test(document.getElementById("message").textContent), text.source);
    }
    // Dropped onto the page, here one that is too large.
    await page.evaluate(() => {
      const dropped = new DataTransfer();
      dropped.items.add(new File([new Uint8Array(64 * 1024 * 1024 + 1)], "large.flinch"));
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: dropped, bubbles: true }));
    });
    await page.waitForFunction(() => document.getElementById("message").textContent === "large.flinch is larger than 64 MiB.");
    const before = await page.evaluate(() => globalThis.flinchPage.choosers.length);
    await page.locator('input[accept=".flinch"]').setInputFiles({ name: "again.flinch", mimeType: "", buffer: selector });
    await page.waitForFunction((n) => globalThis.flinchPage.choosers.length > n, before);
  },

  async "compare shows six figures in step, the oracle is never beaten, and script takes at most 8 ms a frame"() {
    await show(kThrow.replace("view=one", "view=compare"));
    await page.waitForFunction(() => globalThis.flinchPage.service.took_ms.length > 0);
    const shown = await page.evaluate(() =>
      globalThis.flinchPage.takes.map(({ chooser, trial }) => [chooser.kind, trial.cost_ns]));
    assert.equal(shown.length, 6);
    assert.equal(await page.locator(".caption").count(), 6);
    const oracle = shown.find(([kind]) => kind === "oracle")[1];
    for (const [kind, cost] of shown) assert.ok(cost >= oracle * 0.989, `${kind} beats the oracle`);
    await page.getByRole("button", { name: "Next disagreement" }).click();
    await page.waitForFunction(() => globalThis.flinchPage.player.time > 0.3);
    for (let i = 0; i < 4; ++i) {
      await page.evaluate(() => globalThis.flinchPage.throwRandom());
      await page.waitForTimeout(300);
    }
    const took = await page.evaluate(() => globalThis.flinchPage.service.took_ms);
    console.log(`  oracle ${median(took).toFixed(0)} ms a throw (median of ${took.length})`);
    await show(kThrow.replace("view=one", "view=compare"));
    await scriptPerFrame("six figures", 16, 8);
  },

  async "release to first moving frame; script of one figure takes at most 2 ms a frame"() {
    await show(kThrow);
    const times = await page.evaluate(async () => {
      const app = globalThis.flinchPage;
      const figures = { selector: 0, ahead: app.choosers.findIndex(({ kind }) => kind === "ahead") };
      const result = {};
      for (const [name, figure] of Object.entries(figures)) {
        const all = [];
        for (let i = 0; i < 12; ++i) {
          app.view.figure = figure;
          const begin = performance.now();
          app.throwRandom();
          app.takes[0].at(1 / 60);
          all.push(performance.now() - begin);
        }
        result[name] = all.sort((a, b) => a - b)[6];
      }
      return result;
    });
    console.log(`  release to first frame: selector ${times.selector.toFixed(0)} ms, look-ahead ${times.ahead.toFixed(0)} ms`);
    // One that is hit, so that physics and the glow are in it.
    await show(`${kThrow}&who=${await chooser("idle")}`);
    await scriptPerFrame("one figure", 36, 2);
  },

  async "dragging on the figure aims and throws"() {
    await show(kThrow);
    const box = await page.locator("#canvas").boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 120, y + 30, { steps: 5 });
    await page.mouse.up();
    await page.waitForFunction(() => globalThis.flinchPage.player.isPlaying);
    const { thrown, camera } = await page.evaluate(() => globalThis.flinchPage.view);
    assert.ok(Math.abs(thrown.azimuth - 30) > 5, "the drag changes where the ball comes from");
    assert.equal(camera[0], 35, "a drag on the figure does not turn the view");
    await page.mouse.move(box.x + 40, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 90, box.y + 200, { steps: 3 });
    await page.mouse.up();
    assert.notEqual(await page.evaluate(() => globalThis.flinchPage.view.camera[0]), 35);
  },

  async "the keyboard plays, pauses and scrubs"() {
    await show(kThrow);
    await page.locator("#canvas").focus();
    await page.keyboard.press("t");
    await page.waitForFunction(() => globalThis.flinchPage.player.time > 0.1);
    await page.keyboard.press(" ");
    const at = await page.evaluate(() => [globalThis.flinchPage.player.isPlaying, globalThis.flinchPage.player.time]);
    assert.equal(at[0], false);
    await page.keyboard.press("ArrowRight");
    assert.ok((await page.evaluate(() => globalThis.flinchPage.player.time)) > at[1]);
  },

  async "reduced motion: a throw shows its impact and waits"() {
    await page.emulateMedia({ reducedMotion: "reduce" });
    await show(kThrow);
    await throwNow();
    assert.equal(await page.evaluate(() => globalThis.flinchPage.player.isPlaying), false);
    assert.ok((await page.evaluate(() => globalThis.flinchPage.player.time)) > 0.4);
    await page.emulateMedia({ reducedMotion: "no-preference" });
  },

  async "the rose answers from all around, and a click throws"() {
    await show(kThrow);
    const at_once = await page.evaluate(() => {
      globalThis.flinchPage.set({ mode: "rose" });
      return document.querySelectorAll("svg .cell").length;
    });
    assert.equal(at_once, 0, "the page waits for simulations");
    await page.waitForFunction(() => document.querySelectorAll("svg .cell").length === 144);
    // Another colour needs no other simulation.
    await page.getByLabel("Colours of the rose").selectOption("protection");
    assert.equal(await page.locator("svg .cell").count(), 144);
    await page.getByLabel("Colours of the rose").selectOption("kind");
    await page.locator("svg .cell").nth(100).click();
    assert.equal(await page.evaluate(() => globalThis.flinchPage.view.mode), "one");
  },

  async "the machine gun throws a ball every second at a character that is still busy"() {
    await show(kThrow.replace("view=one", "view=volley"));
    const state = (time) => {
      const { alone, player } = globalThis.flinchPage;
      player.seek(time);
      const { joints, balls } = alone.at(time).from;
      return { shots: alone.shots.length, balls: balls.map(({ id }) => id), joints: Array.from(joints.position) };
    };
    const late = await page.evaluate(state, 4.3);
    assert.equal(late.shots, 5);
    assert.deepEqual(late.balls, [2, 3, 4]);
    assert.ok(late.joints.every(Number.isFinite));
    await page.evaluate(frames);
    assert.match(await page.locator("#captions").textContent(), /Ball 5 of 12: .*\d hit, damage \d/);
    await page.evaluate(state, 1.2);
    assert.deepEqual(await page.evaluate(state, 4.3), late, "scrubbing changes nothing");
  },

  async "a character that was knocked over rises without a jump"() {
    await show(kThrow.replace("view=one", "view=volley"));
    const { seed, steps, away } = await page.evaluate(() => {
      const app = globalThis.flinchPage;
      Object.assign(app.view.thrown, { radius: 0.15, mass: 6 });
      for (let seed = 1; seed <= 20; ++seed) {
        app.set({ seed });
        app.alone.at(app.alone.duration);
        const [rising] = app.alone.risings;
        if (!rising) continue;
        const first = Math.round(rising.from * 60);
        const places = app.alone.frames.slice(first, first + 60).map(({ joints }) => joints.position);
        const far = (a, b) => Math.max(...a.map((_, i) => Math.abs(a[i] - b[i])));
        const steps = places.slice(1).map((place, i) => far(place, places[i]));
        // The pelvis comes first.
        const away = Math.hypot(...[0, 1].map((axis) => places.at(-1)[axis] - places[0][axis]));
        return { seed, steps: [...steps, far(places[0], places.at(-1))], away };
      }
      return { seed: 0, steps: [] };
    });
    assert.ok(seed > 0, "no volley knocks the character over");
    const whole = steps.pop();
    assert.ok(whole > 0.5, `it rises by ${whole} m`);
    assert.ok(away < 0.25, `it rises ${away} m from where it fell`);
    assert.ok(Math.max(...steps) < 0.12, `a joint jumps by ${Math.max(...steps)} m in a frame`);
    await page.evaluate(() => globalThis.flinchPage.set({ seed: 1 }));
  },

  async "clips play as the library has them, and their marks can be moved"() {
    const clip = 5;
    await show(`#view=clips&clip=${clip}`);
    const library = (await loadFlinch()).load(selector);
    const known = library.clips[clip];
    const time = Math.fround(20 / 60);
    const shown = await page.evaluate((t) => {
      const { alone } = globalThis.flinchPage;
      return [alone.duration, ...alone.at(t + 1e-6).from.joints.position];
    }, 20 / 60);
    const expected = [known.duration_s, ...library.jointFrames(library.clipPose(clip, time)).position];
    assert.equal(shown.length, expected.length);
    shown.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < 1e-4, `number ${i}`));

    const lines = () => page.locator("#clip-editor pre").textContent();
    assert.ok((await lines()).includes(`name = "${known.name}"\n`));
    assert.ok((await lines()).includes(`peak = ${known.peak_s.toFixed(3)}\n`));
    const peak = page.getByRole("slider", { name: "peak" });
    await peak.focus();
    await page.keyboard.press("ArrowLeft");
    const one_less = (Math.round(known.peak_s * 60 - 1) / 60).toFixed(3);
    assert.ok((await lines()).includes(`peak = ${one_less}\n`), await lines());
    const box = await peak.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + 5);
    await page.mouse.down();
    await page.mouse.move(box.x - 3000, box.y + 5, { steps: 2 });
    await page.mouse.up();
    const onset = Number(/onset = ([\d.]+)/.exec(await lines())[1]);
    assert.ok((await lines()).includes(`peak = ${(onset + 1 / 60).toFixed(3)}\n`), "no mark passes another");
    assert.ok(Math.abs((await page.evaluate(() => globalThis.flinchPage.player.time)) - onset - 1 / 60) < 1e-3);
  },

  async "without WebAssembly the page says so, and nothing breaks"() {
    const context = await browser.newContext();
    await context.addInitScript(() => delete globalThis.WebAssembly);
    const made = watch(await context.newPage());
    await made.goto(address, { waitUntil: "commit" });
    await made.waitForFunction(() => /cannot run WebAssembly/.test(document.getElementById("message")?.textContent));
    assert.equal(await made.locator("#message").isVisible(), true);
    await context.close();
  },

  async "compressed as servers do, the page has at most 0.6 MB, and 3 MB with a selector"() {
    const html = await readFile(page_file, "utf8");
    const size_mb = (text) => gzipSync(text).length / 1e6;
    const own = html.replace(/<script[^>]* data-selector[^]*?<\/script>/g, "");
    assert.ok(own.length < html.length - selector.length, "the page has no selector");
    console.log(`  ${size_mb(own).toFixed(2)} MB, with a selector ${size_mb(html).toFixed(2)} MB`);
    assert.ok(size_mb(own) <= 0.6 && size_mb(html) <= 3);
  },

  async "the impulses of where it hits add up"() {
    await show(`${kThrow}&who=${await chooser("idle")}`);
    await page.waitForFunction(() => document.querySelectorAll("#why .bars > b").length === 2);
    const numbers = await page.locator("#why .bars > :nth-child(3n)").allTextContents();
    const impulses = numbers.map((text) => Number(/^([\d.]+) N s$/.exec(text)[1]));
    const together = impulses.pop();
    assert.ok(impulses.length > 0 && together > 1, numbers);
    const sum = impulses.reduce((a, b) => a + b, 0);
    assert.ok(Math.abs(sum - together) < 0.006 * numbers.length, `${numbers}`);
  },

  async "a tournament fills up, and the oracle has all that is possible"() {
    await show(kThrow.replace("view=one", "view=tournament"));
    // As soon as a scenario has been thrown in which something can be prevented.
    await page.waitForFunction(() => /Oracle 100 %/.test(document.querySelector("#full svg")?.getAttribute("aria-label")));
    assert.match(await page.locator("#full svg").getAttribute("aria-label"), /Idle 0 %/);
  },

  async "nothing but its own script runs, from a server with a strict policy too"() {
    const html = await readFile(page_file, "utf8");
    const policy = /Content-Security-Policy" content="([^"]+)"/.exec(html)[1];
    assert.ok(policy.includes("default-src 'none'") && !policy.includes("unsafe-inline"));
    const server = createServer((_, response) => {
      response.setHeader("Content-Security-Policy", policy);
      response.setHeader("Content-Type", "text/html");
      response.end(html);
    });
    await new Promise((done) => server.listen(0, "127.0.0.1", done));
    const served = await open(`http://127.0.0.1:${server.address().port}/${kThrow}`);
    await served.evaluate(() => globalThis.flinchPage.throwBall());
    await served.waitForFunction(() => globalThis.flinchPage.player.time > 0.1);
    await served.context().close();
    server.close();
  },

  async "the rose is seen whole, with its legend"() {
    await page.setViewportSize({ width: 1280, height: 800 });
    await show(linkTo("rose"));
    await page.waitForFunction(isWholeRose);
    const legend = await page.locator("#full .legend").boundingBox();
    assert.ok(legend.y + legend.height <= 800, `the legend ends at ${legend.y + legend.height} px`);
  },

  async "no view is wider than a phone"() {
    await page.setViewportSize(kPhone);
    for (const mode of kViews) {
      await show(linkTo(mode));
      if (mode === "rose") await page.waitForFunction(isWholeRose);
      const excess = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(excess <= 0, `${mode} is ${excess} px too wide`);
    }
  },
};

const kPhone = { width: 390, height: 780 };
const kViews = ["one", "compare", "volley", "clips", "rose", "tournament"];
const linkTo = (mode) =>
  `${kThrow.replace("view=one", `view=${mode}`)}&t=${mode === "volley" ? 3.61 : 0.62}&clip=21`;
const isWholeRose = () => document.querySelectorAll("svg .cell").length === 144;

/** Pictures of all views, in light, in dark and on a phone. */
async function takePictures() {
  mkdirSync(shots, { recursive: true });
  execFileSync(program, ["view", ...shown_selectors, "--out", `${folder}/shown`]);
  const shown = await open(pathToFileURL(`${folder}/shown/index.html`).href);
  const isPlayed = () => /^200 /.test(document.querySelector("#full .legend")?.textContent);
  for (const [name, size, colorScheme] of [
    ["light", { width: 1280, height: 800 }, "light"],
    ["dark", { width: 1280, height: 800 }, "dark"],
    ["phone", kPhone, "light"],
  ]) {
    await shown.setViewportSize(size);
    await shown.emulateMedia({ colorScheme });
    for (const mode of kViews) {
      await show(linkTo(mode), shown);
      await shown.evaluate(() => (document.getElementById("hint").hidden = true));
      if (mode === "compare") await shown.waitForTimeout(2000); // the oracle's answer
      if (mode === "rose") await shown.waitForFunction(isWholeRose);
      if (mode === "tournament") await shown.waitForFunction(isPlayed, null, { timeout: 300000 });
      await shown.screenshot({ path: `${shots}/${mode}_${name}.jpg`, type: "jpeg", quality: 85 });
    }
  }
}

const failed = await run(tests);
if (shots) await takePictures();
await browser.close();
await rm(folder, { recursive: true });
process.exit(failed ? 1 : 0);
