#!/bin/sh
# SPDX-License-Identifier: MIT
# Babylon.js 9.28.0 (npm @babylonjs/core and @babylonjs/serializers): in the .glb that it exports, what turns once
# around stands still, and what speeds up goes evenly.
#
# Expected: Babylon.js animates Euler angles and eases between keys, and glTF has neither, so that the
# exporter writes keys in between, as many as it takes, or warns.
# Seen: each key becomes one of the file. Angles 0 and 360 degrees are the same rotation, so the file's
# spin has two equal keys; a turn by 270 degrees goes 90 the other way. An easing function is left out: halfway
# through a jump that eases in, which is at 0.13 m, the file is at 0.50 m. A third of the way between two Euler
# poses a joint is 12 degrees from where the scene has it. No warning for any of them.
# Flinch: writes its .glb itself, with a key on every frame.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . @babylonjs/core@9.28.0 @babylonjs/serializers@9.28.0 \
  three@0.187.0 >/dev/null
cat >scene.mjs <<'JS'
import { Animation, AnimationGroup, CubicEase, FreeCamera, NullEngine, Quaternion, Scene, TransformNode,
  Vector3 } from '@babylonjs/core';
import { GLTF2Export } from '@babylonjs/serializers';
import { AnimationMixer } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

console.warn = (...words) => console.log('warning:', ...words);
console.error = console.warn;
const scene = new Scene(new NullEngine());
scene.useRightHandedSystem = true;
new FreeCamera('camera', new Vector3(0, 0, 5), scene);
const clip = new AnimationGroup('clip', scene);
// A node whose property goes to a value in 60 frames of 1/60 s.
function move(name, property, last, easing) {
  const animation = new Animation(name, property, 60, Animation.ANIMATIONTYPE_VECTOR3);
  animation.setKeys([{ frame: 0, value: Vector3.Zero() }, { frame: 60, value: last }]);
  if (easing) animation.setEasingFunction(easing);
  clip.addTargetedAnimation(animation, new TransformNode(name, scene));
}
move('spin', 'rotation', new Vector3(0, 2 * Math.PI, 0));
move('back', 'rotation', new Vector3(0, 1.5 * Math.PI, 0));
move('joint', 'rotation', new Vector3(1.2, 1.5, 0));
move('jump', 'position', new Vector3(0, 1, 0), new CubicEase());
const file = await GLTF2Export.GLBAsync(scene, 'scene');
const glb = file.files['scene.glb'];
const root = await new GLTFLoader().parseAsync(await glb.arrayBuffer(), '');
const mixer = new AnimationMixer(root.scene);
mixer.clipAction(root.animations[0]).play();
clip.start();
clip.pause();
for (const [time, ...names] of [[0.25, 'spin', 'back'], [1 / 3, 'joint'], [0.5, 'jump']]) {
  mixer.setTime(time);
  clip.goToFrame(time * 60);
  for (const name of names) {
    const node = scene.getNodeByName(name);
    const other = root.scene.getObjectByName(name);
    const there = Quaternion.FromEulerVector(node.rotation);
    const angle = (q) => Math.round(2 * Math.atan2(q.y, q.w) * 180 / Math.PI) + 0;
    const apart = 2 * Math.acos(Math.min(1, Math.abs(Quaternion.Dot(there,
        new Quaternion(...other.quaternion.toArray()))))) * 180 / Math.PI;
    if (name === 'jump') {
      console.log(`${name}: at ${node.position.y.toFixed(2)} m, in the file at ${other.position.y.toFixed(2)}`);
    } else if (name === 'joint') {
      console.log(`${name}: in the file ${apart.toFixed(0)} degrees from the scene's`);
    } else {
      console.log(`${name}: at ${angle(there)} degrees, in the file at ${angle(other.quaternion)}`);
    }
  }
}
process.exit();
JS
node scene.mjs | grep -v '^BJS' | tee seen
cmp -s - seen <<'TEXT' || {
spin: at 90 degrees, in the file at 0
back: at 68 degrees, in the file at -22
joint: in the file 12 degrees from the scene's
jump: at 0.13 m, in the file at 0.50
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
