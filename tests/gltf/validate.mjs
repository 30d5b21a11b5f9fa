// SPDX-License-Identifier: MIT
// Fails if the Khronos validator reports any error, warning, information or hint for the .glb files
// in a folder. With --all-broken, fails unless it reports an error for each of them.
//
// Usage: node validate.mjs NODE [--all-broken] FOLDER
//
// NODE is the folder of the validator, which scripts/setup installs (build/node). Exits with 77, a
// skipped test, if the folder does not exist.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

const [node, ...rest] = process.argv.slice(2);
const allBroken = rest[0] === '--all-broken';
const folder = rest.at(-1);
if (!existsSync(node)) {
  console.log(`skipped: there is no validator in ${node}; scripts/setup fetches it`);
  process.exit(77);
}
const validator = createRequire(resolve(node, 'package.json'))('gltf-validator');

async function issuesOf(name) {
  const bytes = new Uint8Array(readFileSync(join(folder, name)));
  try {
    const options = { uri: name, format: 'glb', maxIssues: 20 };
    const { issues } = await validator.validateBytes(bytes, options);
    return issues;
  } catch (error) {
    // The validator throws, instead of reporting, for a file that is not a GLB.
    const messages = [{ code: 'REFUSED', message: String(error) }];
    return { numErrors: 1, numWarnings: 0, numInfos: 0, numHints: 0, messages };
  }
}

const files = readdirSync(folder).filter((name) => name.endsWith('.glb')).sort();
let wrong = 0;
for (const name of files) {
  const { numErrors, numWarnings, numInfos, numHints, messages } = await issuesOf(name);
  const isSound = numErrors + numWarnings + numInfos + numHints === 0;
  wrong += allBroken ? numErrors === 0 : !isSound;
  for (const { code, message, pointer = '' } of messages) {
    console.log(`${name}: ${code} ${pointer}: ${message}`);
  }
  console.log(`${name}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ` +
    `${numHints} hints`);
}
console.log(`glTF validator ${validator.version()}: ${files.length} files, ${wrong} not as they should be`);
process.exit(files.length > 0 && wrong === 0 ? 0 : 1);
