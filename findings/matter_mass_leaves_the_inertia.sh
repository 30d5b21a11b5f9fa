#!/bin/sh
# SPDX-License-Identifier: MIT
# matter-js 0.20.0 (npm): a body that is made with its mass turns as if it had another one, and each
# turns four times as hard as its shape says.
#
# Expected: a square of side a and mass m resists turning by m a^2 / 6, and mass among its options
# gives the body that setMass gives.
# Seen: the inertia is 4 m a^2 / 6, by a factor that stands in Body._inertiaScale and in no manual.
# Body.setMass scales it with the mass. The option mass leaves it as it was at the density of 0.001:
# a square of 40 by 40 with mass 160 has a hundredth of the inertia that it has after setMass(160). A
# ragdoll whose limbs are made with their masses whirls where they are heavy for their size.
# Flinch: computes its figure's moments from its own solids.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . matter-js@0.20.0 >/dev/null
cat >mass.cjs <<'JS'
const { Bodies, Body } = require('matter-js');

const square = (options) => Bodies.rectangle(0, 0, 40, 40, options);
const heavy = square();
Body.setMass(heavy, 160);
const dense = square();
Body.setDensity(dense, 0.1);
const bodies = { 'as made': square(), 'after setMass': heavy, 'made with mass': square({ mass: 160 }),
  'after setDensity': dense };
for (const [name, { mass, inertia }] of Object.entries(bodies)) {
  const times = inertia / ((mass * 40 ** 2) / 6);
  console.log(`${name}: mass ${mass.toPrecision(3)}, ${times.toPrecision(2)} times the inertia of a square`);
}
JS
node mass.cjs | tee seen
printf '%s\n' 'as made: mass 1.60, 4.0 times the inertia of a square' \
  'after setMass: mass 160, 4.0 times the inertia of a square' \
  'made with mass: mass 160, 0.040 times the inertia of a square' \
  'after setDensity: mass 160, 4.0 times the inertia of a square' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
