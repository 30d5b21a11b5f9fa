#!/bin/sh
# SPDX-License-Identifier: MIT
# glMatrix 3.4.4 (npm gl-matrix): mat4.getRotation and mat4.decompose give a wrong rotation of a matrix
# that stretches one axis more than another.
#
# Expected: of a matrix made by fromRotationTranslationScale, getRotation gives the rotation,
# getTranslation the translation and getScaling the scale; getRotation divides by the scale for that.
# Seen: it divides each column by all three scales, one for each row, instead of by its own. With scales
# of 1, 1, 1 or 2, 2, 2 all is well. With 1, 2, 0.5 a turn of 40 degrees about 1, 2, 3 comes out as
# another quaternion, not even of length 1, and 23 degrees off when it is normalised after. A limb that is
# stretched to a character's size has such a matrix. three.js divides by columns, and so
# does pull request 501 of toji/gl-matrix, which is not in 3.4.4.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . gl-matrix@3.4.4 three@0.187.0 >/dev/null
cat >stretch.mjs <<'JS'
import { mat4, quat, vec3 } from 'gl-matrix';
import * as THREE from 'three';

const degrees = (radians) => Math.round((radians * 180) / Math.PI);
const axis = vec3.normalize(vec3.create(), [1, 2, 3]);
const turn = quat.setAxisAngle(quat.create(), axis, (40 * Math.PI) / 180);
// The angle between `turn` and what was got back, both of length 1.
const off = (got) => {
  const cosine = Math.abs(quat.dot(turn, quat.normalize(quat.create(), got)));
  return degrees(2 * Math.acos(Math.min(1, cosine)));
};
for (const scale of [[1, 1, 1], [2, 2, 2], [1, 2, 0.5]]) {
  const matrix = mat4.fromRotationTranslationScale(mat4.create(), turn, [0, 0, 0], scale);
  const got = mat4.getRotation(quat.create(), matrix);
  const decomposed = quat.create();
  mat4.decompose(decomposed, vec3.create(), vec3.create(), matrix);
  const three = new THREE.Quaternion();
  new THREE.Matrix4().fromArray(matrix).decompose(new THREE.Vector3(), three, new THREE.Vector3());
  console.log(`scale ${scale}: length ${quat.length(got).toFixed(2)}, getRotation ${off(got)} degrees off, ` +
      `decompose ${off(decomposed)}, three.js ${off(three.toArray())}`);
}
JS
node stretch.mjs | tee seen
printf '%s\n' \
  'scale 1,1,1: length 1.00, getRotation 0 degrees off, decompose 0, three.js 0' \
  'scale 2,2,2: length 1.00, getRotation 0 degrees off, decompose 0, three.js 0' \
  'scale 1,2,0.5: length 1.06, getRotation 23 degrees off, decompose 23, three.js 0' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
