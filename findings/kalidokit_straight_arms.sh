#!/bin/sh
# SPDX-License-Identifier: MIT
# Kalidokit 1.1.5 (npm kalidokit): an arm that hangs by 60 degrees comes out at 44, a T pose with its arms
# turned by 29 degrees about Y, and the elbow of a straight arm is at times not a number.
#
# Expected: Pose.solve turns MediaPipe's points in metres into rotations of the rest pose of a VRM figure,
# which is a T pose. Arms that are straight to the sides give zero, arms lowered by 60 degrees in the
# plane of the body give 60 about Z, and a straight elbow gives zero.
# Seen: Z is 2.3 times where a half turn is pi, 0.73 of the angle, Y goes from 29 to -51 degrees as the
# arm is lowered though no point leaves the plane, and X is -11 throughout. The factors are there "for
# more natural movement" and no option turns them off. Where the cosine of the elbow is rounded to more
# than 1, its angle is NaN, and who copies it to a bone has a figure without a forearm for that frame.
# Flinch: has no pose estimation. Who records by it clamps, and does not measure angles there.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . kalidokit@1.1.5 >/dev/null
cat >arms.cjs <<'JS'
const { Pose } = require('./node_modules/kalidokit/dist/kalidokit.umd.js');

// The 33 points of a body that faces the camera, with both arms lowered by an angle. Y points down.
function points(angle) {
  const [along, down] = [Math.cos(angle), Math.sin(angle)];
  const body = Array.from({ length: 33 }, () => ({ x: 0, y: 0, z: 0, visibility: 1 }));
  const put = (left, x, y) => [x, -x].forEach((side, i) => Object.assign(body[left + i], { x: side, y }));
  put(11, 0.2, -0.5);
  const distances = { 13: 0.3, 15: 0.55, 17: 0.63, 19: 0.63 };
  for (const [left, distance] of Object.entries(distances)) {
    put(Number(left), 0.2 + distance * along, -0.5 + distance * down);
  }
  put(23, 0.1, 0);
  put(25, 0.1, 0.4);
  put(27, 0.1, 0.8);
  return body;
}
for (const degrees of [0, 30, 60, 80]) {
  const body = points(degrees * Math.PI / 180);
  const picture = body.map((point) => ({ ...point, x: 0.5 + point.x / 3, y: 0.5 + point.y / 3 }));
  const figure = Pose.solve(body, picture, { runtime: 'mediapipe', imageSize: { width: 640, height: 480 } });
  const { LeftUpperArm: arm, LeftLowerArm: forearm } = figure;
  const tell = (angle) => Math.round(angle * 180 / Math.PI) + 0;
  console.log(`lowered by ${degrees}: arm ${['x', 'y', 'z'].map((axis) => tell(arm[axis])).join(' ')}, ` +
      `elbow ${tell(forearm.y)}`);
}
JS
node arms.cjs | tee seen
cmp -s - seen <<'TEXT' || {
lowered by 0: arm -11 29 0, elbow 0
lowered by 30: arm -11 -1 22, elbow 0
lowered by 60: arm -11 -31 44, elbow 0
lowered by 80: arm -11 -51 59, elbow NaN
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
