#!/bin/sh
# SPDX-License-Identifier: MIT
# three.js 0.187.0 (npm three): SkeletonUtils.retargetClip between skeletons of the same names makes a
# clip that stands still.
#
# Expected: options.names maps the bones of one skeleton to those of the other where they are called
# otherwise; where all have the same names it is not needed, and the clip moves the same bones.
# Seen: without names the new clip has a track for every bone and a key for every frame, and each key
# is the rest pose. retargetClip takes a bone's own name where names has none and writes its track, but
# retarget, which poses the bones before, does not and finds no bone. With names that map each bone
# to itself the clip moves as the source's.
# Flinch: retargets by roles itself; who brings its .glb to another skeleton in three.js gives names.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 >/dev/null
cat >retarget.mjs <<'JS'
import * as THREE from 'three';
import { retargetClip } from 'three/addons/utils/SkeletonUtils.js';

function figure() {
  const [hip, spine] = ['hip', 'spine'].map((name) => {
    const bone = new THREE.Bone();
    bone.name = name;
    bone.position.y = 1;
    return bone;
  });
  hip.add(spine);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute([0, 1, 0], 3));
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute([0, 0, 0, 0], 4));
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute([1, 0, 0, 0], 4));
  const mesh = new THREE.SkinnedMesh(geometry);
  mesh.add(hip);
  mesh.updateMatrixWorld(true);
  mesh.bind(new THREE.Skeleton([hip, spine]));
  return mesh;
}
const half = (30 / 2) * (Math.PI / 180);
const clip = new THREE.AnimationClip('bow', 1, [new THREE.QuaternionKeyframeTrack(
    '.bones[spine].quaternion', [0, 1], [0, 0, 0, 1, Math.sin(half), 0, 0, Math.cos(half)])]);
for (const names of [undefined, { hip: 'hip', spine: 'spine' }]) {
  const bow = retargetClip(figure(), figure(), clip, names ? { fps: 30, names } : { fps: 30 });
  const track = bow.tracks.find(({ name }) => name === '.bones[spine].quaternion');
  const degrees = Math.round(2 * Math.asin(track.values.at(-4)) * (180 / Math.PI));
  console.log(`${names ? 'with' : 'without'} names: ${bow.tracks.length} tracks, ` +
      `${track.times.length} keys, the spine ends at ${degrees} of 30 degrees`);
}
JS
node retarget.mjs | tee seen
printf '%s\n' 'without names: 3 tracks, 30 keys, the spine ends at 0 of 30 degrees' \
  'with names: 3 tracks, 30 keys, the spine ends at 30 of 30 degrees' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
