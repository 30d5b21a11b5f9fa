#!/bin/sh
# SPDX-License-Identifier: MIT
# planck 1.5.0, jolt-physics 1.1.0, ammojs-typed 1.1.0, @babylonjs/havok 1.3.14, cannon-es 0.20.0 and
# @dimforge/rapier3d-compat 0.21.0 (npm): a perfectly elastic ball at 0.9 m/s keeps from none to all of its
# speed.
#
# Expected: with a restitution of 1 on both sides, a ball leaves a floor as fast as it came, at any speed:
# the restitution is a ratio of speeds.
# Seen: only Rapier does that. In planck (Box2D) and Jolt a ball that comes at less than 1 m/s stays on the
# floor, however elastic, and at 1.1 m/s it keeps all. Bullet keeps none of 0.3 m/s, a third of 0.9 and all
# of 3. Havok takes about 0.17 m/s off at any speed, and cannon gives up to 15 % more. So a limb that is
# pushed against a wall at 0.9 m/s does other things in each engine, and a scene in decimetres others than
# one in metres. planck's Settings.velocityThreshold and Jolt's mMinVelocityForRestitution set the limit.
# Flinch: does not use them. Its contacts have one restitution for all speeds.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . planck@1.5.0 jolt-physics@1.1.0 \
  @dimforge/rapier3d-compat@0.21.0 ammojs-typed@1.1.0 cannon-es@0.20.0 @babylonjs/havok@1.3.14 >/dev/null
cat >slow.mjs <<'JS'
import { readFileSync } from 'node:fs';
import Rapier from '@dimforge/rapier3d-compat';
import startHavok from '@babylonjs/havok';
import startAmmo from 'ammojs-typed';
import * as cannon from 'cannon-es';
import startJolt from 'jolt-physics';
import { Box, Circle, Vec2, World } from 'planck';

// Without gravity a ball flies at a floor whose top is at 0. Each function takes its speed and gives a
// function that steps by 1/60 s and returns the ball's vertical speed.
const engines = {
  planck(speed) {
    const world = new World(new Vec2(0, 0));
    world.createBody().createFixture({ shape: new Box(10, 1, new Vec2(0, -1)), restitution: 1 });
    const body = world.createDynamicBody(new Vec2(0, 0.6));
    body.createFixture({ shape: new Circle(0.5), density: 1, restitution: 1 });
    body.setLinearVelocity(new Vec2(0, -speed));
    return () => (world.step(1 / 60), body.getLinearVelocity().y);
  },
  jolt(speed) {
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
    world.GetPhysicsSystem().SetGravity(new J.Vec3(0, 0, 0));
    const bodies = world.GetPhysicsSystem().GetBodyInterface();
    const add = (shape, height, type, layer) => {
      const creation = new J.BodyCreationSettings(
          shape, new J.RVec3(0, height, 0), new J.Quat(0, 0, 0, 1), type, layer);
      creation.mRestitution = 1;
      creation.mLinearDamping = 0;
      const body = bodies.CreateBody(creation);
      bodies.AddBody(body.GetID(), J.EActivation_Activate);
      return body;
    };
    add(new J.BoxShape(new J.Vec3(10, 1, 10), 0.05), -1, J.EMotionType_Static, 0);
    const body = add(new J.SphereShape(0.5), 0.6, J.EMotionType_Dynamic, 1);
    body.SetLinearVelocity(new J.Vec3(0, -speed, 0));
    return () => (world.Step(1 / 60, 1), body.GetLinearVelocity().GetY());
  },
  bullet(speed) {
    const A = ammo;
    const configuration = new A.btDefaultCollisionConfiguration();
    const world = new A.btDiscreteDynamicsWorld(new A.btCollisionDispatcher(configuration),
        new A.btDbvtBroadphase(), new A.btSequentialImpulseConstraintSolver(), configuration);
    world.setGravity(new A.btVector3(0, 0, 0));
    const add = (shape, height, mass) => {
      const pose = new A.btTransform();
      pose.setIdentity();
      pose.setOrigin(new A.btVector3(0, height, 0));
      const inertia = new A.btVector3(0, 0, 0);
      if (mass > 0) shape.calculateLocalInertia(mass, inertia);
      const body = new A.btRigidBody(new A.btRigidBodyConstructionInfo(
          mass, new A.btDefaultMotionState(pose), shape, inertia));
      body.setRestitution(1);
      world.addRigidBody(body);
      return body;
    };
    add(new A.btBoxShape(new A.btVector3(10, 1, 10)), -1, 0);
    const body = add(new A.btSphereShape(0.5), 0.6, 1);
    body.setLinearVelocity(new A.btVector3(0, -speed, 0));
    return () => (world.stepSimulation(1 / 60, 1), body.getLinearVelocity().y());
  },
  havok(speed) {
    const H = havok;
    const upright = [0, 0, 0, 1];
    const world = H.HP_World_Create()[1];
    H.HP_World_SetGravity(world, [0, 0, 0]);
    const add = (shape, height, type) => {
      const combine = H.MaterialCombine.MAXIMUM;
      H.HP_Shape_SetMaterial(shape, [0.5, 0.5, 1, combine, combine]);
      const body = H.HP_Body_Create()[1];
      H.HP_Body_SetShape(body, shape);
      H.HP_Body_SetMotionType(body, type);
      H.HP_Body_SetMassProperties(body, H.HP_Shape_BuildMassProperties(shape)[1]);
      H.HP_Body_SetPosition(body, [0, height, 0]);
      H.HP_World_AddBody(world, body, false);
      return body;
    };
    add(H.HP_Shape_CreateBox([0, 0, 0], upright, [20, 2, 20])[1], -1, H.MotionType.STATIC);
    const body = add(H.HP_Shape_CreateSphere([0, 0, 0], 0.5)[1], 0.6, H.MotionType.DYNAMIC);
    H.HP_Body_SetLinearVelocity(body, [0, -speed, 0]);
    return () => (H.HP_World_Step(world, 1 / 60), H.HP_Body_GetLinearVelocity(body)[1][1]);
  },
  cannon(speed) {
    const world = new cannon.World();
    world.defaultContactMaterial.restitution = 1;
    world.addBody(new cannon.Body({ shape: new cannon.Box(new cannon.Vec3(10, 1, 10)),
      position: new cannon.Vec3(0, -1, 0) }));
    const body = new cannon.Body({ mass: 1, shape: new cannon.Sphere(0.5), linearDamping: 0,
      position: new cannon.Vec3(0, 0.6, 0), velocity: new cannon.Vec3(0, -speed, 0) });
    world.addBody(body);
    return () => (world.step(1 / 60), body.velocity.y);
  },
  rapier(speed) {
    const world = new Rapier.World({ x: 0, y: 0, z: 0 });
    world.createCollider(
        Rapier.ColliderDesc.cuboid(10, 1, 10).setTranslation(0, -1, 0).setRestitution(1));
    const body = world.createRigidBody(
        Rapier.RigidBodyDesc.dynamic().setTranslation(0, 0.6, 0).setLinvel(0, -speed, 0));
    world.createCollider(Rapier.ColliderDesc.ball(0.5).setRestitution(1), body);
    return () => (world.step(), body.linvel().y);
  },
};
await Rapier.init();
const wasmBinary = readFileSync('node_modules/@babylonjs/havok/lib/esm/HavokPhysics.wasm');
const [jolt, ammo, havok] =
    [await startJolt(), await startAmmo.call({}), await startHavok({ wasmBinary })];
for (const [name, make] of Object.entries(engines)) {
  const kept = [0.3, 0.9, 1.1, 3].map((speed) => {
    const step = make(speed);
    const after = Array.from({ length: 60 }, step).at(-1);
    return `${(after / speed * 100 + 0.01).toFixed(0)} % of ${speed} m/s`;
  });
  console.log(`${name}: ${kept.join(', ')}`);
}
process.exit();
JS
node slow.mjs 2>/dev/null | tee seen
cmp -s - seen <<'TEXT' || {
planck: 0 % of 0.3 m/s, 0 % of 0.9 m/s, 100 % of 1.1 m/s, 100 % of 3 m/s
jolt: 0 % of 0.3 m/s, 0 % of 0.9 m/s, 100 % of 1.1 m/s, 100 % of 3 m/s
bullet: 0 % of 0.3 m/s, 33 % of 0.9 m/s, 55 % of 1.1 m/s, 100 % of 3 m/s
havok: 45 % of 0.3 m/s, 82 % of 0.9 m/s, 85 % of 1.1 m/s, 94 % of 3 m/s
cannon: 115 % of 0.3 m/s, 95 % of 0.9 m/s, 101 % of 1.1 m/s, 115 % of 3 m/s
rapier: 100 % of 0.3 m/s, 100 % of 0.9 m/s, 100 % of 1.1 m/s, 100 % of 3 m/s
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
