#!/bin/sh
# SPDX-License-Identifier: MIT
# wgpu-matrix 3.4.2 and @thi.ng/matrices 3.0.26 (npm): the shortest rotation from a direction to its
# opposite does not turn.
#
# Expected: quat.rotationTo(v, -v) and alignmentQuat(v, -v) are half turns about some axis across v,
# as glMatrix and three.js make them.
# Seen: wgpu-matrix's result has a length of 6e-17 and leaves the vector where it is, and that of
# @thi.ng/matrices is four zeros, which turn every vector into the origin. So it is for every direction. A
# limb that has to point the other way stays as it was, or its bones vanish. Directions that differ by
# 179 degrees are turned rightly.
# Flinch: motion::rotation_between makes a half turn, with a test. It does not use these libraries.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . \
  wgpu-matrix@3.4.2 @thi.ng/matrices@3.0.26 gl-matrix@3.4.4 three@0.187.0 >/dev/null
cat >opposite.mjs <<'JS'
import { alignmentQuat } from '@thi.ng/matrices';
import { quat as glQuat } from 'gl-matrix';
import { Quaternion, Vector3 } from 'three';
import { quat } from 'wgpu-matrix';

const makers = {
  'three.js': (from, to) =>
    new Quaternion().setFromUnitVectors(new Vector3(...from), new Vector3(...to)).toArray(),
  glMatrix: (from, to) => glQuat.rotationTo([], from, to),
  'wgpu-matrix': (from, to) => quat.rotationTo(from, to),
  'thi.ng': (from, to) => alignmentQuat(from, to),
};
const directions = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.6, 0, 0.8]];
for (const [name, make] of Object.entries(makers)) {
  const length = (from, to) => Math.hypot(...make(from, to));
  const nearly = directions.map(([x, y, z]) => {
    // 179 degrees away: a little of another direction across it is added.
    const across = Math.abs(y) > 0.5 ? [1, 0, 0] : [0, 1, 0];
    const [c, s] = [Math.cos(Math.PI / 180), Math.sin(Math.PI / 180)];
    return length([x, y, z], [x, y, z].map((v, i) => -c * v + s * across[i])).toFixed(2);
  });
  const opposite = directions.map((v) => length(v, v.map((x) => -x)).toFixed(2));
  console.log(`${name}: lengths at 179 degrees ${nearly.join(' ')}, at 180 ${opposite.join(' ')}`);
}
JS
node opposite.mjs | tee seen
printf '%s\n' \
  'three.js: lengths at 179 degrees 1.00 1.00 1.00 1.00, at 180 1.00 1.00 1.00 1.00' \
  'glMatrix: lengths at 179 degrees 1.00 1.00 1.00 1.00, at 180 1.00 1.00 1.00 1.00' \
  'wgpu-matrix: lengths at 179 degrees 1.00 1.00 1.00 1.00, at 180 0.00 0.00 0.00 0.00' \
  'thi.ng: lengths at 179 degrees 1.00 1.00 1.00 1.00, at 180 0.00 0.00 0.00 0.00' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
