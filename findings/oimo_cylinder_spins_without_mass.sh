#!/bin/sh
# SPDX-License-Identifier: MIT
# oimo 1.0.9 (npm): a cylinder's moment of inertia about its axis does not have its mass in it.
#
# Expected: it is m r^2 / 2 about the axis, as the sphere's 0.4 m r^2 and the box's have the mass.
# Seen: it is r^2 / 2 (Cylinder.js, inertiaY), whatever the density. A wheel or a trunk of 157 kg
# rolls and twists about its axis as one of 1 kg, so the same torque spins it 157 times as fast; one of
# less than 1 kg is too slow. Across the axis the mass is there.
# Flinch: computes its figure's moments from its own solids.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . oimo@1.0.9 >/dev/null
cat >cylinder.cjs <<'JS'
const { World } = require('oimo');

for (const density of [1, 10, 100]) {
  const world = new World({ random: false });
  const { mass, localInertia } = world.add({ type: 'cylinder', size: [0.5, 2], move: true, density });
  const [across, , , , along] = localInertia.elements;
  console.log(`${mass.toFixed(1)} kg: ${across.toFixed(2)} across the axis, ${along.toFixed(3)} about it, ` +
      `where m r^2 / 2 is ${(mass / 8).toFixed(3)}`);
}
JS
node cylinder.cjs | tee seen
printf '%s\n' '1.6 kg: 0.62 across the axis, 0.125 about it, where m r^2 / 2 is 0.196' \
  '15.7 kg: 6.22 across the axis, 0.125 about it, where m r^2 / 2 is 1.963' \
  '157.1 kg: 62.16 across the axis, 0.125 about it, where m r^2 / 2 is 19.635' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
