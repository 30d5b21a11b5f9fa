#!/bin/sh
# SPDX-License-Identifier: MIT
# @math.gl/core 4.1.0 (npm): the quaternion of Euler angles is the same in all six orders, their matrix
# is not.
#
# Expected: Euler keeps an order, as in three.js, and its toQuaternion() and getRotationMatrix() are the
# same rotation.
# Seen: toQuaternion() does not look at the order and always makes the rotation of the order ZYX. Of the
# angles 30, 50 and 70 degrees, matrix and quaternion are 68 degrees apart in the order XYZ, 25 in ZXY.
# In ZYX, which is the default, they agree.
# Flinch: does not use it. Who does makes the quaternion of the matrix: new Quaternion().fromMatrix3().
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . @math.gl/core@4.1.0 >/dev/null
cat >orders.mjs <<'JS'
import { Euler, Matrix3, Matrix4, Quaternion } from '@math.gl/core';

const radians = (degrees) => (degrees * Math.PI) / 180;
const rotation = (matrix) => [0, 1, 2, 4, 5, 6, 8, 9, 10].map((i) => matrix[i]);
for (const order of ['XYZ', 'YXZ', 'ZXY', 'ZYX', 'YZX', 'XZY']) {
  const euler = new Euler(radians(30), radians(50), radians(70), Euler[order]);
  const matrix = euler.getRotationMatrix(new Matrix4());
  const back = new Euler().fromRotationMatrix(matrix, Euler[order]);
  const angles = [...back].slice(0, 3).map((angle) => ((angle * 180) / Math.PI).toFixed(0));
  const ofMatrix = new Quaternion().fromMatrix3(new Matrix3(rotation(matrix)));
  const apart = 2 * Math.acos(Math.min(1, Math.abs(ofMatrix.dot(euler.toQuaternion()))));
  console.log(`${order}: angles of the matrix ${angles.join(' ')}, `
    + `quaternion and matrix ${((apart * 180) / Math.PI).toFixed(0)} degrees apart`);
}
JS
node orders.mjs | tee seen
cmp -s - seen <<'TEXT' || {
XYZ: angles of the matrix 30 50 70, quaternion and matrix 68 degrees apart
YXZ: angles of the matrix 30 50 70, quaternion and matrix 63 degrees apart
ZXY: angles of the matrix 30 50 70, quaternion and matrix 25 degrees apart
ZYX: angles of the matrix 30 50 70, quaternion and matrix 0 degrees apart
YZX: angles of the matrix 30 50 70, quaternion and matrix 56 degrees apart
XZY: angles of the matrix 30 50 70, quaternion and matrix 37 degrees apart
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
