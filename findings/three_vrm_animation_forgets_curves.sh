#!/bin/sh
# SPDX-License-Identifier: MIT
# @pixiv/three-vrm-animation 3.5.5 (npm): in a .vrma, a limb whose rotation is CUBICSPLINE gets quaternions of length
# 0, and one whose rotation is STEP moves smoothly.
#
# Expected: the movement of a .vrma is a glTF animation, whose samplers have three kinds of interpolation. Its
# loader reads it by three.js' GLTFLoader, which plays all three, so that the clip for a VRM figure does too.
# Seen: createVRMAnimationClip() makes new rotation tracks of the times and the numbers alone, which are
# linear. STEP is lost, and of CUBICSPLINE's three quaternions a key the tangent is taken for the
# rotation: flat tangents are zeros, and so are the bone's quaternions, which draw what hangs on it as one
# point. Neither is warned of. The position of the hips is cloned with its interpolation and is right.
# Flinch: writes .glb with linear keys on every frame, which a .vrma of it has too.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 @pixiv/three-vrm@3.5.5 \
  @pixiv/three-vrm-animation@3.5.5 >/dev/null
cat >kick.mjs <<'JS'
import { VRMHumanoid } from '@pixiv/three-vrm';
import { createVRMAnimationClip, VRMAnimationLoaderPlugin } from '@pixiv/three-vrm-animation';
import { AnimationMixer, Group, Object3D } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

globalThis.ProgressEvent = class {};
console.warn = (...words) => console.log('warning:', ...words);
// The bones that a VRM figure must have, each with its parent and its place in it.
const bones = { hips: [null, 0, 1, 0], spine: ['hips', 0, 0.2, 0], head: ['spine', 0, 0.4, 0] };
for (const [side, x] of [['left', 1], ['right', -1]]) {
  bones[`${side}UpperArm`] = ['spine', 0.2 * x, 0.3, 0];
  bones[`${side}LowerArm`] = [`${side}UpperArm`, 0.3 * x, 0, 0];
  bones[`${side}Hand`] = [`${side}LowerArm`, 0.3 * x, 0, 0];
  bones[`${side}UpperLeg`] = ['hips', 0.1 * x, -0.1, 0];
  bones[`${side}LowerLeg`] = [`${side}UpperLeg`, 0, -0.4, 0];
  bones[`${side}Foot`] = [`${side}LowerLeg`, 0, -0.4, 0];
}
const names = Object.keys(bones);

const turn = (degrees) => [Math.sin(degrees * Math.PI / 360), 0, 0, Math.cos(degrees * Math.PI / 360)];
function file(interpolation) {
  const flat = [0, 0, 0, 0];
  const keys = [turn(0), turn(60), turn(60)].flatMap((key) =>
    (interpolation === 'CUBICSPLINE' ? [flat, key, flat] : [key]));
  const numbers = Float32Array.from([0, 1, 2, ...keys.flat()]);
  return JSON.stringify({
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }],
    nodes: names.map((name) => ({
      name, translation: bones[name].slice(1),
      children: names.flatMap((child, i) => (bones[child][0] === name ? [i] : [])),
    })).map(({ children, ...node }) => (children.length ? { ...node, children } : node)),
    extensionsUsed: ['VRMC_vrm_animation'],
    extensions: { VRMC_vrm_animation: { specVersion: '1.0', humanoid: {
      humanBones: Object.fromEntries(names.map((name, node) => [name, { node }])) } } },
    buffers: [{ byteLength: numbers.byteLength,
      uri: `data:application/octet-stream;base64,${Buffer.from(numbers.buffer).toString('base64')}` }],
    bufferViews: [{ buffer: 0, byteLength: 12 },
      { buffer: 0, byteOffset: 12, byteLength: numbers.byteLength - 12 }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'SCALAR', min: [0], max: [2] },
      { bufferView: 1, componentType: 5126, count: keys.length, type: 'VEC4' }],
    animations: [{ samplers: [{ input: 0, output: 1, interpolation }],
      channels: [{ sampler: 0, target: { node: names.indexOf('leftUpperLeg'), path: 'rotation' } }] }],
  });
}
function figure() {
  const nodes = {};
  for (const name of names) {
    nodes[name] = new Object3D();
    nodes[name].name = `my ${name}`;
    nodes[name].position.set(...bones[name].slice(1));
    nodes[bones[name][0]]?.add(nodes[name]);
  }
  const scene = new Group().add(nodes.hips);
  scene.updateMatrixWorld(true);
  const humanoid = new VRMHumanoid(Object.fromEntries(names.map((name) => [name, { node: nodes[name] }])));
  scene.add(humanoid.normalizedHumanBonesRoot);
  return { scene, humanoid, meta: { metaVersion: '1' }, leg: nodes.leftUpperLeg };
}
const tell = (mixer, leg, done) => [0.25, 0.5, 1.5].map((time) => {
  mixer.setTime(time);
  done();
  const { x, w } = leg.quaternion;
  return leg.quaternion.length() > 0.5 ? (2 * Math.atan2(x, w) * 180 / Math.PI).toFixed(0) : 'of length 0';
}).join(', ');
for (const interpolation of ['LINEAR', 'STEP', 'CUBICSPLINE']) {
  const loader = new GLTFLoader().register((parser) => new VRMAnimationLoaderPlugin(parser));
  const { scene, animations, userData } = await loader.parseAsync(file(interpolation), '');
  const vrm = figure();
  const own = new AnimationMixer(scene);
  own.clipAction(animations[0]).play();
  const mixer = new AnimationMixer(vrm.scene);
  mixer.clipAction(createVRMAnimationClip(userData.vrmAnimations[0], vrm)).play();
  console.log(`${interpolation}: the file's leg at ${tell(own, scene.getObjectByName('leftUpperLeg'), () => {})}`
    + `; the figure's at ${tell(mixer, vrm.leg, () => vrm.humanoid.update())}`);
}
JS
node kick.mjs | tee seen
cmp -s - seen <<'TEXT' || {
LINEAR: the file's leg at 15, 30, 60; the figure's at 15, 30, 60
STEP: the file's leg at 0, 0, 60; the figure's at 15, 30, 60
CUBICSPLINE: the file's leg at 9, 30, 60; the figure's at of length 0, of length 0, of length 0
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
