#!/bin/sh
# SPDX-License-Identifier: MIT
# ODE 0.16.2 (Debian libode-dev 2:0.16.2-1): without fdir1, friction depends on how a scene is turned
# about its vertical.
#
# Expected: an isotropic coefficient mu gives a sliding ball the same friction in every direction.
# Seen: each contact has two friction directions that ODE derives from the normal alone, and each is
# bounded by mu times the normal force by itself (dContactApprox1 included). So friction is a box and
# not a disc: a ball that slides along the diagonal of the two directions is held by up to the square
# root of two times the force. A scene turned by 45 degrees has another outcome.
# Flinch: contacts carry fdir1 along the sliding velocity, in both solvers, and a test turns a scene.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libode-dev libode8; do
  apt-get -o APT::Sandbox::User=root download -q "$package=2:0.16.2-1" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'libode.so' | head -n 1)")
cat >slide.cpp <<'CPP'
#include <ode/ode.h>
#include <cmath>
#include <cstdio>

// Speed lost in 0.1 s by a box that slides at 5 m/s over level ground towards `degrees`.
double lost(double degrees, bool with_direction) {
  const double angle = degrees * std::acos(-1.0) / 180;
  dWorldID world = dWorldCreate();
  dWorldSetGravity(world, 0, 0, -10);
  dJointGroupID contacts = dJointGroupCreate(0);
  dBodyID body = dBodyCreate(world);
  dMass mass;
  dMassSetBoxTotal(&mass, 1, 1, 1, 1);
  dBodySetMass(body, &mass);
  dBodySetMaxAngularSpeed(body, 0);  // it slides and does not tip
  dBodySetPosition(body, 0, 0, 0);
  dBodySetLinearVel(body, 5 * std::cos(angle), 5 * std::sin(angle), 0);
  for (int step = 0; step < 100; ++step) {
    dContact contact{};
    contact.surface.mode = dContactApprox1 | (with_direction ? dContactFDir1 : 0);
    contact.surface.mu = 0.5;
    contact.geom.normal[2] = 1;
    const dReal* velocity = dBodyGetLinearVel(body);
    const double speed = std::hypot(velocity[0], velocity[1]);
    contact.fdir1[0] = velocity[0] / speed;
    contact.fdir1[1] = velocity[1] / speed;
    for (int i = 0; i < 3; ++i) contact.geom.pos[i] = dBodyGetPosition(body)[i];
    dJointAttach(dJointCreateContact(world, contacts, &contact), body, nullptr);
    dWorldStep(world, 0.001);
    dJointGroupEmpty(contacts);
  }
  const dReal* velocity = dBodyGetLinearVel(body);
  const double speed = std::hypot(velocity[0], velocity[1]);
  dJointGroupDestroy(contacts);
  dWorldDestroy(world);
  return 5 - speed;
}

int main() {
  dInitODE2(0);
  std::printf("without fdir1: %.3f m/s at 0 degrees, %.3f at 45\n", lost(0, false), lost(45, false));
  std::printf("with fdir1:    %.3f m/s at 0 degrees, %.3f at 45\n", lost(0, true), lost(45, true));
  dCloseODE();
}
CPP
g++ -DdIDEDOUBLE -I usr/include slide.cpp -o slide -L "$library" -lode
LD_LIBRARY_PATH=$library ./slide | tee seen
grep -q '^without fdir1: 0.500 m/s at 0 degrees, 0.707 at 45' seen &&
  grep -q '^with fdir1:    0.500 m/s at 0 degrees, 0.500 at 45' seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
