// SPDX-License-Identifier: MIT
// WebAssembly gives what the native library gave: usage: node throws_test.mjs PACKAGE FOLDER
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";

const [packageFolder, folder] = process.argv.slice(2);
const { loadFlinch, FlinchError } = await import(pathToFileURL(`${packageFolder}/flinch.js`));
const expected = JSON.parse(await readFile(`${folder}/throws.json`, "utf8"));
const selector = await readFile(`${folder}/throws.flinch`);

const flinch = await loadFlinch();
const library = flinch.load(selector);
const character = library.createCharacter();
const oracle = library.createOracle();
const answers = ["ok", "misses", "unnoticed"];

const threatOf = ([x, y, z, u, v, w, radius, mass_kg]) => ({
  position: [x, y, z], velocity: [u, v, w], radius, mass_kg,
});
const reset = () => character.place(0, 0, 0, 0.5);
const play = (frames) => {
  for (let frame = 0; frame < frames; ++frame) character.update(Math.fround(1 / 60));
};
const poseNow = () => {
  const { root_position, rotation } = character.pose();
  return [...root_position, ...rotation];
};
const largestDifference = (a, b) => {
  assert.equal(a.length, b.length);
  return Math.max(...a.map((value, i) => Math.abs(value - b[i])));
};

let pose_error = 0;
let chosen_s = 0;
const clips = new Set();
for (const one of expected.throws) {
  const threat = threatOf(one.threat);
  reset();
  character.lookAhead([threat], { candidates: 4 });
  assert.equal(character.state().clip, one.ahead);
  reset();
  const begin = performance.now();
  assert.equal(character.perceive(threat), answers[one.answer]);
  chosen_s += performance.now() - begin;
  assert.equal(character.state().clip, one.clip);
  clips.add(one.clip);
  for (const pose of one.poses) {
    play(20);
    pose_error = Math.max(pose_error, largestDifference(poseNow(), pose));
  }
}
assert.equal(expected.throws.length, 1000);
assert.ok(clips.size > 10, `only ${clips.size} clips were chosen`);
assert.ok(pose_error <= 1e-5, `poses differ by ${pose_error}`);

let cost_error = 0;
const oracle_ms = [];
for (const one of expected.oracle) {
  reset();
  const begin = performance.now();
  const { trials, best } = oracle.tryAll(character, threatOf(one.threat));
  oracle_ms.push(performance.now() - begin);
  assert.equal(best, one.best);
  cost_error = Math.max(cost_error, largestDifference(trials.map((t) => t.cost_ns), one.costs));
  const alone = oracle.tryClip(character, threatOf(one.threat), trials[best].clip);
  assert.deepEqual(alone, trials[best]);
}
assert.ok(cost_error < 5e-3, `costs differ by ${cost_error} N s`);

let impulse_error = 0;
let hit_error = 0;
let struck = 0;
for (const one of expected.hits) {
  reset();
  character.reactTo(threatOf(one.threat));
  play(30);
  const impulses = [...character.reaction().impulse_ns];
  impulse_error = Math.max(impulse_error, largestDifference(impulses, one.impulses));
  hit_error = Math.max(hit_error, largestDifference(poseNow(), one.pose));
  struck += impulses.some((impulse_ns) => impulse_ns > 0);
}
assert.ok(struck > 20, `only ${struck} balls hit`);
assert.ok(impulse_error < 1e-3, `impulses differ by ${impulse_error} N s`);
assert.ok(hit_error <= 1e-5, `poses after a hit differ by ${hit_error}`);

// The surface is where the joints are: every vertex of the standing figure is above the ground.
const skin = library.skin();
const vertices = skin.position.length / 3;
assert.ok(vertices > 1000 && skin.triangles.every((corners) => corners.every((v) => v < vertices)));
assert.ok(skin.position.every((value, i) => i % 3 !== 2 || (value > -0.01 && value < 2)));
assert.ok(skin.joint.every((joint) => joint < flinch.joints.length));

// A character takes every stance at any time of it, where it is put, and changes to another.
const moving = flinch.load(await readFile(`${folder}/stances.flinch`));
assert.deepEqual(moving.stances.map((clip) => moving.clips[clip].name), ["idle", "guard", "walk"]);
const walker = moving.createCharacter();
const turns = () => [...walker.pose().rotation.slice(4)];
for (const [stance, clip] of moving.stances.entries()) {
  walker.place(0, 0, 0, 0.3, stance);
  const expected_turns = [...moving.clipPose(clip, 0.3).rotation.slice(4)];
  assert.ok(largestDifference(turns(), expected_turns) < 1e-3, `stance ${stance}`);
}
const walked = () => walker.pose().root_position[0];
const from = walked();
for (let frame = 0; frame < 60; ++frame) walker.update(1 / 60);
assert.ok(Math.abs(walked() - from - 0.9) < 0.05, `it walks ${walked() - from} m in a second`);
walker.changeStance(1);
for (let frame = 0; frame < 180; ++frame) walker.update(1 / 60);
const stood = walked();
for (let frame = 0; frame < 60; ++frame) walker.update(1 / 60);
assert.ok(Math.abs(walked() - stood) < 0.02, "on guard it stands");

// Selectors without clips play from a library that they share, which may be freed before.
const bareFile = await readFile(`${folder}/bare.flinch`);
const clipsFile = await readFile(`${folder}/clips.flinchlib`);
const clipsAlone = flinch.take(clipsFile);
const bareOne = flinch.loadBeside(bareFile, clipsAlone);
const bareTwo = flinch.loadBeside(bareFile, bareOne);
clipsAlone.free();
bareOne.free();
assert.deepEqual(bareTwo.clips, library.clips);
const bareCharacter = bareTwo.createCharacter();
for (const one of expected.throws.slice(0, 100)) {
  bareCharacter.place(0, 0, 0, 0.5);
  assert.equal(bareCharacter.perceive(threatOf(one.threat)), answers[one.answer]);
  assert.equal(bareCharacter.state().clip, one.clip);
  for (let frame = 0; frame < 20; ++frame) bareCharacter.update(Math.fround(1 / 60));
  const { root_position, rotation } = bareCharacter.pose();
  assert.ok(largestDifference([...root_position, ...rotation], one.poses[0]) <= 1e-5);
}

// Errors are exceptions with the library's text.
const refuses = (act, status, text) =>
  assert.throws(act, (error) => {
    assert.ok(error instanceof FlinchError, String(error));
    assert.equal(error.status, status);
    assert.match(error.message, text);
    return true;
  });
const damaged = Uint8Array.from(selector);
damaged[damaged.length >> 1] ^= 1;
refuses(() => flinch.load(damaged), -23, /damaged/);
refuses(() => flinch.load(selector.subarray(0, selector.length >> 1)), -23, /cut short/);
refuses(() => flinch.load(new Uint8Array(0)), -21, /not a selector/);
refuses(() => flinch.load(new TextEncoder().encode("HIERARCHY")), -21, /flinch train/);
refuses(() => flinch.load(bareFile), -25, /no clips/);
refuses(() => flinch.loadBeside(bareFile, moving), -30, /another library/);
refuses(() => flinch.loadBeside(damaged, bareTwo), -23, /damaged/);
refuses(() => flinch.take(selector), -29, /library/);
const toldOnly = flinch.take(clipsFile);
refuses(() => toldOnly.createCharacter().perceive(threatOf(expected.throws[0].threat)), -18, /selector/);
refuses(() => character.update(-1), -8, /time/);
assert.throws(() => walker.place(0, 0, 0, 0, 3), FlinchError);
const ball = { position: [NaN, 0, 0], velocity: [1, 0, 0], radius: 0.1, mass_kg: 1 };
refuses(() => character.perceive(ball), -7, /threat|number/);
assert.throws(() => character.perceive({ position: [1, 0, 0] }), /flinch_threat needs .* velocity/);
refuses(() => oracle.tryClip(character, threatOf(expected.oracle[0].threat), 9999), -6, /clip/);

// The layout names every byte of every struct.
const { structs } = flinch.memory;
for (const [name, { size, fields }] of Object.entries(structs)) {
  const bytes = Object.values(fields).map(({ type, count }) => count * (structs[type]?.size ?? 4));
  assert.equal(bytes.reduce((sum, part) => sum + part), size, name);
}
assert.equal(structs.flinch_clip.size, 48, "pointers have 32 bits here, and 64 in the native one");

// A hundred libraries come and go in the memory of a few.
const { memory } = flinch.memory.call;
flinch.load(selector).free();
const bytes = memory.buffer.byteLength;
for (let i = 0; i < 100; ++i) {
  const one = flinch.load(selector);
  one.createCharacter().free();
  one.free();
}
assert.ok(memory.buffer.byteLength - bytes < 3 * selector.length, "memory leaks");

console.log(
  `1000 throws, ${clips.size} clips: poses within ${pose_error.toExponential(1)}, ` +
    `costs ${cost_error.toExponential(1)} N s; ${struck} hits: impulses within ` +
    `${impulse_error.toExponential(1)} N s, poses ${hit_error.toExponential(1)}`,
);
console.log(
  `choosing ${chosen_s.toFixed(0)} us, the oracle ${Math.min(...oracle_ms).toFixed(0)} ms a throw`,
);
