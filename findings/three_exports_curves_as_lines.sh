#!/bin/sh
# SPDX-License-Identifier: MIT
# three.js 0.187.0 (npm three): GLTFExporter writes a smooth track as a linear one.
#
# Expected: glTF has CUBICSPLINE, and a Hermite curve through the keys can be written as one. An
# exporter that does not do so samples the curve, as it does for other things, or warns.
# Seen: a track with InterpolateSmooth keeps its few keys and says LINEAR, without a warning. So the
# clip that was edited and the clip in the file are at the same places at the keys only: a jump of 1
# m with keys a second apart differs by 6 cm on its way down and by 12 cm after the landing.
# InterpolateDiscrete is kept, as STEP, and a cubic track is kept if a glTF file brought it.
# Flinch: writes its .glb itself, with a key on every frame, which are as good as linear.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 >/dev/null
cat >jump.mjs <<'JS'
import * as THREE from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

globalThis.FileReader = class {  // Node has none
  readAsArrayBuffer(blob) {
    blob.arrayBuffer().then((buffer) => {
      this.result = buffer;
      this.onloadend();
    });
  }
};
console.warn = (...words) => console.log('warning:', ...words);

function heights(clip, root) {
  const mixer = new THREE.AnimationMixer(root);
  mixer.clipAction(clip).play();
  return [0.5, 1, 1.5, 2, 2.5].map((time) => {
    mixer.setTime(time);
    return root.getObjectByName('hip').position.y.toFixed(3);
  });
}

const hip = new THREE.Object3D();
hip.name = 'hip';
const scene = new THREE.Scene().add(hip);
const clip = new THREE.AnimationClip('jump', -1, [new THREE.VectorKeyframeTrack('hip.position',
    [0, 1, 2, 3], [0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0], THREE.InterpolateSmooth)]);
console.log('edited:', ...heights(clip, scene));
const file = await new GLTFExporter().parseAsync(scene, { animations: [clip], binary: true });
const read = await new GLTFLoader().parseAsync(file, '');
console.log('in the file:', ...heights(read.animations[0], read.scene));
JS
node jump.mjs | tee seen
printf '%s\n' 'edited: 0.500 1.000 0.563 0.000 -0.125' 'in the file: 0.500 1.000 0.500 0.000 0.000' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
