#!/bin/sh
# SPDX-License-Identifier: MIT
# three.js 0.187.0 (npm three): a .bvh whose joints have a namespace loads and does not move.
#
# Expected: names are only names: a file with joints "rig:Hips" moves as one with "Hips" does.
# Seen: BVHLoader names bones and tracks as the file does. The animation mixer reads a track's name
# as a path, in which a colon or slash ends a folder, and looks for "Hips", which no bone is called.
# Parsing throws nothing; each track is dropped with a line on the console, and the figure keeps its
# rest pose. The loaders of .glb and .fbx strip such characters from bones and tracks alike, so the
# same rig in those formats moves. Tools that keep namespaces (rig:Hips) write such .bvh files.
# Flinch: takes a prefix that all joints share off before it looks for roles.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 >/dev/null
cat >move.mjs <<'JS'
import { AnimationMixer } from 'three';
import { BVHLoader } from 'three/examples/jsm/loaders/BVHLoader.js';

const file = (prefix) => `HIERARCHY
ROOT ${prefix}Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  End Site
  {
    OFFSET 0 10 0
  }
}
MOTION
Frames: 2
Frame Time: 0.5
0 0 0 0 0 0
0 90 0 0 0 0
`;
for (const prefix of ['', 'rig:', 'rig_']) {
  const { skeleton, clip } = new BVHLoader().parse(file(prefix));
  const mixer = new AnimationMixer(skeleton.bones[0]);
  mixer.clipAction(clip).play();
  mixer.setTime(0.25);
  console.log(`${prefix}Hips rises to ${skeleton.bones[0].position.y}`);
}
JS
node move.mjs 2>console | tee seen
printf 'Hips rises to 45\nrig:Hips rises to 0\nrig_Hips rises to 45\n' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
