#!/bin/sh
# SPDX-License-Identifier: MIT
# glTF-Transform 4.5.1 (npm @gltf-transform/functions, with meshoptimizer 1.3.0): meshopt() changes smooth
# rotations by degrees, and moves a figure by the more the farther it stands from the origin.
#
# Expected: meshopt() compresses a file; its default level is lossy as quantization is, by parts of a
# millimetre and of a degree, for each kind of animation.
# Seen: each element of a rotation is coded as a unit quaternion. Of a CUBICSPLINE animation two in three
# are tangents, which have another length, and zero where a movement is eased in and out: they become of
# length 1. A head that nods by 40 degrees in 4 s, with a key at each end, is up to 45 degrees off on
# its way, without an error or a warning. Translations keep about 12 bits of their largest part: hips are
# 0.4 mm off at 1 m, 3.6 mm at 10 m and 31 mm at 100 m, so that feet slide. Linear rotations and the level
# "medium" are right.
# Flinch: its .glb has linear animations only; who compresses it passes level: "medium".
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . @gltf-transform/core@4.5.1 \
  @gltf-transform/extensions@4.5.1 @gltf-transform/functions@4.5.1 meshoptimizer@1.3.0 >/dev/null
cat >nod.mjs <<'JS'
import { Document, NodeIO } from '@gltf-transform/core';
import { EXTMeshoptCompression, KHRMeshQuantization } from '@gltf-transform/extensions';
import { meshopt } from '@gltf-transform/functions';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';

await MeshoptDecoder.ready;
await MeshoptEncoder.ready;
const io = new NodeIO().registerExtensions([EXTMeshoptCompression, KHRMeshQuantization])
    .registerDependencies({ 'meshopt.decoder': MeshoptDecoder, 'meshopt.encoder': MeshoptEncoder });

// The elements of an animation's output as meshopt() leaves them in a .glb.
async function pack(path, interpolation, times, elements, level) {
  const document = new Document().setLogger({ debug() {}, info() {}, warn() {}, error: console.error });
  const buffer = document.createBuffer();
  const accessor = (type, numbers) =>
      document.createAccessor().setType(type).setArray(Float32Array.from(numbers)).setBuffer(buffer);
  const sampler = document.createAnimationSampler().setInterpolation(interpolation)
      .setInput(accessor('SCALAR', times))
      .setOutput(accessor(path === 'rotation' ? 'VEC4' : 'VEC3', elements.flat()));
  const node = document.createNode('head');
  document.createScene().addChild(node);
  document.createAnimation('nod').addSampler(sampler).addChannel(document.createAnimationChannel()
      .setTargetNode(node).setTargetPath(path).setSampler(sampler));
  await document.transform(meshopt({ encoder: MeshoptEncoder, ...level }));
  const read = await io.readBinary(await io.writeBinary(document));
  const output = read.getRoot().listAnimations()[0].listSamplers()[0].getOutput();
  return Array.from({ length: output.getCount() }, (_, i) => output.getElement(i, []));
}
const about = (degrees) => [Math.sin(degrees * Math.PI / 360), 0, 0, Math.cos(degrees * Math.PI / 360)];
const degrees = ([x, , , w]) => 2 * Math.atan2(x * Math.sign(w), Math.abs(w)) * 180 / Math.PI;
const mix = (parts) => [0, 1, 2, 3].map((axis) => parts.reduce((sum, [element, weight]) =>
    sum + weight * element[axis], 0));
// The cubic spline of glTF 2.0, appendix C, between two keys that are 4 s apart.
const smooth = (keys, u) => mix([[keys[1], 2 * u ** 3 - 3 * u ** 2 + 1],
  [keys[2], 4 * (u ** 3 - 2 * u ** 2 + u)], [keys[4], 3 * u ** 2 - 2 * u ** 3],
  [keys[3], 4 * (u ** 3 - u ** 2)]]);
// A sign has no meaning in a quaternion, but between two of them.
const straight = ([from, to], u) => mix([[from, 1 - u],
  [to, u * Math.sign(from.reduce((sum, x, axis) => sum + x * to[axis], 0))]]);
const zero = [0, 0, 0, 0];
const nods = {
  LINEAR: [[about(0), about(40)], straight],
  CUBICSPLINE: [[zero, about(0), zero, zero, about(40), zero], smooth],
};
for (const level of [{}, { level: 'medium' }]) {
  const name = level.level ?? 'default';
  for (const [interpolation, [keys, play]] of Object.entries(nods)) {
    const packed = await pack('rotation', interpolation, [0, 4], keys, level);
    const parts = Array.from({ length: 101 }, (_, i) => i / 100);
    const worst = Math.max(...parts.map((u) => Math.abs(degrees(play(packed, u)) - degrees(play(keys, u)))));
    console.log(`${name}, ${interpolation} nod: ${worst.toFixed(1)} degrees off`);
  }
  for (const away of [1, 10, 100]) {
    const times = Array.from({ length: 21 }, (_, i) => i / 10);
    const walk = times.map((time) => [away + 0.1 * Math.sin(time), 1, 0]);
    const packed = await pack('translation', 'LINEAR', times, walk, level);
    const worst = Math.max(...packed.map(([x], i) => Math.abs(x - walk[i][0])));
    console.log(`${name}, hips at ${away} m: ${(1000 * worst).toFixed(1)} mm off`);
  }
}
JS
node nod.mjs | tee seen
cmp -s - seen <<'TEXT' || {
default, LINEAR nod: 0.0 degrees off
default, CUBICSPLINE nod: 45.4 degrees off
default, hips at 1 m: 0.4 mm off
default, hips at 10 m: 3.6 mm off
default, hips at 100 m: 30.7 mm off
medium, LINEAR nod: 0.0 degrees off
medium, CUBICSPLINE nod: 0.0 degrees off
medium, hips at 1 m: 0.0 mm off
medium, hips at 10 m: 0.0 mm off
medium, hips at 100 m: 0.0 mm off
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
