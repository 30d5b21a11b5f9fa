#!/bin/sh
# SPDX-License-Identifier: MIT
# glMatrix 3.4.4 (npm gl-matrix): the angle between a quaternion and itself is NaN for some quaternions.
#
# Expected: quat.getAngle(q, q) is 0 or nearly so, as quaternions that setAxisAngle makes are of length 1.
# Seen: it is acos(2 d^2 - 1) of their dot product d, which in 32 bits may come out above 1, and then it is
# NaN. So it is for 495 of 1000 random turns. A comparison with NaN is false, so a loop that turns
# until getAngle falls below a tolerance does not end, and a sum of a pose's errors is NaN where the
# pose is met. vec3.angle keeps its cosine below 1.
# Flinch: does not use it. Who does calls Math.min(1, ...) before acos, or compares the quaternions.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . gl-matrix@3.4.4 >/dev/null
cat >angle.mjs <<'JS'
import { quat, vec3 } from 'gl-matrix';

let state = 1;
const draw = () => (state = (state * 48271) % 2147483647) / 2147483647;
let none = 0;
for (let i = 0; i < 1000; ++i) {
  const axis = vec3.normalize(vec3.create(), [draw() - 0.5, draw() - 0.5, draw() - 0.5]);
  const turn = quat.setAxisAngle(quat.create(), axis, Math.PI * draw());
  if (Number.isNaN(quat.getAngle(turn, turn))) ++none;
}
console.log(`getAngle(q, q) is NaN for ${none} of 1000 turns`);
console.log(`vec3.angle(v, v) is ${vec3.angle([0.6, 0.8, 0], [0.6, 0.8, 0]).toFixed(6)}`);
JS
node angle.mjs | tee seen
printf '%s\n' 'getAngle(q, q) is NaN for 495 of 1000 turns' 'vec3.angle(v, v) is 0.000000' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
