#!/bin/sh
# SPDX-License-Identifier: MIT
# bvh-loader 0.0.9 (npm): of a .bvh's angles those of joints are in degrees and those of end sites in
# radians, and a joint that moves by itself moves along the world's axes.
#
# Expected: frame_pose() answers with places and angles of one unit and one frame; a joint's position
# channels are along the axes of its parent, as its OFFSET is.
# Seen: below hips turned by 90 degrees the neck's angle is 90 and that of its end site 1.57, in the same
# array. A chest that moves 10 along its parent's Y axis moves 10 along the world's: it is at 0, 10 where
# -10, 0 is right. fps is a whole number: 100 frames of 0.4 s, 40 s, are 33 s at its 3 per second.
# Flinch: its reader of .bvh turns the position channels of any joint with the joint's parent, and keeps
# the frame time.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . bvh-loader@0.0.9 >/dev/null
cp node_modules/bvh-loader/module/bvh-loader.js loader.mjs  # its index needs a bundler
cat >pose.mjs <<'JS'
import { MEBvh } from './loader.mjs';

const six = 'Xposition Yposition Zposition Zrotation Xrotation Yrotation';
const text = `HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 ${six}
  JOINT Chest
  {
    OFFSET 0 0 0
    CHANNELS 6 ${six}
    JOINT Neck
    {
      OFFSET 0 5 0
      CHANNELS 3 Zrotation Xrotation Yrotation
      End Site
      {
        OFFSET 0 2 0
      }
    }
  }
}
MOTION
Frames: 1
Frame Time: 0.4
0 0 0 90 0 0 0 10 0 0 0 0 0 0 0
`;
// The loader fetches its text, and shows it on a page if there is one.
globalThis.fetch = async () => ({ text: async () => text });
globalThis.document = { createElement: () => ({ innerHTML: '' }), getElementById: () => null };
const bvh = new MEBvh();
await bvh.parse_file('figure.bvh');
const [places, angles] = bvh.frame_pose(0);
bvh.joint_names().forEach((name, i) => {
  const [x, y] = places[i];
  console.log(`${name}: at ${x.toFixed(0)}, ${y.toFixed(0)}, turned by ${angles[i][2].toFixed(2)}`);
});
console.log(`frames per second: ${bvh.fps}`);
JS
node pose.mjs | tee seen
printf '%s\n' 'Hips: at 0, 0, turned by 90.00' 'Chest: at 0, 10, turned by 90.00' \
  'Neck: at -5, 10, turned by 90.00' 'Neck_end: at -7, 10, turned by 1.57' \
  'frames per second: 3' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
