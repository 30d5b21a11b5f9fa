#!/bin/sh
# SPDX-License-Identifier: MIT
# Bullet 3.24 (Debian libbullet-dev 3.24+dfsg-2): a knee whose limits are -0.1 and 1 rad bends from -1 to
# 0.1, by a hinge and by both six-axis joints; by a slider, or a hinge on the world, from -0.1 to 1.
#
# Expected: limits of a joint between A and B are of B as seen from A, as constructors name the parent
# first, and alike in all joints of one engine.
# Seen: the angle of btHingeConstraint, btGeneric6DofConstraint and btGeneric6DofSpring2Constraint is that
# of A seen from B, so B goes to the negative of each limit, and a knee bends the wrong way. A hinge of one
# body, whose partner is the world, counts the other way than a hinge of two, and so does the turn of a
# btSliderConstraint. With useReferenceFrameA a hinge of two counts as one expects.
# Flinch: does not use it. Who carries limits over negates and exchanges them.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=3.24+dfsg-2
for package in libbullet-dev libbullet3.24; do
  apt-get -o APT::Sandbox::User=root download -q "$package=$version" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >knee.cpp <<'CPP'
#include <btBulletDynamicsCommon.h>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

/// Where a shank ends in 10 s that a torque turns about +Z, or -Z, from a thigh that stands.
double bend(const std::string& joint, double torque) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase phase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &phase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, 0));
  btSphereShape shape(0.1);
  btRigidBody thigh(0, nullptr, &shape);
  btRigidBody shank(1, nullptr, &shape, btVector3(1, 1, 1));
  shank.setActivationState(DISABLE_DEACTIVATION);
  for (btRigidBody* body : {&thigh, &shank}) world.addRigidBody(body, 1, 0);
  const btTransform same = btTransform::getIdentity();
  const btVector3 none(0, 0, 0);
  const btVector3 axis(0, 0, 1);
  btHingeConstraint hinge(thigh, shank, none, none, axis, axis);
  btHingeConstraint reference(thigh, shank, none, none, axis, axis, true);
  btHingeConstraint on_world(shank, none, axis);
  btGeneric6DofConstraint six(thigh, shank, same, same, true);
  btGeneric6DofSpring2Constraint spring(thigh, shank, same, same);
  // A slider is along X.
  const btTransform along_z(btQuaternion(btVector3(0, 1, 0), -std::acos(0.0)));
  btSliderConstraint slider(thigh, shank, along_z, along_z, true);
  for (btHingeConstraint* one : {&hinge, &reference, &on_world}) one->setLimit(-0.1, 1);
  six.setAngularLowerLimit(btVector3(0, 0, -0.1));
  six.setAngularUpperLimit(btVector3(0, 0, 1));
  spring.setAngularLowerLimit(btVector3(0, 0, -0.1));
  spring.setAngularUpperLimit(btVector3(0, 0, 1));
  slider.setLowerAngLimit(-0.1);
  slider.setUpperAngLimit(1);
  const std::map<std::string, btTypedConstraint*> joints = {
      {"hinge", &hinge}, {"hinge with useReferenceFrameA", &reference}, {"hinge on the world", &on_world},
      {"six-axis joint", &six}, {"six-axis joint 2", &spring}, {"slider", &slider}};
  btTypedConstraint* const used = joints.at(joint);
  world.addConstraint(used);
  for (int i = 0; i < 600; ++i) {
    shank.applyTorque(torque * axis);
    world.stepSimulation(1 / 60.0, 1, 1 / 60.0);
  }
  const btQuaternion turn = shank.getOrientation();
  world.removeConstraint(used);
  for (btRigidBody* body : {&thigh, &shank}) world.removeRigidBody(body);
  return 2 * std::atan2(turn.z(), turn.w());
}

int main() {
  for (const std::string joint : {"hinge", "hinge with useReferenceFrameA", "hinge on the world",
                                  "six-axis joint", "six-axis joint 2", "slider"})
    std::printf("%s with -0.1 and 1: bends from %.1f to %.1f\n", joint.c_str(), bend(joint, -2),
                bend(joint, 2));
}
CPP
g++ -std=c++17 -w -O0 -I usr/include/bullet knee.cpp -o knee -L "$library" -lBulletDynamics \
  -lBulletCollision -lLinearMath
LD_LIBRARY_PATH=$library ./knee | tee seen
cmp -s - seen <<'TEXT' || {
hinge with -0.1 and 1: bends from -1.0 to 0.1
hinge with useReferenceFrameA with -0.1 and 1: bends from -0.1 to 1.0
hinge on the world with -0.1 and 1: bends from -0.1 to 1.0
six-axis joint with -0.1 and 1: bends from -1.0 to 0.1
six-axis joint 2 with -0.1 and 1: bends from -1.0 to 0.1
slider with -0.1 and 1: bends from -0.1 to 1.0
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
