#!/bin/sh
# SPDX-License-Identifier: MIT
# @dcl/gltf-validator-ts 1.0.19 (npm): a validator that says it is compatible with Khronos' passes keys whose
# times go back, quaternions of length 2 and numbers that are none.
#
# Expected: a translation of Khronos' validator with its codes, validateBytes, reports the errors that
# Khronos' (npm gltf-validator 2.0.0-dev.3.10) reports.
# Seen: of seven faults of an animation in a .glb it reports the two that can be seen without the numbers:
# a missing bound, and two channels with one target. What is in the buffer it does not look at: falling
# times, a rotation that is no unit quaternion, a wrong bound, a NaN. It also passes a CUBICSPLINE with
# too few values. A check of exported files by it alone is none of their motion.
# Flinch: its tests run Khronos' validator.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . gltf-validator@2.0.0-dev.3.10 \
  @dcl/gltf-validator-ts@1.0.19 >/dev/null
cat >faults.cjs <<'JS'
const port = require('@dcl/gltf-validator-ts');
const khronos = require('gltf-validator');

// A .glb of a node that turns by 90 degrees in 1 s.
function glb(fault) {
  const numbers = Float32Array.of(0, 1, 0, 0, 0, 1, 0, 0, Math.SQRT1_2, Math.SQRT1_2);
  const gltf = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: 'Hips' }],
    buffers: [{ byteLength: numbers.byteLength }],
    bufferViews: [{ buffer: 0, byteLength: 8 }, { buffer: 0, byteOffset: 8, byteLength: 32 }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 2, type: 'SCALAR', min: [0], max: [1] },
      { bufferView: 1, componentType: 5126, count: 2, type: 'VEC4' },
    ],
    animations: [{
      samplers: [{ input: 0, output: 1 }],
      channels: [{ sampler: 0, target: { node: 0, path: 'rotation' } }],
    }],
  };
  fault(gltf, numbers);
  const json = Buffer.from(JSON.stringify(gltf).padEnd(Math.ceil(JSON.stringify(gltf).length / 4) * 4));
  const file = Buffer.alloc(28 + json.length + numbers.byteLength);
  [0x46546c67, 2, file.length, json.length, 0x4e4f534a].forEach((word, i) => file.writeUInt32LE(word, 4 * i));
  json.copy(file, 20);
  file.writeUInt32LE(numbers.byteLength, 20 + json.length);
  file.writeUInt32LE(0x004e4942, 24 + json.length);
  Buffer.from(numbers.buffer).copy(file, 28 + json.length);
  return new Uint8Array(file);
}
const faults = {
  none: () => {},
  'times fall': (gltf, numbers) => numbers.set([1, 0]),
  'a quaternion of length 2': (gltf, numbers) => numbers.set([2], 5),
  'a number that is none': (gltf, numbers) => numbers.set([NaN], 4),
  'a wrong bound': (gltf) => (gltf.accessors[0].max = [2]),
  'a spline with too few values': (gltf) => (gltf.animations[0].samplers[0].interpolation = 'CUBICSPLINE'),
  'no bounds of the times': (gltf) => void (delete gltf.accessors[0].min, delete gltf.accessors[0].max),
  'two channels with one target': ({ animations: [{ channels }] }) => channels.push(channels[0]),
};
(async () => {
  for (const [name, fault] of Object.entries(faults)) {
    const counts = [];
    for (const { validateBytes } of [khronos, port]) {
      counts.push((await validateBytes(glb(fault))).issues.numErrors);
    }
    console.log(`${name}: Khronos' ${counts[0] > 0 ? 'errors' : 'no error'}, ` +
        `the port ${counts[1] > 0 ? 'errors' : 'no error'}`);
  }
})();
JS
node faults.cjs | tee seen
cmp -s - seen <<'TEXT' || {
none: Khronos' no error, the port no error
times fall: Khronos' errors, the port no error
a quaternion of length 2: Khronos' errors, the port no error
a number that is none: Khronos' errors, the port no error
a wrong bound: Khronos' errors, the port no error
a spline with too few values: Khronos' errors, the port no error
no bounds of the times: Khronos' errors, the port errors
two channels with one target: Khronos' errors, the port errors
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
