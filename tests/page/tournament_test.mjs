// SPDX-License-Identifier: MIT
// The page's tournament gives the numbers of `flinch compare` on the same scenarios: usage:
// node tournament_test.mjs FLINCH VIEWER_FOLDER PACKAGE FOLDER
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const kScenarios = 20;
const kSeed = 2;
const [program, viewer, packageFolder, folder] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const flinch = (...parts) => execFileSync(program, parts.map(String), { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

flinch("author", "--out", "a.flinchlib");
flinch("simulate", "a.flinchlib", "--out", "a.flinchobs", "-n", 60, "--seed", 1);
flinch("simulate", "a.flinchlib", "--out", "test.flinchobs", "-n", kScenarios, "--seed", kSeed);
flinch("train", "a.flinchobs", "--out", "a.flinch", "--model", "knn");
const compared = JSON.parse(flinch("compare", "a.flinchobs", "--test", "test.flinchobs", "--models", "knn", "--json"));
const rowNamed = (name) => compared.rows.find((row) => row.name === name);

const { build } = createRequire(createRequire(`${viewer}/package.json`).resolve("vite"))("esbuild");
const bundled = async (name) => {
  const outfile = `${folder}/${name}.mjs`;
  await build({ entryPoints: [`${viewer}/src/${name}.ts`], bundle: true, format: "esm", outfile, logLevel: "error" });
  return import(pathToFileURL(outfile));
};
const { playTournament } = await bundled("tournament");
const { beforeThrow, choosersOf, loadSelector } = await bundled("chooser");
const { loadFlinch } = await import(pathToFileURL(`${packageFolder}/flinch.js`));
const selector = loadSelector(await loadFlinch(), "a", readFileSync(`${folder}/a.flinch`));
const { brawn } = selector.oracle.costs();
let last;
for (const one of playTournament(choosersOf([selector]), { seed: kSeed, throws: kScenarios, brawn })) last = one;

assert.equal(last.thrown, kScenarios);
// A protection below 0 has a bar, to the left of 0 and within the chart.
const { barOf, scaleOf } = await bundled("standings");
const worse = [{ name: "a", protection: -0.6, low: -0.7, high: -0.5 }, { name: "b", protection: 0.9, low: 0.8, high: 1 }];
const { x: at, ticks } = scaleOf(worse, 640);
const bar = barOf(-0.6, at);
assert.ok(Math.abs(bar.x + bar.width - at(0)) < 1e-9 && bar.width > 50 && bar.x >= 80, JSON.stringify(bar));
assert.ok(ticks.includes(0) && ticks.includes(1) && ticks.includes(-0.5), ticks);
assert.ok(at(-3) >= 80 && at(3) <= 640);

let compared_rows = 0;
for (const [name, row] of [["a", "knn"], ["Idle", "idle"], ["Oracle", "oracle"], ["Nearest", "nearest_annotation"]]) {
  const own = last.standings.find((standing) => standing.name === name);
  const { mean_cost, protection } = rowNamed(row);
  assert.ok(Math.abs(own.cost_ns - mean_cost) < 2e-3, `${name} costs ${own.cost_ns}, ${row} ${mean_cost} N s`);
  assert.ok(Math.abs(own.protection - protection) < 2e-3, `${name} protects ${own.protection}, ${row} ${protection}`);
  console.log(`${row}: ${mean_cost.toFixed(4)} N s in the program, ${own.cost_ns.toFixed(4)} on the page; protection ${protection.toFixed(4)}, ${own.protection.toFixed(4)}`);
  ++compared_rows;
}
assert.equal(compared_rows, 4);
assert.ok(rowNamed("idle").mean_cost > 1.2 * rowNamed("oracle").mean_cost, "the scenarios hardly differ");

// What the oracle's worker computes for a throw at a character that stands still.
const { randomNumbers, randomThrow, threatOf } = await bundled("throw");
const random = randomNumbers(1);
const computed_ms = Array.from({ length: 40 }, () => {
  const threat = threatOf(randomThrow(random));
  const begin = process.cpuUsage().user;
  selector.oracle.tryAll(beforeThrow(selector, { delay: 0 }), threat);
  return (process.cpuUsage().user - begin) / 1000;
}).slice(10); // the first are slower, until their code is compiled well
computed_ms.sort((a, b) => a - b);
console.log(`the oracle computes ${computed_ms[computed_ms.length >> 1].toFixed(0)} ms for a throw (median of ${computed_ms.length}, CPU time)`);
