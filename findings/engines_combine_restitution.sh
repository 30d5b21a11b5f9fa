#!/bin/sh
# SPDX-License-Identifier: MIT
# planck 1.5.0, jolt-physics 1.1.0, @dimforge/rapier3d-compat 0.21.0 and ammojs-typed 1.1.0 (npm): the
# same two restitutions bounce a ball fully, half or not at all.
#
# Expected: restitution is a property of a pair of bodies, but engines that ask for one of each body
# agree at least on the plain cases: a ball of restitution 1 keeps its speed where it falls on a floor
# of restitution 0, or it stops there.
# Seen: planck (Box2D) and Jolt take the larger of the two, so it keeps its speed. Rapier takes the
# mean, and it keeps half. Bullet multiplies them, and the ball stays where it falls. Where both have
# 0.5, Bullet alone bounces with 0.25. So a scene that goes from one engine to another cannot keep
# its numbers unless all bodies have 0 or all 1.
# Flinch: a contact has one restitution, given to the pair.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . planck@1.5.0 jolt-physics@1.1.0 \
  @dimforge/rapier3d-compat@0.21.0 ammojs-typed@1.1.0 >/dev/null
cat >bounce.mjs <<'JS'
import Rapier from '@dimforge/rapier3d-compat';
import startAmmo from 'ammojs-typed';
import startJolt from 'jolt-physics';
import { Box, Circle, Vec2, World } from 'planck';

// What is left of a ball's speed when it falls on a floor: each function takes the restitutions of
// ball and floor and gives a function that steps by 1/60 s and returns the ball's vertical speed.
const engines = {
  planck(ball, floor) {
    const world = new World(new Vec2(0, -10));
    world.createBody().createFixture({ shape: new Box(10, 1, new Vec2(0, -1)), restitution: floor });
    const body = world.createDynamicBody(new Vec2(0, 2));
    body.createFixture({ shape: new Circle(0.5), density: 1, restitution: ball });
    return () => (world.step(1 / 60), body.getLinearVelocity().y);
  },
  jolt(ball, floor) {
    const J = jolt;
    const pairs = new J.ObjectLayerPairFilterTable(2);
    pairs.EnableCollision(0, 1);
    const layers = new J.BroadPhaseLayerInterfaceTable(2, 2);
    for (const i of [0, 1]) layers.MapObjectToBroadPhaseLayer(i, new J.BroadPhaseLayer(i));
    const settings = new J.JoltSettings();
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectVsBroadPhaseLayerFilter =
        new J.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
    const world = new J.JoltInterface(settings);
    world.GetPhysicsSystem().SetGravity(new J.Vec3(0, -10, 0));
    const bodies = world.GetPhysicsSystem().GetBodyInterface();
    const add = (shape, height, type, layer, restitution) => {
      const creation = new J.BodyCreationSettings(
          shape, new J.RVec3(0, height, 0), new J.Quat(0, 0, 0, 1), type, layer);
      creation.mRestitution = restitution;
      creation.mLinearDamping = 0;
      const body = bodies.CreateBody(creation);
      bodies.AddBody(body.GetID(), J.EActivation_Activate);
      return body;
    };
    add(new J.BoxShape(new J.Vec3(10, 1, 10), 0.05), -1, J.EMotionType_Static, 0, floor);
    const body = add(new J.SphereShape(0.5), 2, J.EMotionType_Dynamic, 1, ball);
    return () => (world.Step(1 / 60, 1), body.GetLinearVelocity().GetY());
  },
  rapier(ball, floor) {
    const world = new Rapier.World({ x: 0, y: -10, z: 0 });
    world.createCollider(
        Rapier.ColliderDesc.cuboid(10, 1, 10).setTranslation(0, -1, 0).setRestitution(floor));
    const body = world.createRigidBody(Rapier.RigidBodyDesc.dynamic().setTranslation(0, 2, 0));
    world.createCollider(Rapier.ColliderDesc.ball(0.5).setRestitution(ball), body);
    return () => (world.step(), body.linvel().y);
  },
  bullet(ball, floor) {
    const A = ammo;
    const configuration = new A.btDefaultCollisionConfiguration();
    const world = new A.btDiscreteDynamicsWorld(new A.btCollisionDispatcher(configuration),
        new A.btDbvtBroadphase(), new A.btSequentialImpulseConstraintSolver(), configuration);
    world.setGravity(new A.btVector3(0, -10, 0));
    const add = (shape, height, mass, restitution) => {
      const pose = new A.btTransform();
      pose.setIdentity();
      pose.setOrigin(new A.btVector3(0, height, 0));
      const inertia = new A.btVector3(0, 0, 0);
      if (mass > 0) shape.calculateLocalInertia(mass, inertia);
      const body = new A.btRigidBody(new A.btRigidBodyConstructionInfo(
          mass, new A.btDefaultMotionState(pose), shape, inertia));
      body.setRestitution(restitution);
      world.addRigidBody(body);
      return body;
    };
    add(new A.btBoxShape(new A.btVector3(10, 1, 10)), -1, 0, floor);
    const body = add(new A.btSphereShape(0.5), 2, 1, ball);
    return () => (world.stepSimulation(1 / 60, 1), body.getLinearVelocity().y());
  },
};
await Rapier.init();
const [jolt, ammo] = [await startJolt(), await startAmmo.call({})];
for (const [name, make] of Object.entries(engines)) {
  const kept = [[1, 0], [0.5, 0.5]].map((restitutions) => {
    const step = make(...restitutions);
    const speeds = Array.from({ length: 80 }, step);
    return Math.round((4 * Math.max(0, ...speeds)) / -Math.min(...speeds)) / 4;  // in quarters
  });
  console.log(`${name}: 1 and 0 keep ${kept[0]} of the speed, 0.5 and 0.5 keep ${kept[1]}`);
}
process.exit();
JS
node bounce.mjs | tee seen
printf '%s: 1 and 0 keep %s of the speed, 0.5 and 0.5 keep %s\n' planck 1 0.5 jolt 1 0.5 \
  rapier 0.5 0.5 bullet 0 0.25 | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
