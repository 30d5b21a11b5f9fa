#!/bin/sh
# SPDX-License-Identifier: MIT
# urdf-loader 0.13.1 (npm): a joint that mimics another one goes on where that one has stopped.
#
# Expected: the second joint of a finger mimics the first one, with a multiplier of 1: their angles are
# equal, whatever the first one is told.
# Seen: told to go to 3 rad, the first joint stops at its limit of 1 and the second goes to 3, which its
# own limits allow. It is given the angle that was asked for, not the one that was reached. With
# ignoreLimits, or for angles within the limits, the two agree.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . urdf-loader@0.13.1 three@0.187.0 \
  linkedom@0.18.12 >/dev/null
cat >finger.mjs <<'JS'
import { DOMParser } from 'linkedom';
import UrdfLoader from 'urdf-loader';

Object.assign(globalThis, { DOMParser, Document: class {}, Element: class {} });
const joint = (name, parent, child, upper, more) => `<joint name="${name}" type="revolute">
  <parent link="${parent}"/>
  <child link="${child}"/>
  <axis xyz="0 0 1"/>
  <limit lower="0" upper="${upper}" effort="1" velocity="1"/>
  ${more}
</joint>`;
const finger = new UrdfLoader().parse(`<robot name="finger">
  <link name="hand"/>
  <link name="first"/>
  <link name="second"/>
  ${joint('knuckle', 'hand', 'first', 1, '')}
  ${joint('middle', 'first', 'second', 3.1, '<mimic joint="knuckle" multiplier="1"/>')}
</robot>`);
for (const angle of [0.5, 3]) {
  finger.setJointValue('knuckle', angle);
  console.log(`told ${angle}: knuckle at ${finger.joints.knuckle.angle}, ` +
      `middle at ${finger.joints.middle.angle}`);
}
JS
node finger.mjs | tee seen
cmp -s - seen <<'TEXT' || {
told 0.5: knuckle at 0.5, middle at 0.5
told 3: knuckle at 1, middle at 3
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
