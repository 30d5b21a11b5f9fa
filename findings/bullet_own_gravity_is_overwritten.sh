#!/bin/sh
# SPDX-License-Identifier: MIT
# Bullet (npm ammojs-typed 1.1.0): a body's own gravity is lost when the body is put into the world, and
# one that was set later is lost when the world's is set.
#
# Expected: setGravity of a body gives it a gravity of its own, such as none for a body that floats or is
# held, and addRigidBody adds the body as it is.
# Seen: addRigidBody sets the world's gravity on the body, so what was set while it was made has no
# effect; and setGravity of the world sets it on all bodies again. The body falls, and getGravity() is
# the world's. It holds if it is set after both, or with the flag BT_DISABLE_WORLD_GRAVITY (1). Damping,
# friction and all else that is set before stay.
# Flinch: does not use it. ODE has a switch of gravity for each body, dBodySetGravityMode.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . ammojs-typed@1.1.0 >/dev/null
cat >float.mjs <<'JS'
import startAmmo from 'ammojs-typed';

const A = await startAmmo.call({});
const none = new A.btVector3(0, 0, 0);
const down = new A.btVector3(0, -10, 0);
const orders = {
  'before it is added': ['own', 'add'],
  'before it is added, with the flag': ['flag', 'own', 'add'],
  'after it is added': ['add', 'own'],
  "after it is added, and the world's after that": ['add', 'own', 'world'],
};
for (const [name, order] of Object.entries(orders)) {
  const configuration = new A.btDefaultCollisionConfiguration();
  const world = new A.btDiscreteDynamicsWorld(new A.btCollisionDispatcher(configuration),
      new A.btDbvtBroadphase(), new A.btSequentialImpulseConstraintSolver(), configuration);
  world.setGravity(down);
  const pose = new A.btTransform();
  pose.setIdentity();
  const body = new A.btRigidBody(new A.btRigidBodyConstructionInfo(1, new A.btDefaultMotionState(pose),
      new A.btSphereShape(0.1), new A.btVector3(1, 1, 1)));
  const steps = { own: () => body.setGravity(none), add: () => world.addRigidBody(body),
    flag: () => body.setFlags(1), world: () => world.setGravity(down) };
  for (const step of order) steps[step]();
  for (let frame = 0; frame < 60; ++frame) world.stepSimulation(1 / 60, 1, 1 / 60);
  const speed = Math.round(body.getLinearVelocity().y()) + 0;
  console.log(`no gravity, set ${name}: ${speed} m/s after 1 s`);
}
process.exit();
JS
node float.mjs 2>/dev/null | tee seen
cmp -s - seen <<'TEXT' || {
no gravity, set before it is added: -10 m/s after 1 s
no gravity, set before it is added, with the flag: 0 m/s after 1 s
no gravity, set after it is added: 0 m/s after 1 s
no gravity, set after it is added, and the world's after that: -10 m/s after 1 s
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
