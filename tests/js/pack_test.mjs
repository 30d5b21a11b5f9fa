// SPDX-License-Identifier: MIT
// `npm pack` makes a package that works by itself: usage: node pack_test.mjs PACKAGE FOLDER
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readdirSync, rmSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [packageFolder, folder] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const packed = execFileSync("npm", ["pack", "--silent", "--pack-destination", folder], {
  cwd: packageFolder,
  encoding: "utf8",
}).trim();
execFileSync("tar", ["xzf", packed], { cwd: folder });
const files = readdirSync(`${folder}/package`).sort();
assert.deepEqual(files, [
  "README.md", "character.js", "crowd.js", "flinch.d.ts", "flinch.js", "flinch.wasm", "labelling.js", "library.js",
  "memory.js", "oracle.js", "package.json",
]);
const { loadFlinch } = await import(pathToFileURL(`${folder}/package/flinch.js`));
const flinch = await loadFlinch();
assert.equal(flinch.joints.length, 21);
assert.equal(flinch.bodies.length, 17);
assert.equal(flinch.joints[0], "pelvis");
assert.equal(flinch.parents[0], -1);
assert.ok(packed.includes(flinch.version), `${packed} is not of version ${flinch.version}`);
console.log(`${packed}: ${files.length} files`);
