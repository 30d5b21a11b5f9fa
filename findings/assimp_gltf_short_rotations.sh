#!/bin/sh
# SPDX-License-Identifier: MIT
# Assimp 5.2.5 (Debian libassimp-dev 5.2.5~ds0-1+b1): rotations that a .glb keeps as 16-bit integers
# come out as NaN.
#
# Expected: glTF 2.0 lets an animation keep its quaternions as normalized integers, and gltfpack (npm
# gltfpack 1.3.0) writes them so, even without quantization (-noq). Assimp reads glTF 2.0, so it
# converts them, or it refuses the file.
# Seen: it takes the bytes of the integers for floats. The file is read without an error, all keys are
# there at their times, and each quaternion is NaN or as large as 1e+16. Khronos' validator
# (gltf-validator 2.0.0-dev.3.10) finds no error in the file.
# Flinch: imports .glb by Assimp, so a file for it must keep its rotations as floats.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . gltfpack@1.3.0 \
  gltf-validator@2.0.0-dev.3.10 >/dev/null
for package in libassimp-dev libassimp5; do
  apt-get -o APT::Sandbox::User=root download -q "$package=5.2.5~ds0-1+b1" >/dev/null
  dpkg-deb -x "$package"_5.2.5*.deb .
done
library=$(dirname "$(find . -name 'libassimp.so' | head -n 1)")
cat >write.js <<'JS'
// One node, which turns by 90 degrees about Z in 1 s.
const half = Math.SQRT1_2;
const numbers = Float32Array.of(0, 1, /* from */ 0, 0, 0, 1, /* to */ 0, 0, half, half);
require('fs').writeFileSync('turn.gltf', JSON.stringify({
  asset: { version: '2.0' },
  scene: 0,
  scenes: [{ nodes: [0] }],
  nodes: [{ name: 'Hips' }],
  buffers: [{
    byteLength: numbers.byteLength,
    uri: 'data:application/octet-stream;base64,' + Buffer.from(numbers.buffer).toString('base64'),
  }],
  bufferViews: [{ buffer: 0, byteLength: 8 }, { buffer: 0, byteOffset: 8, byteLength: 32 }],
  accessors: [
    { bufferView: 0, componentType: 5126, count: 2, type: 'SCALAR', min: [0], max: [1] },
    { bufferView: 1, componentType: 5126, count: 2, type: 'VEC4' },
  ],
  animations: [{
    samplers: [{ input: 0, output: 1 }],
    channels: [{ sampler: 0, target: { node: 0, path: 'rotation' } }],
  }],
}));
JS
cat >check.js <<'JS'
const bytes = new Uint8Array(require('fs').readFileSync('packed.glb'));
require('gltf-validator').validateBytes(bytes).then(
    (report) => console.log(`validator: ${report.issues.numErrors} errors in packed.glb`));
JS
cat >read.cpp <<'CPP'
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdio>

int main(int, char** files) {
  while (*++files) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(*files, 0);
    if (!scene) return std::puts(importer.GetErrorString()), 1;
    const aiNodeAnim& channel = *scene->mAnimations[0]->mChannels[0];
    int unit = 0;
    for (unsigned i = 0; i < channel.mNumRotationKeys; ++i) {
      const aiQuaternion& q = channel.mRotationKeys[i].mValue;
      unit += std::abs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) < 1e-3F;
    }
    std::printf("%s: %u keys, %d of them unit quaternions\n", *files, channel.mNumRotationKeys,
                unit);
  }
}
CPP
g++ -I usr/include read.cpp -o read -L "$library" -lassimp \
  -Wl,--unresolved-symbols=ignore-in-shared-libs
node write.js
node node_modules/gltfpack/cli.js -i turn.gltf -o packed.glb
{
  node check.js
  LD_LIBRARY_PATH=$library ./read turn.gltf packed.glb
} | tee seen
grep -q '^validator: 0 errors' seen &&
  grep -qx 'turn.gltf: 2 keys, 2 of them unit quaternions' seen &&
  grep -qx 'packed.glb: 31 keys, 0 of them unit quaternions' seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
