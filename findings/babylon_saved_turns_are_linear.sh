#!/bin/sh
# SPDX-License-Identifier: MIT
# Babylon.js 9.28.0 (npm @babylonjs/core): an animation of rotations that is saved and loaded again has
# lost its tangents and its steps; one of places keeps both.
#
# Expected: what Animation.Parse() makes of serialize() shows the same at every frame, be its values numbers,
# vectors or quaternions.
# Seen: numbers and vectors come back as they were. Quaternions come back linear: a joint that holds its
# pose until the next key turns all the way to it, and one that eases into a key does not. Nothing is
# said, and linear animations, the usual case of a test, are right.
# Flinch: its .glb has linear keys on every frame.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . @babylonjs/core@9.28.0 >/dev/null
cat >saved.mjs <<'JS'
import { Animation } from '@babylonjs/core/Animations/animation.js';
import { Quaternion, Vector3 } from '@babylonjs/core/Maths/math.vector.js';

const turn = (angle) => new Quaternion(Math.sin(angle / 2), 0, 0, Math.cos(angle / 2));
const along = (x) => new Vector3(x, 0, 0);
const kinds = {
  number: [Animation.ANIMATIONTYPE_FLOAT, (x) => x, (x) => x, (v) => v],
  vector: [Animation.ANIMATIONTYPE_VECTOR3, along, along, (v) => v.x],
  quaternion: [
    Animation.ANIMATIONTYPE_QUATERNION,
    turn,
    (x) => new Quaternion(x, 0, 0, 0),
    (v) => 2 * Math.atan2(v.x, v.w),
  ],
};
// Each key is at a frame; the next two are 20 and 10 frames later.
const shapes = {
  linear: (value) => [{ value: value(0) }, { value: value(1) }, { value: value(2) }],
  smooth: (value, slope) => [
    { value: value(0), outTangent: slope(0) },
    { value: value(1), inTangent: slope(0), outTangent: slope(0) },
    { value: value(2), inTangent: slope(0) },
  ],
  stepped: (value) => [0, 1, 2].map((x) => ({ value: value(x), interpolation: 1 })),
};
for (const [kind, [type, value, slope, shown]] of Object.entries(kinds))
  for (const [shape, keys] of Object.entries(shapes)) {
    const made = new Animation('joint', 'rotation', 60, type, Animation.ANIMATIONLOOPMODE_CONSTANT);
    made.setKeys(keys(value, slope).map((key, i) => ({ frame: [0, 20, 30][i], ...key })));
    const loaded = Animation.Parse(JSON.parse(JSON.stringify(made.serialize())));
    const at = (animation) => [5, 25].map((frame) => shown(animation.evaluate(frame)).toFixed(2)).join(' ');
    console.log(`${kind}, ${shape}: ${at(made)}, loaded ${at(loaded)}`);
  }
JS
node saved.mjs | tee seen
printf '%s\n' 'number, linear: 0.25 1.50, loaded 0.25 1.50' 'number, smooth: 0.16 1.50, loaded 0.16 1.50' \
  'number, stepped: 0.00 1.00, loaded 0.00 1.00' 'vector, linear: 0.25 1.50, loaded 0.25 1.50' \
  'vector, smooth: 0.16 1.50, loaded 0.16 1.50' 'vector, stepped: 0.00 1.00, loaded 0.00 1.00' \
  'quaternion, linear: 0.25 1.50, loaded 0.25 1.50' 'quaternion, smooth: 0.15 1.50, loaded 0.25 1.50' \
  'quaternion, stepped: 0.00 1.00, loaded 0.25 1.50' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
