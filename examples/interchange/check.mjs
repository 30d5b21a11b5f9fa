// SPDX-License-Identifier: MIT
// Compares where a tool has the joints of FOLDER/clips.glb with where Flinch has them: usage:
// node check.mjs FOLDER three|babylon|gltf_transform, or node check.mjs FOLDER PROGRAM
// PROGRAM prints the joints, as joints_by_assimp does, or exits with 77. Exits with 77, a skipped
// test, where the packages are not installed.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";

const kBound_m = 1e-3;
const [folder, reader] = process.argv.slice(2);
const samples = JSON.parse(readFileSync(`${folder}/joints.json`, "utf8"));
const file = new Uint8Array(readFileSync(`${folder}/clips.glb`));

function jointsBy(program) {
  const { status, stdout } = spawnSync(program, [folder], { encoding: "utf8", maxBuffer: 1e8, stdio: ["ignore", "pipe", "inherit"] });
  if (status !== 0) {
    console.log(stdout);
    process.exit(status ?? 1);
  }
  return JSON.parse(stdout);
}

async function read() {
  if (reader.includes("/")) return jointsBy(reader);
  if (!existsSync(new URL("node_modules/package-lock.json", import.meta.url))) {
    console.log("skipped: its npm packages are missing; scripts/setup --page fetches them");
    process.exit(77);
  }
  const { joints } = await import(`./joints_by_${reader}.mjs`);
  return joints(file, samples);
}

const found = await read();
assert.ok(samples.length > 20 && found.length === samples.length);
let worst = 0;
let moved = 0;
samples.forEach(({ animation, time_s, joints }, i) => {
  for (const [name, expected] of Object.entries(joints)) {
    assert.ok(found[i][name], `${animation}: there is no ${name}`);
    const error = Math.hypot(...expected.map((value, k) => value - found[i][name][k]));
    assert.ok(error <= kBound_m, `${animation} at ${time_s} s: ${name} is off by ${error} m`);
    worst = Math.max(worst, error);
    moved = Math.max(moved, Math.hypot(...expected.map((value, k) => value - samples[0].joints[name][k])));
  }
});
assert.ok(moved > 0.2, "the clips hardly move");
console.log(`${samples.length} samples of ${Object.keys(samples[0].joints).length} joints: within ${(1000 * worst).toFixed(4)} mm`);
process.exit(0);
