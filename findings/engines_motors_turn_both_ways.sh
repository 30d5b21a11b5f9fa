#!/bin/sh
# SPDX-License-Identifier: MIT
# planck 1.5.0, jolt-physics 1.1.0, @dimforge/rapier3d-compat 0.21.0, cannon-es 0.20.0, ammojs-typed
# 1.1.0 and p2-es 1.2.3 (npm): the same motor turns a limb forward or backward, and in p2 against the
# angle of its own joint.
#
# Expected: a hinge of bodies A and B about +Z with a motor of 1 rad/s turns B by +1 rad/s about Z
# where A stands, as a positive angle of B would. At least the joint's own angle grows.
# Seen: so it is in planck (Box2D), Jolt and Rapier. In cannon-es, in Bullet unless useReferenceFrameA
# is given, and in p2 B turns by -1. Bullet's angle grows with it, which is that of A seen from B;
# that of p2 falls. A servo, which sets the motor's speed to five times the angle that is missing,
# runs away from its goal in p2. So who ports a figure between engines negates some motors.
# Flinch: does not use them. In ODE, which it does use, a motor turns the first body forward.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . planck@1.5.0 jolt-physics@1.1.0 \
  @dimforge/rapier3d-compat@0.21.0 cannon-es@0.20.0 ammojs-typed@1.1.0 p2-es@1.2.3 >/dev/null
cat >motors.mjs <<'JS'
import Rapier from '@dimforge/rapier3d-compat';
import startAmmo from 'ammojs-typed';
import * as cannon from 'cannon-es';
import startJolt from 'jolt-physics';
import * as p2 from 'p2-es';
import { Circle, RevoluteJoint, Vec2, World } from 'planck';

await Rapier.init();
const [jolt, ammo] = [await startJolt(), await startAmmo.call({})];
const dt = 1 / 60;

// Each makes body B on a motor of 1 rad/s to the fixed body A and gives: a step, the speed of B
// about +Z and, where the joint has one, its angle.
const engines = {
  planck() {
    const world = new World(new Vec2(0, 0));
    const [a, b] = [world.createBody(), world.createDynamicBody()];
    b.createFixture({ shape: new Circle(0.5), density: 1 });
    const motor = { enableMotor: true, motorSpeed: 1, maxMotorTorque: 100 };
    const joint = world.createJoint(new RevoluteJoint(motor, a, b, new Vec2(0, 0)));
    return [() => world.step(dt), () => b.getAngularVelocity(), () => joint.getJointAngle()];
  },
  jolt() {
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
    const [a, b] = [J.EMotionType_Static, J.EMotionType_Dynamic].map((type) => {
      const body = bodies.CreateBody(new J.BodyCreationSettings(
          new J.SphereShape(0.5), new J.RVec3(0, 0, 0), new J.Quat(0, 0, 0, 1), type, 0));
      bodies.AddBody(body.GetID(), J.EActivation_Activate);
      return body;
    });
    const hinge = new J.HingeConstraintSettings();
    hinge.mHingeAxis1 = hinge.mHingeAxis2 = new J.Vec3(0, 0, 1);
    hinge.mNormalAxis1 = hinge.mNormalAxis2 = new J.Vec3(1, 0, 0);
    const joint = J.castObject(hinge.Create(a, b), J.HingeConstraint);
    world.GetPhysicsSystem().AddConstraint(joint);
    joint.SetMotorState(J.EMotorState_Velocity);
    joint.SetTargetAngularVelocity(1);
    return [() => world.Step(dt, 1), () => b.GetAngularVelocity().GetZ(),
        () => joint.GetCurrentAngle()];
  },
  rapier() {
    const [origin, axis] = [{ x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 1 }];
    const world = new Rapier.World(origin);
    const a = world.createRigidBody(Rapier.RigidBodyDesc.fixed());
    const b = world.createRigidBody(Rapier.RigidBodyDesc.dynamic());
    world.createCollider(Rapier.ColliderDesc.ball(0.5), b);
    const joint = world.createImpulseJoint(Rapier.JointData.revolute(origin, origin, axis), a, b, true);
    joint.configureMotorVelocity(1, 100);
    return [() => world.step(), () => b.angvel().z];
  },
  cannon() {
    const world = new cannon.World();
    const a = new cannon.Body({ mass: 0 });
    const b = new cannon.Body({ mass: 1, shape: new cannon.Sphere(0.5) });
    for (const body of [a, b]) world.addBody(body);
    const axis = new cannon.Vec3(0, 0, 1);
    const joint = new cannon.HingeConstraint(a, b, { axisA: axis, axisB: axis });
    world.addConstraint(joint);
    joint.enableMotor();
    joint.setMotorSpeed(1);
    return [() => world.step(dt), () => b.angularVelocity.z];
  },
  bullet() {
    const A = ammo;
    const configuration = new A.btDefaultCollisionConfiguration();
    const world = new A.btDiscreteDynamicsWorld(new A.btCollisionDispatcher(configuration),
        new A.btDbvtBroadphase(), new A.btSequentialImpulseConstraintSolver(), configuration);
    world.setGravity(new A.btVector3(0, 0, 0));
    const [a, b] = [0, 1].map((mass) => {
      const pose = new A.btTransform();
      pose.setIdentity();
      const body = new A.btRigidBody(new A.btRigidBodyConstructionInfo(mass,
          new A.btDefaultMotionState(pose), new A.btSphereShape(0.5), new A.btVector3(mass, mass, mass)));
      world.addRigidBody(body, 1, 0);
      return body;
    });
    const [origin, axis] = [new A.btVector3(0, 0, 0), new A.btVector3(0, 0, 1)];
    const joint = new A.btHingeConstraint(a, b, origin, origin, axis, axis, false);
    joint.enableAngularMotor(true, 1, 100);
    world.addConstraint(joint, true);
    return [() => world.stepSimulation(dt, 1, dt), () => b.getAngularVelocity().z(),
        joint.getHingeAngle && (() => joint.getHingeAngle())];
  },
  p2(speed = () => 1) {
    const world = new p2.World({ gravity: [0, 0] });
    const a = new p2.Body({ mass: 0 });
    const b = new p2.Body({ mass: 1 });
    b.addShape(new p2.Circle({ radius: 0.5 }));
    for (const body of [a, b]) world.addBody(body);
    const joint = new p2.RevoluteConstraint(a, b, { localPivotA: [0, 0], localPivotB: [0, 0] });
    world.addConstraint(joint);
    joint.motorEnabled = true;
    const step = () => {
      joint.motorSpeed = speed(joint.angle);
      world.step(dt);
    };
    return [step, () => b.angularVelocity, () => joint.angle];
  },
};
for (const [name, make] of Object.entries(engines)) {
  const [step, speed, angle] = make();
  for (let i = 0; i < 30; ++i) step();
  console.log(`${name}: B turns by ${Math.round(speed())} rad/s, ` +
      `the joint's angle ${!angle ? 'is not told' : angle() > 0 ? 'grows' : 'falls'}`);
}
const [step, , angle] = engines.p2((now) => 5 * (0.5 - now));
for (let i = 0; i < 60; ++i) step();
console.log(`p2: a servo to 0.5 is ${angle() < -10 ? 'far below -10' : 'near'} after 1 s`);
process.exit();
JS
node motors.mjs | tee seen
cmp -s - seen <<'TEXT' || {
planck: B turns by 1 rad/s, the joint's angle grows
jolt: B turns by 1 rad/s, the joint's angle grows
rapier: B turns by 1 rad/s, the joint's angle is not told
cannon: B turns by -1 rad/s, the joint's angle is not told
bullet: B turns by -1 rad/s, the joint's angle grows
p2: B turns by -1 rad/s, the joint's angle falls
p2: a servo to 0.5 is far below -10 after 1 s
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
