#!/bin/sh
# SPDX-License-Identifier: MIT
# three.js 0.187.0 (npm three): a blend of three clips with equal weights depends on the order in which they
# were started.
#
# Expected: weights alone say what a blend is; three clips of weight 1 have a third each, as positions have.
# Seen: rotations are blended one after the other, by slerp: the second at a half, the third at a third.
# Positions come out the same, rotations do not: three turns by 2 rad about X, Y and Z are 8 degrees apart in
# other orders. A clip that was stopped and played again goes to the end of the order, so two machines in
# the same state of a game, or a replay from the middle, show other poses. With two clips there is one
# answer.
# Flinch: poses its figures itself; three.js draws them.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 >/dev/null
cat >orders.mjs <<'JS'
import * as three from 'three';

function clip(name, axis) {
  const turn = new three.Quaternion().setFromAxisAngle(new three.Vector3(...axis), 2).toArray();
  return new three.AnimationClip(name, 1, [
    new three.QuaternionKeyframeTrack('.quaternion', [0, 1], [...turn, ...turn]),
    new three.VectorKeyframeTrack('.position', [0, 1], [...axis, ...axis])]);
}
const clips = [clip('x', [1, 0, 0]), clip('y', [0, 1, 0]), clip('z', [0, 0, 1])];
function pose(order, again) {
  const figure = new three.Object3D();
  const mixer = new three.AnimationMixer(figure);
  for (const i of order) mixer.clipAction(clips[i]).play();
  mixer.update(0.1);
  if (again !== undefined) {
    mixer.clipAction(clips[again]).stop();
    mixer.update(0.1);
    mixer.clipAction(clips[again]).play();
    mixer.update(0.1);
  }
  return figure;
}
const first = pose([0, 1, 2]);
const told = (name, figure) => console.log(`${name}: turned by `
  + `${((figure.quaternion.angleTo(first.quaternion) * 180) / Math.PI).toFixed(1)} degrees from the first, `
  + `at ${figure.position.toArray().map((x) => x.toFixed(2)).join(' ')}`);
for (const order of [[0, 1, 2], [0, 2, 1], [1, 2, 0], [2, 1, 0]]) {
  told(order.map((i) => clips[i].name).join(''), pose(order));
}
told('xyz, x stopped and played again', pose([0, 1, 2], 0));
JS
node orders.mjs | tee seen
cmp -s - seen <<'TEXT' || {
xyz: turned by 0.0 degrees from the first, at 0.33 0.33 0.33
xzy: turned by 8.3 degrees from the first, at 0.33 0.33 0.33
yzx: turned by 8.3 degrees from the first, at 0.33 0.33 0.33
zyx: turned by 8.3 degrees from the first, at 0.33 0.33 0.33
xyz, x stopped and played again: turned by 8.3 degrees from the first, at 0.33 0.33 0.33
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
