#!/bin/sh
# SPDX-License-Identifier: MIT
# Babylon.js 9.28.0 (npm @babylonjs/core): a.multiply(b) of quaternions is the turn b and then a, that
# of their matrices is a and then b.
#
# Expected: the product of two quaternions and the product of the matrices made of them in the same
# order are one rotation, as in three.js, glMatrix, Eigen and GLM.
# Seen: they are the rotations of the two orders. Babylon's matrices take vectors from the left, so the
# first factor turns first; its quaternions keep the order of mathematics, so the last one does. Code
# that is brought from matrices to quaternions, or that mixes them when it walks up a skeleton, is
# right for one joint and for joints about one axis, and wrong for an arm.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . @babylonjs/core@9.28.0 three@0.187.0 >/dev/null
cat >order.mjs <<'JS'
import { Matrix, Quaternion, Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import * as THREE from 'three';

const quarter = Math.PI / 2;
{
  const [x, y] = [new Vector3(1, 0, 0), new Vector3(0, 1, 0)];
  const [a, b] = [x, y].map((axis) => Quaternion.RotationAxis(axis, quarter));
  const matrix = (turn) => turn.toRotationMatrix(new Matrix());
  const tell = (name, { x, y, z }) =>
      console.log(`Babylon.js, ${name}: ${[x, y, z].map(Math.round).map((n) => n + 0).join(' ')}`);
  const z = new Vector3(0, 0, 1);
  tell('product of quaternions', z.applyRotationQuaternion(a.multiply(b)));
  tell('product of matrices', Vector3.TransformNormal(z, matrix(a).multiply(matrix(b))));
}
{
  const [a, b] = [[1, 0, 0], [0, 1, 0]].map((axis) =>
      new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(...axis), quarter));
  const matrix = (turn) => new THREE.Matrix4().makeRotationFromQuaternion(turn);
  const tell = (name, { x, y, z }) =>
      console.log(`three.js, ${name}: ${[x, y, z].map(Math.round).map((n) => n + 0).join(' ')}`);
  const z = () => new THREE.Vector3(0, 0, 1);
  tell('product of quaternions', z().applyQuaternion(a.clone().multiply(b)));
  tell('product of matrices', z().applyMatrix4(matrix(a).multiply(matrix(b))));
}
JS
node order.mjs | tee seen
printf '%s\n' 'Babylon.js, product of quaternions: 1 0 0' 'Babylon.js, product of matrices: 0 -1 0' \
  'three.js, product of quaternions: 1 0 0' 'three.js, product of matrices: 1 0 0' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
