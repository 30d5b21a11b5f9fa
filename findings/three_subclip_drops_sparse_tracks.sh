#!/bin/sh
# SPDX-License-Identifier: MIT
# three.js 0.187.0 (npm three): AnimationUtils.subclip drops every track that has no key inside the
# part, and the bone goes back to its rest pose.
#
# Expected: the part of a clip from 2 s to 4 s looks like the clip from 2 s to 4 s.
# Seen: subclip takes keys and does not interpolate at the ends. A bone that turns from 0 to 90
# degrees by a key at 0 s and one at 10 s has no track in the part: it stands at its rest pose where
# the clip has it at 27 degrees. Where no track has a key at 2 s, all of the part comes early: it
# begins at the first key after. Tools that thin out keys, and authors who set few, make such clips.
# AnimationClip.trim loses the end in the same way.
# Flinch: its .glb has a key on every frame in each track.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 >/dev/null
cat >part.mjs <<'JS'
import * as THREE from 'three';

// The angle of a bone at `seconds`, which turns about Z from 0 to 90 degrees in 10 s.
function angle(keys, part, seconds) {
  const times = Array.from({ length: keys }, (_, i) => (10 * i) / (keys - 1));
  const values = times.flatMap((t) => {
    const half = (t / 10) * (Math.PI / 4);
    return [0, 0, Math.sin(half), Math.cos(half)];
  });
  const track = new THREE.QuaternionKeyframeTrack('.quaternion', times, values);
  let clip = new THREE.AnimationClip('turn', -1, [track]);
  if (part) clip = THREE.AnimationUtils.subclip(clip, 'part', 60, 120, 30);  // 2 s to 4 s
  const bone = new THREE.Bone();
  const mixer = new THREE.AnimationMixer(bone);
  mixer.clipAction(clip).play();
  mixer.setTime(seconds);
  return Math.round(2 * Math.atan2(bone.quaternion.z, bone.quaternion.w) * (180 / Math.PI));
}
for (const keys of [301, 2]) {
  console.log(`${keys} keys: clip at 3 s ${angle(keys, false, 3)} degrees, ` +
      `its part from 2 s at 1 s ${angle(keys, true, 1)}`);
}
JS
node part.mjs | tee seen
printf '%s\n' '301 keys: clip at 3 s 27 degrees, its part from 2 s at 1 s 27' \
  '2 keys: clip at 3 s 27 degrees, its part from 2 s at 1 s 0' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
