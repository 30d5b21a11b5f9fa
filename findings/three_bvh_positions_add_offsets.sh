#!/bin/sh
# SPDX-License-Identifier: MIT
# three.js 0.187.0 (npm three) and Assimp 5.2.5 (Debian libassimp-dev 5.2.5~ds0-1+b1): the same .bvh
# has bones of other lengths in each.
#
# Expected: a joint's position channels say where it is, in place of its OFFSET, or in addition to
# it, and readers agree which.
# Seen: three.js' BVHLoader adds the OFFSET to the position channels of every joint, root included;
# Assimp puts the channels in its place. A file whose joints all have six channels, as several
# exporters write it, has bones of twice their length in three.js, and hips at twice their height
# where the root has an OFFSET.
# Flinch: tells the two conventions apart by bone lengths; docs/importing.md says how. It writes a
# root OFFSET of zero and no position channels on other joints, which both readers take alike.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 >/dev/null
for package in libassimp-dev libassimp5; do
  apt-get -o APT::Sandbox::User=root download -q "$package=5.2.5~ds0-1+b1" >/dev/null
  dpkg-deb -x "$package"_5.2.5*.deb .
done
library=$(dirname "$(find . -name 'libassimp.so' | head -n 1)")
cat >figure.bvh <<'BVH'
HIERARCHY
ROOT Hips
{
  OFFSET 0 90 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Spine
  {
    OFFSET 0 10 0
    CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 10 0
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.0333333
0 90 0 0 0 0 0 10 0 0 0 0
0 90 0 0 0 0 0 10 0 0 0 0
BVH
cat >read.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { BVHLoader } from 'three/examples/jsm/loaders/BVHLoader.js';
const { clip } = new BVHLoader().parse(readFileSync('figure.bvh', 'utf8'));
const height = (name) => clip.tracks.find((track) => track.name === `${name}.position`).values[1];
console.log(`three.js: Hips at ${height('Hips')}, Spine ${height('Spine')} above`);
JS
cat >read.cpp <<'CPP'
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <cstdio>

int main() {
  Assimp::Importer importer;
  const aiAnimation& animation = *importer.ReadFile("figure.bvh", 0)->mAnimations[0];
  double hips = 0;
  double spine = 0;
  for (unsigned i = 0; i < animation.mNumChannels; ++i) {
    const aiNodeAnim& channel = *animation.mChannels[i];
    (channel.mNodeName == aiString("Hips") ? hips : spine) = channel.mPositionKeys[0].mValue.y;
  }
  std::printf("Assimp: Hips at %g, Spine %g above\n", hips, spine);
}
CPP
g++ -I usr/include read.cpp -o read -L "$library" -lassimp -Wl,--unresolved-symbols=ignore-in-shared-libs
{
  node read.mjs
  LD_LIBRARY_PATH=$library ./read
} | tee seen
grep -qx 'three.js: Hips at 180, Spine 20 above' seen &&
  grep -qx 'Assimp: Hips at 90, Spine 10 above' seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
