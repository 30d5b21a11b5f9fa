#!/bin/sh
# SPDX-License-Identifier: MIT
# cannon-es 0.20.0 (npm cannon-es): a body's moments of inertia depend on how it is turned when it is
# made.
#
# Expected: a rod has a small moment of inertia about its length, and the same one whether it is made
# upright or lying. A ball's is 2/5 m r^2, as the shape itself answers (calculateLocalInertia).
# Seen: Body does not ask its shapes. It takes the box around them along the world's axes, in the pose
# of that moment, and keeps that box's moments as those about the body's own axes. So a rod that is
# made with a quarter turn has its moments exchanged: the same torque along it spins it 50 times more
# slowly. A ball has 2/3 m r^2. Nothing mends that later, addBody() and step() included.
# Flinch: does not use it. Who lays limbs into its world sets body.inertia after the shapes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . cannon-es@0.20.0 >/dev/null
cat >spin.mjs <<'JS'
import { Body, Box, Quaternion, Sphere, Vec3, World } from 'cannon-es';

// Spins a rod of 1 kg, 1 m long and 0.1 m thick, about its length with 0.01 N m for 1 s.
function spin(turn) {
  const quaternion = new Quaternion().setFromAxisAngle(new Vec3(0, 0, 1), turn * Math.PI / 180);
  const shape = new Box(new Vec3(0.5, 0.05, 0.05));  // half of its sides
  const body = new Body({ mass: 1, shape, quaternion, angularDamping: 0 });
  const world = new World();
  world.addBody(body);
  const along = quaternion.vmult(new Vec3(1, 0, 0));
  for (let step = 0; step < 60; ++step) {
    body.torque.copy(along.scale(0.01));
    world.step(1 / 60);
  }
  return body.angularVelocity.length().toFixed(2);
}
for (const turn of [0, 90]) console.log(`made at ${turn} degrees: ${spin(turn)} rad/s after 1 s`);
const ball = new Body({ mass: 1, shape: new Sphere(0.5) });
console.log(`ball: ${ball.inertia.x.toFixed(3)}, its shape says ` +
    ball.shapes[0].calculateLocalInertia(1, new Vec3()).x.toFixed(3));
JS
node spin.mjs | tee seen
printf '%s\n' 'made at 0 degrees: 6.00 rad/s after 1 s' 'made at 90 degrees: 0.12 rad/s after 1 s' \
  'ball: 0.167, its shape says 0.100' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
