#!/bin/sh
# SPDX-License-Identifier: MIT
# cannon-es 0.20.0 (npm cannon-es): a force that is applied each frame loses two thirds of its effect
# at 20 frames per second, unlike in Bullet (npm ammojs-typed 1.1.0).
#
# Expected: a game applies 1 N to 1 kg before each step(1/60, frame, 10) for 1 s, and the body has
# 1 m/s whatever the frame rate is: the step divides the frame's time into substeps of 1/60 s.
# Seen: cannon-es clears forces after each substep, so at 20 frames per second the force acts in the
# first of three and the body has 0.3 m/s. Bullet clears them after all substeps of a call, and has
# 1 m/s. So thrusters, springs and wind weaken on slow machines, and gravity does not.
# Flinch: does not use it. Who does adds forces in the event preStep, or steps one substep at a time.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . cannon-es@0.20.0 ammojs-typed@1.1.0 >/dev/null
cat >push.mjs <<'JS'
import startAmmo from 'ammojs-typed';
import * as Cannon from 'cannon-es';

const A = await startAmmo.call({});
function cannon(rate) {
  const world = new Cannon.World({ gravity: new Cannon.Vec3(0, 0, 0) });
  const body = new Cannon.Body({ mass: 1, shape: new Cannon.Sphere(0.5), linearDamping: 0 });
  world.addBody(body);
  for (let frame = 0; frame < rate; ++frame) {
    body.applyForce(new Cannon.Vec3(1, 0, 0));
    world.step(1 / 60, 1 / rate, 10);
  }
  return body.velocity.x.toFixed(1);
}
function bullet(rate) {
  const configuration = new A.btDefaultCollisionConfiguration();
  const world = new A.btDiscreteDynamicsWorld(new A.btCollisionDispatcher(configuration),
      new A.btDbvtBroadphase(), new A.btSequentialImpulseConstraintSolver(), configuration);
  world.setGravity(new A.btVector3(0, 0, 0));
  const pose = new A.btTransform();
  pose.setIdentity();
  const body = new A.btRigidBody(new A.btRigidBodyConstructionInfo(
      1, new A.btDefaultMotionState(pose), new A.btSphereShape(0.5), new A.btVector3(1, 1, 1)));
  world.addRigidBody(body);
  for (let frame = 0; frame < rate; ++frame) {
    body.applyCentralForce(new A.btVector3(1, 0, 0));
    world.stepSimulation(1 / rate, 10, 1 / 60);
  }
  return body.getLinearVelocity().x().toFixed(1);
}
for (const rate of [60, 20]) {
  console.log(`${rate} frames per second: cannon-es ${cannon(rate)} m/s, Bullet ${bullet(rate)} m/s`);
}
JS
node push.mjs | tee seen
printf '%s\n' '60 frames per second: cannon-es 1.0 m/s, Bullet 1.0 m/s' \
  '20 frames per second: cannon-es 0.3 m/s, Bullet 1.0 m/s' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
