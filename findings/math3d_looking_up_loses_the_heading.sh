#!/bin/sh
# SPDX-License-Identifier: MIT
# math3d 0.2.2 (npm): who looks straight up has no heading any more, and the angle between a rotation and itself is
# often NaN.
#
# Expected: at 90 degrees of pitch, yaw and roll turn about one axis, so that eulerAngles gives the sum of both
# to one of them and 0 to the other, as Unity does, which this library follows; the three angles make the
# rotation again. angleTo(itself) is 0.
# Seen: eulerAngles is (90, 0, 0) for every rotation with a pitch of 90, so Euler(90, 30, 0) comes back 30
# degrees off, and Euler(89.9, 30, 0) as it was. angleTo takes the arc cosine of what rounding puts above 1:
# NaN for 853 of 2000 rotations against themselves, and every comparison with NaN is false.
# Flinch: does not use it. Its .bvh keeps a rotation at gimbal lock, by test.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . math3d@0.2.2 >/dev/null
cat >look.cjs <<'JS'
const { Quaternion } = require('math3d');

for (const angles of [[89.9, 30, 0], [90, 30, 0], [-90, 0, 40]]) {
  const look = Quaternion.Euler(...angles);
  const { x, y, z } = look.eulerAngles;
  const apart = 2 * Math.acos(Math.min(1, Math.abs(look.dot(Quaternion.Euler(x, y, z))))) * 180 / Math.PI;
  console.log(`${angles.join(', ')}: ${[x, y, z].map((angle) => angle.toFixed(1)).join(', ')}, `
    + `${apart.toFixed(0)} degrees off`);
}
let none = 0;
for (let i = 0; i < 2000; ++i) {
  const turn = Quaternion.Euler(i * 0.7, i * 1.3, i * 2.1);
  none += Number.isNaN(turn.angleTo(turn));
}
console.log(`angle to itself: NaN for ${none > 500 ? 'many' : none} of 2000`);
JS
node look.cjs | tee seen
cmp -s - seen <<'TEXT' || {
89.9, 30, 0: 89.9, 30.0, 0.0, 0 degrees off
90, 30, 0: 90.0, 0.0, 0.0, 30 degrees off
-90, 0, 40: -90.0, 0.0, 0.0, 40 degrees off
angle to itself: NaN for many of 2000
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
