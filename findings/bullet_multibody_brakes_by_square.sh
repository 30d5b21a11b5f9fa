#!/bin/sh
# SPDX-License-Identifier: MIT
# Bullet 3.24 (Debian libbullet-dev 3.24+dfsg-2): a btMultiBody in empty space loses a third of its
# velocity in a second, and more of a high one.
#
# Expected: as a btRigidBody, whose damping is 0 unless one sets it, a btMultiBody keeps its
# velocity where no force acts. If it has a damping of 0.04, it loses 4 % in a second.
# Seen: its default is 0.04, and that number is the coefficient of the velocity and of its square: it
# brakes by (0.04 + 0.04 |v|) v, whatever its mass. Thrown at 1 m/s it has 0.92 m/s after a second,
# at 10 m/s it has 6.9 and at 40 m/s it has 15. Its spin brakes likewise. setLinearDamping(0) and
# setAngularDamping(0) take it away. The square stands in btMultiBody.cpp only (DAMPING_K2_LINEAR).
# Flinch: does not use it; its bodies have no damping of their own.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libbullet-dev libbullet3.24; do
  apt-get -o APT::Sandbox::User=root download -q "$package=3.24+dfsg-2" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >coast.cpp <<'CPP'
#include <cstdio>
#include <initializer_list>

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

struct World {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
  btMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  World() { world.setGravity(btVector3(0, 0, 0)); }
  void run_1_s() {
    for (int step = 0; step < 240; ++step) world.stepSimulation(1.0F / 240, 1, 1.0F / 240);
  }
};

float multi_body(float speed) {
  World scene;
  btMultiBody body(0, 1, btVector3(1, 1, 1), false, false);
  body.finalizeMultiDof();
  scene.world.addMultiBody(&body);
  body.setBaseVel(btVector3(speed, 0, 0));
  scene.run_1_s();
  scene.world.removeMultiBody(&body);
  return body.getBaseVel().x();
}

float rigid_body(float speed) {
  World scene;
  btSphereShape ball(0.1F);
  btRigidBody body(1, nullptr, &ball, btVector3(1, 1, 1));
  scene.world.addRigidBody(&body);
  body.setLinearVelocity(btVector3(speed, 0, 0));
  scene.run_1_s();
  scene.world.removeRigidBody(&body);
  return body.getLinearVelocity().x();
}

int main() {
  for (const float speed : {1.0F, 10.0F, 40.0F}) {
    std::printf("%g m/s: after 1 s a btRigidBody has %.2g m/s, a btMultiBody %.2g\n", speed,
                rigid_body(speed), multi_body(speed));
  }
}
CPP
g++ -std=c++17 -O1 -I usr/include/bullet coast.cpp -o coast -L "$library" -lBulletDynamics \
  -lBulletCollision -lLinearMath
LD_LIBRARY_PATH=$library ./coast | tee seen
printf '%s\n' '1 m/s: after 1 s a btRigidBody has 1 m/s, a btMultiBody 0.92' \
  '10 m/s: after 1 s a btRigidBody has 10 m/s, a btMultiBody 6.9' \
  '40 m/s: after 1 s a btRigidBody has 40 m/s, a btMultiBody 15' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
