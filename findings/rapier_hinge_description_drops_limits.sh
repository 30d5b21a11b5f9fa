#!/bin/sh
# SPDX-License-Identifier: MIT
# Rapier 0.21.0 (npm @dimforge/rapier3d-compat): limits in the description of a hinge are dropped, those
# of a slider hold.
#
# Expected: JointData has the fields limitsEnabled and limits. A knee that is described with 0 to 1 rad
# stops there, as a slider that is described with 0 to 1 m does.
# Seen: the slider stops at 1 m. The hinge turns on: only setLimits() of the joint that was made of the
# description limits it. The type is the same for both, so neither the compiler nor the engine says it.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . @dimforge/rapier3d-compat@0.21.0 >/dev/null
cat >limits.mjs <<'JS'
import Rapier from '@dimforge/rapier3d-compat';

await Rapier.init();
const [origin, x, z] = [{ x: 0, y: 0, z: 0 }, { x: 1, y: 0, z: 0 }, { x: 0, y: 0, z: 1 }];

// Lets a body with 2 m/s or 2 rad/s go for a second and tells where it is.
function go(name, description, called) {
  const world = new Rapier.World(origin);
  const base = world.createRigidBody(Rapier.RigidBodyDesc.fixed());
  const body = world.createRigidBody(Rapier.RigidBodyDesc.dynamic().setCanSleep(false));
  world.createCollider(Rapier.ColliderDesc.ball(0.1), body);
  const joint = world.createImpulseJoint(description, base, body, true);
  if (called) joint.setLimits(0, 1);
  if (name === 'hinge') body.setAngvel({ x: 0, y: 0, z: 2 }, true);
  else body.setLinvel({ x: 2, y: 0, z: 0 }, true);
  for (let step = 0; step < 60; ++step) world.step();
  const place = name === 'hinge' ? 2 * Math.atan2(body.rotation().z, body.rotation().w)
    : body.translation().x;
  console.log(`${name}, limits by ${called ? 'setLimits' : 'its description'}: at ${place.toFixed(1)}`);
}
const hinge = () => Rapier.JointData.revolute(origin, origin, z);
const limited = (description) => Object.assign(description, { limitsEnabled: true, limits: [0, 1] });
go('slider', limited(Rapier.JointData.prismatic(origin, origin, x)), false);
go('hinge', limited(hinge()), false);
go('hinge', hinge(), true);
JS
node limits.mjs 2>/dev/null | tee seen
cmp -s - seen <<'TEXT' || {
slider, limits by its description: at 1.0
hinge, limits by its description: at 2.0
hinge, limits by setLimits: at 1.0
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
