#!/bin/sh
# SPDX-License-Identifier: MIT
# urdf-loader 0.13.1 (npm): a floating or planar joint that turns carries its link around the parent's
# origin, and moves along the parent's axes.
#
# Expected: URDF puts the joint's own frame at <origin>, and the joint moves the child in that frame. A
# foot whose joint is 1 m along X turns on the spot there, and where the origin is turned by 90 degrees
# about Z, 2 m along the joint's X are 2 m along the parent's Y. Revolute and prismatic joints of the
# loader do so.
# Seen: the joint's value is applied before the origin. Turned by 90 degrees, the foot is at (0, 1)
# instead of (1, 0), and moved by 2 m it is at (3, 0) instead of (1, 2). Only origins of zero are right.
# The three angles of a floating joint are also of another order than those of <origin rpy>: about the
# turning axes X, Y, Z, where rpy is about the fixed ones.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . urdf-loader@0.13.1 three@0.187.0 \
  linkedom@0.18.12 >/dev/null
cat >foot.mjs <<'JS'
import { DOMParser } from 'linkedom';
import { Vector3 } from 'three';
import UrdfLoader from 'urdf-loader';

Object.assign(globalThis, { DOMParser, Document: class {}, Element: class {} });
const quarter = Math.PI / 2;

// Where the foot is, and where its X axis points to.
function foot(type, values, rpy) {
  const robot = new UrdfLoader().parse(`<robot name="leg">
    <link name="shin"/>
    <link name="foot"/>
    <joint name="ankle" type="${type}">
      <parent link="shin"/>
      <child link="foot"/>
      <origin xyz="1 0 0" rpy="${rpy.join(' ')}"/>
      <axis xyz="0 0 1"/>
    </joint>
  </robot>`);
  if (values) robot.setJointValue('ankle', ...values);
  robot.updateMatrixWorld(true);
  const { matrixWorld } = robot.links.foot;
  const round = (vector) => vector.toArray().map((x) => (Math.round(100 * x) + 0) / 100).join(' ');
  return `at ${round(new Vector3().setFromMatrixPosition(matrixWorld))}, ` +
      `X along ${round(new Vector3(1, 0, 0).transformDirection(matrixWorld))}`;
}
console.log(`continuous, turned: ${foot('continuous', [quarter], [0, 0, 0])}`);
console.log(`planar, turned: ${foot('planar', [0, 0, quarter], [0, 0, 0])}`);
console.log(`floating, turned: ${foot('floating', [0, 0, 0, 0, 0, quarter], [0, 0, 0])}`);
console.log(`planar, moved in a turned origin: ${foot('planar', [2, 0, 0], [0, 0, quarter])}`);
console.log(`floating, moved in a turned origin: ${foot('floating', [2, 0, 0, 0, 0, 0], [0, 0, quarter])}`);
console.log(`fixed, rpy 0.5 0.6 0.7: ${foot('fixed', null, [0.5, 0.6, 0.7])}`);
console.log(`floating, angles 0.5 0.6 0.7: ${foot('floating', [0, 0, 0, 0.5, 0.6, 0.7], [0, 0, 0])}`);
JS
node foot.mjs | tee seen
cmp -s - seen <<'TEXT' || {
continuous, turned: at 1 0 0, X along 0 1 0
planar, turned: at 0 1 0, X along 0 1 0
floating, turned: at 0 1 0, X along 0 1 0
planar, moved in a turned origin: at 3 0 0, X along 0 1 0
floating, moved in a turned origin: at 3 0 0, X along 0 1 0
fixed, rpy 0.5 0.6 0.7: at 1 0 0, X along 0.63 0.53 -0.56
floating, angles 0.5 0.6 0.7: at 0.63 0.77 -0.07, X along 0.63 0.77 -0.07
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
