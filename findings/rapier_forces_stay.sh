#!/bin/sh
# SPDX-License-Identifier: MIT
# Rapier 0.21.0 (npm @dimforge/rapier3d-compat): a force that is added once acts in every step from
# then on.
#
# Expected: addForce adds a force for the next step, as its namesakes in Bullet (npm ammojs-typed 1.1.0),
# cannon-es 0.20.0 and Box2D (npm planck 1.5.0) do: who pushes in each frame calls it in each frame.
# Seen: Rapier keeps it until resetForces(). A push in one frame goes on for ever, and one that is
# added in each frame grows by itself: after ten steps of 1/60 s with 60 N a mass of 1 kg has 55 m/s
# instead of 10. Torques do the same.
# Flinch: does not use it. Who does calls resetForces() before each step, or applies impulses.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . @dimforge/rapier3d-compat@0.21.0 planck@1.5.0 \
  ammojs-typed@1.1.0 cannon-es@0.20.0 >/dev/null
cat >push.mjs <<'JS'
import Rapier from '@dimforge/rapier3d-compat';
import startAmmo from 'ammojs-typed';
import * as cannon from 'cannon-es';
import { Circle, Vec2, World } from 'planck';

await Rapier.init();
const A = await startAmmo.call({});
// Each gives what pushes a free body of 1 kg, what steps it, and its speed.
const engines = {
  rapier() {
    const world = new Rapier.World({ x: 0, y: 0, z: 0 });
    const body = world.createRigidBody(Rapier.RigidBodyDesc.dynamic());
    world.createCollider(Rapier.ColliderDesc.ball(0.1).setMass(1), body);
    return [() => body.addForce({ x: 60, y: 0, z: 0 }, true), () => world.step(), () => body.linvel().x];
  },
  bullet() {
    const configuration = new A.btDefaultCollisionConfiguration();
    const world = new A.btDiscreteDynamicsWorld(new A.btCollisionDispatcher(configuration),
        new A.btDbvtBroadphase(), new A.btSequentialImpulseConstraintSolver(), configuration);
    world.setGravity(new A.btVector3(0, 0, 0));
    const pose = new A.btTransform();
    pose.setIdentity();
    const body = new A.btRigidBody(new A.btRigidBodyConstructionInfo(1,
        new A.btDefaultMotionState(pose), new A.btSphereShape(0.1), new A.btVector3(1, 1, 1)));
    world.addRigidBody(body);
    return [() => body.applyCentralForce(new A.btVector3(60, 0, 0)),
      () => world.stepSimulation(1 / 60, 1, 1 / 60), () => body.getLinearVelocity().x()];
  },
  cannon() {
    const world = new cannon.World();
    const body = new cannon.Body({ mass: 1, shape: new cannon.Sphere(0.1), linearDamping: 0 });
    world.addBody(body);
    return [() => body.applyForce(new cannon.Vec3(60, 0, 0)), () => world.step(1 / 60),
      () => body.velocity.x];
  },
  planck() {
    const world = new World(new Vec2(0, 0));
    const body = world.createDynamicBody();
    body.createFixture({ shape: new Circle(1), density: 1 / Math.PI });
    return [() => body.applyForceToCenter(new Vec2(60, 0), true), () => world.step(1 / 60),
      () => body.getLinearVelocity().x];
  },
};
for (const [name, make] of Object.entries(engines)) {
  const speed = (frames) => {
    const [push, step, tell] = make();
    for (let frame = 0; frame < 10; ++frame) {
      if (frame < frames) push();
      step();
    }
    return tell().toFixed(1);
  };
  console.log(`${name}: pushed in one of ten frames ${speed(1)} m/s, in each ${speed(10)} m/s`);
}
process.exit();
JS
node push.mjs 2>/dev/null | tee seen
cmp -s - seen <<'TEXT' || {
rapier: pushed in one of ten frames 10.0 m/s, in each 55.0 m/s
bullet: pushed in one of ten frames 1.0 m/s, in each 10.0 m/s
cannon: pushed in one of ten frames 1.0 m/s, in each 10.0 m/s
planck: pushed in one of ten frames 1.0 m/s, in each 10.0 m/s
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
