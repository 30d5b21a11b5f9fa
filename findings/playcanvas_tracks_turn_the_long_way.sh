#!/bin/sh
# SPDX-License-Identifier: MIT
# PlayCanvas 2.23.3 (npm playcanvas): between two keys a track turns the long way round if their
# quaternions have opposite signs, although Quat.slerp does not.
#
# Expected: q and -q are the same rotation, so an AnimTrack from the identity to 57.3 degrees shows 28.6 in
# the middle whichever sign the second key has; Quat.slerp and three.js' tracks do.
# Seen: with the other sign the middle is -151.4 degrees, and the joint spins round once. The importer of
# .glb changes the signs of its keys, so that only tracks that a program makes itself, of motion
# capture say, show it. @thi.ng/matrices 3.0.26 goes the same way by mixQ.
# Flinch: its tracks go the short way, and its .glb has keys of one sign. Who makes an AnimTrack of
# Flinch's poses negates each quaternion whose dot product with the one before is below 0.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . \
  playcanvas@2.23.3 @thi.ng/matrices@3.0.26 three@0.187.0 >/dev/null
cat >middle.mjs <<'JS'
import { mixQ } from '@thi.ng/matrices';
import * as pc from 'playcanvas';
import { QuaternionKeyframeTrack } from 'three';

const from = [0, 0, 0, 1];
const degrees = ([x, y, z, w]) => ((2 * Math.atan2(x, w) * 180) / Math.PI).toFixed(1);
const ways = {
  'three.js track': (to) =>
    [...new QuaternionKeyframeTrack('q', [0, 1], [...from, ...to]).createInterpolant().evaluate(0.5)],
  'PlayCanvas Quat.slerp': (to) => {
    const q = new pc.Quat().slerp(new pc.Quat(...from), new pc.Quat(...to), 0.5);
    return [q.x, q.y, q.z, q.w];
  },
  'PlayCanvas AnimTrack': (to) => {
    const times = new pc.AnimData(1, [0, 1]);
    const keys = new pc.AnimData(4, [...from, ...to]);
    const curve = new pc.AnimCurve(['joint/localRotation'], 0, 0, pc.INTERPOLATION_LINEAR);
    const track = new pc.AnimTrack('turn', 1, [times], [keys], [curve]);
    const seen = new pc.AnimSnapshot(track);
    track.eval(0.5, seen);
    return [...seen._results[0]];
  },
  'thi.ng mixQ': (to) => mixQ([], from, to, 0.5),
};
for (const [name, middle] of Object.entries(ways)) {
  const to = [Math.sin(0.5), 0, 0, Math.cos(0.5)];
  console.log(`${name}: ${degrees(middle(to))}, other sign ${degrees(middle(to.map((v) => -v)))}`);
}
JS
node middle.mjs | tee seen
printf '%s\n' 'three.js track: 28.6, other sign 28.6' 'PlayCanvas Quat.slerp: 28.6, other sign 28.6' \
  'PlayCanvas AnimTrack: 28.6, other sign -151.4' 'thi.ng mixQ: 28.6, other sign -151.4' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
