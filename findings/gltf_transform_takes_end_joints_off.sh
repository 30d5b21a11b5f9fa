#!/bin/sh
# SPDX-License-Identifier: MIT
# glTF-Transform 4.5.1 (npm @gltf-transform/functions): functions that flatten or join meshes
# take hands, feet and the top of the head off a skeleton without meshes.
#
# Expected: flatten() moves meshes to the root and join() joins meshes, so a file
# of joints and an animation, as motion capture tools write it, keeps its joints.
# Seen: flatten and join end with a prune, which removes every leaf that nothing refers to: the end
# joints, as they have no keys of their own. Those that were before them are leaves then, and go where
# they have no keys, up to the last joint that moves. Lengths of forearms, feet and head are lost, and
# a retarget by names misses its joints. Joints of a skin stay. The option cleanup: false keeps all, as
# does prune({ keepLeaves: true }).
# Flinch: its .glb has a skin of all joints.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . @gltf-transform/core@4.5.1 \
  @gltf-transform/functions@4.5.1 >/dev/null
cat >joints.mjs <<'JS'
import { Document } from '@gltf-transform/core';
import { dedup, flatten, join, prune } from '@gltf-transform/functions';

// An arm whose upper arm is animated, as by motion capture.
function arm() {
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = (type, numbers) =>
      document.createAccessor().setType(type).setArray(new Float32Array(numbers)).setBuffer(buffer);
  const joints = ['upper arm', 'forearm', 'hand'].map((name) =>
      document.createNode(name).setTranslation([0.3, 0, 0]));
  joints[0].addChild(joints[1]);
  joints[1].addChild(joints[2]);
  document.createScene().addChild(joints[0]);
  const sampler = document.createAnimationSampler().setInput(accessor('SCALAR', [0, 1]))
      .setOutput(accessor('VEC4', [0, 0, 0, 1, 0, 0, 1, 0]));
  const channel = document.createAnimationChannel().setTargetNode(joints[0])
      .setTargetPath('rotation').setSampler(sampler);
  document.createAnimation('wave').addSampler(sampler).addChannel(channel);
  return document;
}
const steps = { 'dedup()': dedup(), 'flatten()': flatten(), 'join()': join(),
  'join({ cleanup: false })': join({ cleanup: false }),
  'prune({ keepLeaves: true })': prune({ keepLeaves: true }) };
for (const [name, step] of Object.entries(steps)) {
  const document = arm();
  document.setLogger({ debug() {}, info() {}, warn() {}, error() {} });
  await document.transform(step);
  const kept = document.getRoot().listNodes().map((node) => node.getName());
  console.log(`${name} keeps ${kept.join(', ')}`);
}
JS
node joints.mjs | tee seen
printf '%s\n' 'dedup() keeps upper arm, forearm, hand' 'flatten() keeps upper arm' \
  'join() keeps upper arm' 'join({ cleanup: false }) keeps upper arm, forearm, hand' \
  'prune({ keepLeaves: true }) keeps upper arm, forearm, hand' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
