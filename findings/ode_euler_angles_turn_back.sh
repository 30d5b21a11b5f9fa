#!/bin/sh
# SPDX-License-Identifier: MIT
# ODE 0.16.2 (Debian libode-dev 2:0.16.2-1): dRFromEulerAngles makes the inverse of the rotation that
# the other functions of its header make.
#
# Expected: dRFromEulerAngles(R, 0, 0, 0.5) and dRFromAxisAndAngle(R, 0, 0, 1, 0.5) are one rotation.
# Seen: they are inverse, about each axis. dRFromAxisAndAngle, dRFromZAxis, dRFrom2Axes and dQtoR give
# the matrix that takes a body's directions to the world's, which dBodySetRotation wants;
# dRFromEulerAngles gives its transpose. A limb that is placed by it leans to the other side, and with
# two angles also about other axes, so a change of their signs does not mend it: the transpose does.
# The manual says of phi, theta and psi only that they are Euler angles.
# Flinch: sets rotations by quaternions.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libode-dev libode8; do
  apt-get -o APT::Sandbox::User=root download -q "$package=2:0.16.2-1" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'libode.so' | head -n 1)")
cat >turn.cpp <<'CPP'
#include <ode/ode.h>
#include <cmath>
#include <cstdio>

/// How a body that is turned by `rotation` tells its own axis `along` in the world.
void tell(const char* name, const dMatrix3 rotation, int along) {
  const dWorldID world = dWorldCreate();
  const dBodyID body = dBodyCreate(world);
  dBodySetRotation(body, rotation);
  dVector3 to;
  dBodyVectorToWorld(body, along == 0, along == 1, along == 2, to);
  std::printf("%s: its axis %c points along %.2f %.2f %.2f\n", name, "xyz"[along], to[0], to[1], to[2]);
  dWorldDestroy(world);
}

int main() {
  dInitODE2(0);
  dMatrix3 rotation;
  for (int axis = 0; axis < 3; ++axis) {
    const int along = (axis + 1) % 3;
    dRFromEulerAngles(rotation, axis == 0 ? 0.5 : 0, axis == 1 ? 0.5 : 0, axis == 2 ? 0.5 : 0);
    tell("Euler angles", rotation, along);
    dRFromAxisAndAngle(rotation, axis == 0, axis == 1, axis == 2, 0.5);
    tell("axis and angle", rotation, along);
  }
  dCloseODE();
}
CPP
g++ -DdIDEDOUBLE -I usr/include turn.cpp -o turn -L "$library" -lode
LD_LIBRARY_PATH=$library ./turn | tee seen
printf '%s\n' 'Euler angles: its axis y points along 0.00 0.88 -0.48' \
  'axis and angle: its axis y points along 0.00 0.88 0.48' \
  'Euler angles: its axis z points along -0.48 0.00 0.88' \
  'axis and angle: its axis z points along 0.48 0.00 0.88' \
  'Euler angles: its axis x points along 0.88 -0.48 0.00' \
  'axis and angle: its axis x points along 0.88 0.48 0.00' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
