#!/bin/sh
# SPDX-License-Identifier: MIT
# Bullet (npm ammojs-typed 1.1.0) and jolt-physics 1.1.0: an impulse on a body that has come to rest does
# nothing.
#
# Expected: a body that has been at rest for some seconds, and is put to sleep to save time, wakes when it
# is pushed, as in cannon-es 0.20.0 and Box2D (npm planck 1.5.0).
# Seen: in Bullet the impulse is lost: the body has no speed and stays, also when it is woken later. In
# Jolt AddImpulse of the body gives it a speed that one can read, while it stays where it is for as long
# as nothing wakes it; AddImpulse of the body interface wakes it. activate(true), or ActivateBody, before
# the impulse makes both move. A figure that stood still for two seconds takes no hit.
# Flinch: does not use them, and puts no body to sleep.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . jolt-physics@1.1.0 ammojs-typed@1.1.0 \
  cannon-es@0.20.0 planck@1.5.0 >/dev/null
cat >push.mjs <<'JS'
import startAmmo from 'ammojs-typed';
import * as cannon from 'cannon-es';
import startJolt from 'jolt-physics';
import { Circle, Vec2, World } from 'planck';

const [J, A] = [await startJolt(), await startAmmo.call({})];

// Each gives what steps a free body of 1 kg, wakes it and pushes it by 1 N s, its place and its speed.
const engines = {
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
    return { step: () => world.stepSimulation(1 / 60, 1, 1 / 60), wake: () => body.activate(true),
      push: () => body.applyCentralImpulse(new A.btVector3(1, 0, 0)),
      place: () => body.getWorldTransform().getOrigin().x(), speed: () => body.getLinearVelocity().x() };
  },
  jolt(byInterface) {
    const pairs = new J.ObjectLayerPairFilterTable(1);
    const layers = new J.BroadPhaseLayerInterfaceTable(1, 1);
    layers.MapObjectToBroadPhaseLayer(0, new J.BroadPhaseLayer(0));
    const settings = new J.JoltSettings();
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectVsBroadPhaseLayerFilter =
        new J.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
    const world = new J.JoltInterface(settings);
    world.GetPhysicsSystem().SetGravity(new J.Vec3(0, 0, 0));
    const bodies = world.GetPhysicsSystem().GetBodyInterface();
    const creation = new J.BodyCreationSettings(new J.SphereShape(0.1), new J.RVec3(0, 0, 0),
        new J.Quat(0, 0, 0, 1), J.EMotionType_Dynamic, 0);
    creation.mLinearDamping = 0;
    creation.mOverrideMassProperties = J.EOverrideMassProperties_CalculateInertia;
    creation.mMassPropertiesOverride.mMass = 1;
    const body = bodies.CreateBody(creation);
    bodies.AddBody(body.GetID(), J.EActivation_Activate);
    const impulse = new J.Vec3(1, 0, 0);
    return { step: () => world.Step(1 / 60, 1), wake: () => bodies.ActivateBody(body.GetID()),
      push: () => (byInterface ? bodies.AddImpulse(body.GetID(), impulse) : body.AddImpulse(impulse)),
      place: () => body.GetPosition().GetX(), speed: () => body.GetLinearVelocity().GetX() };
  },
  cannon() {
    const world = new cannon.World({ allowSleep: true });
    const body = new cannon.Body({ mass: 1, shape: new cannon.Sphere(0.1), linearDamping: 0 });
    world.addBody(body);
    return { step: () => world.step(1 / 60), wake: () => body.wakeUp(),
      push: () => body.applyImpulse(new cannon.Vec3(1, 0, 0)), place: () => body.position.x,
      speed: () => body.velocity.x };
  },
  planck() {
    const world = new World(new Vec2(0, 0));
    const body = world.createDynamicBody();
    body.createFixture({ shape: new Circle(1), density: 1 / Math.PI });
    return { step: () => world.step(1 / 60), wake: () => body.setAwake(true),
      push: () => body.applyLinearImpulse(new Vec2(1, 0), body.getWorldCenter()),
      place: () => body.getPosition().x, speed: () => body.getLinearVelocity().x };
  },
};
function rest(name, body, woken) {
  const steps = (seconds) => {
    for (let i = 0; i < 60 * seconds; ++i) body.step();
  };
  steps(5);
  if (woken) body.wake();
  body.push();
  steps(1);
  const told = `${(body.speed() + 0).toFixed(1)} m/s and ${(body.place() + 0).toFixed(1)} m after 1 s`;
  body.wake();
  steps(1);
  console.log(`${name}${woken ? ', woken' : ''}: ${told}, woken then ${(body.place() + 0).toFixed(1)} m after 2 s`);
}
rest('bullet', engines.bullet());
rest('bullet', engines.bullet(), true);
rest('jolt', engines.jolt(false));
rest('jolt', engines.jolt(false), true);
rest('jolt by its interface', engines.jolt(true));
rest('cannon', engines.cannon());
rest('planck', engines.planck());
process.exit();
JS
node push.mjs 2>/dev/null | tee seen
cmp -s - seen <<'TEXT' || {
bullet: 0.0 m/s and 0.0 m after 1 s, woken then 0.0 m after 2 s
bullet, woken: 1.0 m/s and 1.0 m after 1 s, woken then 2.0 m after 2 s
jolt: 1.0 m/s and 0.0 m after 1 s, woken then 1.0 m after 2 s
jolt, woken: 1.0 m/s and 1.0 m after 1 s, woken then 2.0 m after 2 s
jolt by its interface: 1.0 m/s and 1.0 m after 1 s, woken then 2.0 m after 2 s
cannon: 1.0 m/s and 1.0 m after 1 s, woken then 2.0 m after 2 s
planck: 1.0 m/s and 1.0 m after 1 s, woken then 2.0 m after 2 s
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
