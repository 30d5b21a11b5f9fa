#!/bin/sh
# SPDX-License-Identifier: MIT
# jolt-physics 1.1.0, @dimforge/rapier3d-compat 0.21.0 and planck 1.5.0 (npm): a thrown ball has at most
# 47 or 94 rad/s of spin, whatever one gives it.
#
# Expected: a ball that is given 240 rad/s, as a pitcher gives a baseball, has that spin until a force
# acts on it, as it has in ammojs-typed 1.1.0 (Bullet) and cannon-es 0.20.0.
# Seen: at 60 steps per second Jolt and Rapier leave it 47 rad/s and planck (Box2D) 94, so it cannot
# curve a flight or a bounce. With twice the steps Rapier and planck leave twice as much. They cap the
# speed too: Jolt at 500 m/s, Rapier at 400 and planck at 2 m in each step, which is 120 m/s at 60
# steps per second and 60 at 30. No error tells of it. Jolt has settings of each body,
# mMaxAngularVelocity and mMaxLinearVelocity, and planck one of all, Settings.maxRotation.
# Flinch: neither its own solver nor ODE caps a spin.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . jolt-physics@1.1.0 \
  @dimforge/rapier3d-compat@0.21.0 planck@1.5.0 ammojs-typed@1.1.0 cannon-es@0.20.0 >/dev/null
cat >spin.mjs <<'JS'
import Rapier from '@dimforge/rapier3d-compat';
import startAmmo from 'ammojs-typed';
import * as cannon from 'cannon-es';
import startJolt from 'jolt-physics';
import { Circle, Vec2, World } from 'planck';

await Rapier.init();
const [jolt, ammo] = [await startJolt(), await startAmmo.call({})];

// Each lets a ball with this spin and speed fly for one step and gives both as they are then.
const engines = {
  jolt(spin, speed, dt) {
    const J = jolt;
    const pairs = new J.ObjectLayerPairFilterTable(1);
    const layers = new J.BroadPhaseLayerInterfaceTable(1, 1);
    layers.MapObjectToBroadPhaseLayer(0, new J.BroadPhaseLayer(0));
    const settings = new J.JoltSettings();
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectVsBroadPhaseLayerFilter =
        new J.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
    const world = new J.JoltInterface(settings);
    const bodies = world.GetPhysicsSystem().GetBodyInterface();
    const creation = new J.BodyCreationSettings(new J.SphereShape(0.037), new J.RVec3(0, 0, 0),
        new J.Quat(0, 0, 0, 1), J.EMotionType_Dynamic, 0);
    creation.mLinearDamping = creation.mAngularDamping = 0;
    const body = bodies.CreateBody(creation);
    bodies.AddBody(body.GetID(), J.EActivation_Activate);
    body.SetAngularVelocity(new J.Vec3(0, 0, spin));
    body.SetLinearVelocity(new J.Vec3(speed, 0, 0));
    world.Step(dt, 1);
    return [body.GetAngularVelocity().GetZ(), body.GetLinearVelocity().GetX()];
  },
  rapier(spin, speed, dt) {
    const world = new Rapier.World({ x: 0, y: 0, z: 0 });
    world.timestep = dt;
    const body = world.createRigidBody(Rapier.RigidBodyDesc.dynamic());
    world.createCollider(Rapier.ColliderDesc.ball(0.037), body);
    body.setAngvel({ x: 0, y: 0, z: spin }, true);
    body.setLinvel({ x: speed, y: 0, z: 0 }, true);
    world.step();
    return [body.angvel().z, body.linvel().x];
  },
  planck(spin, speed, dt) {
    const world = new World(new Vec2(0, 0));
    const body = world.createDynamicBody();
    body.createFixture({ shape: new Circle(0.037), density: 1 });
    body.setAngularVelocity(spin);
    body.setLinearVelocity(new Vec2(speed, 0));
    world.step(dt);
    return [body.getAngularVelocity(), body.getLinearVelocity().x];
  },
  bullet(spin, speed, dt) {
    const A = ammo;
    const configuration = new A.btDefaultCollisionConfiguration();
    const world = new A.btDiscreteDynamicsWorld(new A.btCollisionDispatcher(configuration),
        new A.btDbvtBroadphase(), new A.btSequentialImpulseConstraintSolver(), configuration);
    world.setGravity(new A.btVector3(0, 0, 0));
    const pose = new A.btTransform();
    pose.setIdentity();
    const body = new A.btRigidBody(new A.btRigidBodyConstructionInfo(1,
        new A.btDefaultMotionState(pose), new A.btSphereShape(0.037), new A.btVector3(1, 1, 1)));
    world.addRigidBody(body);
    body.setAngularVelocity(new A.btVector3(0, 0, spin));
    body.setLinearVelocity(new A.btVector3(speed, 0, 0));
    world.stepSimulation(dt, 1, dt);
    return [body.getAngularVelocity().z(), body.getLinearVelocity().x()];
  },
  cannon(spin, speed, dt) {
    const world = new cannon.World();
    const body = new cannon.Body({ mass: 1, shape: new cannon.Sphere(0.037), linearDamping: 0,
      angularDamping: 0 });
    world.addBody(body);
    body.angularVelocity.set(0, 0, spin);
    body.velocity.set(speed, 0, 0);
    world.step(dt);
    return [body.angularVelocity.z, body.velocity.x];
  },
};
for (const [name, fly] of Object.entries(engines)) {
  const kept = [60, 120].map((rate) => fly(240, 600, 1 / rate).map(Math.round).join(' rad/s and '));
  console.log(`${name}: ${kept[0]} m/s are left at 60 steps per second, ` +
      `${kept[1]} m/s at 120`);
}
process.exit();
JS
node spin.mjs | tee seen
cmp -s - seen <<'TEXT' || {
jolt: 47 rad/s and 500 m/s are left at 60 steps per second, 47 rad/s and 500 m/s at 120
rapier: 47 rad/s and 400 m/s are left at 60 steps per second, 94 rad/s and 400 m/s at 120
planck: 94 rad/s and 120 m/s are left at 60 steps per second, 188 rad/s and 240 m/s at 120
bullet: 240 rad/s and 600 m/s are left at 60 steps per second, 240 rad/s and 600 m/s at 120
cannon: 240 rad/s and 600 m/s are left at 60 steps per second, 240 rad/s and 600 m/s at 120
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
