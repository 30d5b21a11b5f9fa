#!/bin/sh
# SPDX-License-Identifier: MIT
# three.js 0.187.0 (npm three): FBXLoader turns a joint backward between keys that are 180 degrees or more
# apart, and the clip ends before the file does.
#
# Expected: a .fbx keeps curves of Euler angles, so from a key of 0 degrees at 0 s to one of 200 at 1 s
# and one of 400 at 2 s a figure spins by 200 degrees per second, as from 0 to 170 and 340 it does by 170.
# Seen: from 180 degrees on the loader puts keys between these two, by slerp of quaternions after it has
# changed a sign so that slerp takes the short way. So 200 degrees become -160, 350 become -10 and a full
# turn stands still. It also leaves the last key out and sets the first one twice: of 2 s the clip lasts
# 1.9 s for 200 degrees and 1.5 s for 360. A pirouette or a somersault that was made with few keys loads
# as a slow turn to the other side; motion capture with a key on every frame is right. Pull request
# 27057 (r159) brought the slerp, for files whose angles jump from 180 to -180.
# Flinch: imports .fbx by Assimp, which puts its keys between such keys on the long way.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . three@0.187.0 >/dev/null
cat >spin.mjs <<'JS'
import * as THREE from 'three';
import { FBXLoader } from 'three/addons/loaders/FBXLoader.js';

const ticks = (seconds) => seconds * 46186158000;
const curve = (id, angles) => `  AnimationCurve: ${id}, "AnimCurve::", "" {
    KeyTime: *3 {
      a: ${[0, 1, 2].map(ticks).join()}
    }
    KeyValueFloat: *3 {
      a: ${angles.join()}
    }
  }
`;
// A file of one joint that turns about X by `angle` degrees in each second.
const file = (angle) => `; FBX 7.4.0 project file
FBXHeaderExtension:  {
  FBXHeaderVersion: 1003
  FBXVersion: 7400
}
Objects:  {
  Model: 100, "Model::hip", "Null" {
    Version: 232
  }
  AnimationStack: 200, "AnimStack::spin", "" {
  }
  AnimationLayer: 300, "AnimLayer::base", "" {
  }
  AnimationCurveNode: 400, "AnimCurveNode::R", "" {
  }
${curve(500, [0, angle, 2 * angle])}${curve(501, [0, 0, 0])}${curve(502, [0, 0, 0])}}
Connections:  {
  C: "OO",100,0
  C: "OO",300,200
  C: "OO",400,300
  C: "OP",400,100, "Lcl Rotation"
  C: "OP",500,400, "d|X"
  C: "OP",501,400, "d|Y"
  C: "OP",502,400, "d|Z"
}
`.replace(/^ +/gm, (spaces) => '\t'.repeat(spaces.length / 2));
for (const angle of [170, 200, 350, 360]) {
  const scene = new FBXLoader().parse(new TextEncoder().encode(file(angle)).buffer, '');
  const [clip] = scene.animations;
  const mixer = new THREE.AnimationMixer(scene);
  mixer.clipAction(clip).play();
  mixer.setTime(0.5);
  const { x, w } = scene.getObjectByName('hip').quaternion;
  const degrees = Math.round((2 * Math.atan2(x * Math.sign(w), Math.abs(w)) * 180) / Math.PI) + 0;
  console.log(`${angle} degrees per second: ${degrees} degrees after 0.5 s, ` +
      `${clip.duration.toFixed(1)} s of 2 s`);
}
JS
node spin.mjs | tee seen
printf '%s\n' '170 degrees per second: 85 degrees after 0.5 s, 2.0 s of 2 s' \
  '200 degrees per second: -80 degrees after 0.5 s, 1.9 s of 2 s' \
  '350 degrees per second: -5 degrees after 0.5 s, 1.5 s of 2 s' \
  '360 degrees per second: 0 degrees after 0.5 s, 1.5 s of 2 s' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
