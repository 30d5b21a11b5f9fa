#!/bin/sh
# SPDX-License-Identifier: MIT
# Assimp 5.2.5 (Debian libassimp-dev 5.2.5~ds0-1+b1): a stepped and a cubic .gltf animation are read
# as the keys of a linear one.
#
# Expected: a sampler's interpolation is part of its motion. A reader whose keys have no field for
# it, as aiQuatKey of this version, samples a curve until lines are as good, adds a key before each
# step, or says that it cannot.
# Seen: STEP and CUBICSPLINE give the same two keys as LINEAR; tangents are dropped. A knee that
# stays straight for a second and then is bent by 90 degrees bends by 45 halfway, where three.js
# 0.187.0 (npm three) has 0 of the same file, and one with an ease is 9 degrees ahead at a quarter
# of the way. Nothing in the scene tells the three files apart.
# Flinch: imports .gltf by Assimp, so it reads all three as linear too; docs/importing.md says so.
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
cat >write.mjs <<'JS'
import { readFileSync, writeFileSync } from 'fs';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

// One joint, which turns by 90 degrees about Z in 1 s. A cubic key has its tangents around it, here 0.
const from = [0, 0, 0, 1];
const to = [0, 0, Math.SQRT1_2, Math.SQRT1_2];
const none = [0, 0, 0, 0];
for (const interpolation of ['LINEAR', 'STEP', 'CUBICSPLINE']) {
  const keys = interpolation === 'CUBICSPLINE' ? [none, from, none, none, to, none] : [from, to];
  const numbers = Float32Array.from([0, 1, ...keys.flat()]);
  writeFileSync(`${interpolation}.gltf`, JSON.stringify({
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: 'knee' }],
    buffers: [{
      byteLength: numbers.byteLength,
      uri: 'data:application/octet-stream;base64,' + Buffer.from(numbers.buffer).toString('base64'),
    }],
    bufferViews: [{ buffer: 0, byteLength: 8 },
      { buffer: 0, byteOffset: 8, byteLength: numbers.byteLength - 8 }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 2, type: 'SCALAR', min: [0], max: [1] },
      { bufferView: 1, componentType: 5126, count: keys.length, type: 'VEC4' },
    ],
    animations: [{
      samplers: [{ input: 0, output: 1, interpolation }],
      channels: [{ sampler: 0, target: { node: 0, path: 'rotation' } }],
    }],
  }));
  globalThis.ProgressEvent = class {};  // Node has none
  const { scene, animations } =
      await new GLTFLoader().parseAsync(readFileSync(`${interpolation}.gltf`, 'utf8'), '');
  const mixer = new THREE.AnimationMixer(scene);
  mixer.clipAction(animations[0]).play();
  const bent = [0.25, 0.5].map((time) => {
    mixer.setTime(time);
    const { z, w } = scene.getObjectByName('knee').quaternion;
    return `${(2 * Math.atan2(z, w) * 180 / Math.PI).toFixed(1)} at ${time} s`;
  });
  console.log(`three.js, ${interpolation}: ${bent.join(', ')}`);
}
JS
cat >read.cpp <<'CPP'
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <cmath>
#include <cstdio>

int main(int, char** files) {
  while (*++files) {
    Assimp::Importer importer;
    const aiScene* const scene = importer.ReadFile(*files, 0);
    const aiNodeAnim* const joint = scene->mAnimations[0]->mChannels[0];
    std::printf("Assimp, %s:", *files);
    for (unsigned key = 0; key < joint->mNumRotationKeys; ++key) {
      const aiQuatKey& at = joint->mRotationKeys[key];
      std::printf(" %.1f at %.0f ms", 2 * std::atan2(at.mValue.z, at.mValue.w) * 180 / M_PI, at.mTime);
    }
    std::printf(", and no more\n");
  }
}
CPP
g++ -std=c++17 -O1 -I usr/include read.cpp -o read -L "$library" -lassimp
{
  node write.mjs
  LD_LIBRARY_PATH=$library ./read LINEAR.gltf STEP.gltf CUBICSPLINE.gltf
} | tee seen
printf '%s\n' 'three.js, LINEAR: 22.5 at 0.25 s, 45.0 at 0.5 s' \
  'three.js, STEP: 0.0 at 0.25 s, 0.0 at 0.5 s' \
  'three.js, CUBICSPLINE: 13.2 at 0.25 s, 45.0 at 0.5 s' \
  'Assimp, LINEAR.gltf: 0.0 at 0 ms 90.0 at 1000 ms, and no more' \
  'Assimp, STEP.gltf: 0.0 at 0 ms 90.0 at 1000 ms, and no more' \
  'Assimp, CUBICSPLINE.gltf: 0.0 at 0 ms 90.0 at 1000 ms, and no more' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
