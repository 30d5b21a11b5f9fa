#!/bin/sh
# SPDX-License-Identifier: MIT
# Bullet 3.24 (Debian libbullet-dev 3.24+dfsg-2): btMatrix3x3's getEulerZYX gives back the angles of
# setEulerZYX in the other order, and setEuler of a matrix and of a quaternion are other rotations.
#
# Expected: getEulerZYX undoes setEulerZYX. btMatrix3x3::setEulerYPR(yaw, pitch, roll) and
# btQuaternion::setEuler(yaw, pitch, roll) are one rotation, as are the two setEulerZYX.
# Seen: btMatrix3x3::setEulerZYX takes the angles about X, Y and Z and getEulerZYX gives those about Z,
# Y and X: 0.1 0.2 0.3 come back as 0.3 0.2 0.1. btQuaternion::setEulerZYX takes Z, Y and X, the other
# way than the matrix. And where the matrix's yaw, pitch and roll are about Z, Y and X, those of
# btQuaternion::setEuler are about Y, X and Z.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libbullet-dev libbullet3.24; do
  apt-get -o APT::Sandbox::User=root download -q "$package=3.24+dfsg-2" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >euler.cpp <<'CPP'
#include <LinearMath/btMatrix3x3.h>
#include <LinearMath/btQuaternion.h>

#include <cmath>
#include <cstdio>

/// The angle of a turn about one axis, and the axis.
void tell(const char* name, const btQuaternion& turn) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(turn[axis]) > 0.01F) {
      std::printf("%s turns by %.1f about %c\n", name, 2 * std::asin(turn[axis]), "XYZ"[axis]);
    }
  }
}

int main() {
  btMatrix3x3 matrix;
  btQuaternion quaternion;
  btScalar first = 0;
  btScalar second = 0;
  btScalar third = 0;
  matrix.setEulerZYX(0.1F, 0.2F, 0.3F);
  matrix.getEulerZYX(first, second, third);
  std::printf("matrix, setEulerZYX 0.1 0.2 0.3: getEulerZYX %.1f %.1f %.1f\n", first, second, third);
  quaternion.setEulerZYX(0.1F, 0.2F, 0.3F);
  quaternion.getEulerZYX(first, second, third);
  std::printf("quaternion, setEulerZYX 0.1 0.2 0.3: getEulerZYX %.1f %.1f %.1f\n", first, second, third);
  matrix.setEulerZYX(0.5F, 0, 0);
  matrix.getRotation(quaternion);
  tell("matrix, setEulerZYX(0.5, 0, 0),", quaternion);
  quaternion.setEulerZYX(0.5F, 0, 0);
  tell("quaternion, setEulerZYX(0.5, 0, 0),", quaternion);
  matrix.setEulerYPR(0.5F, 0, 0);
  matrix.getRotation(quaternion);
  tell("matrix, setEulerYPR with yaw 0.5,", quaternion);
  quaternion.setEuler(0.5F, 0, 0);
  tell("quaternion, setEuler with yaw 0.5,", quaternion);
}
CPP
g++ -std=c++17 -I usr/include/bullet euler.cpp -o euler -L "$library" -lLinearMath
LD_LIBRARY_PATH=$library ./euler | tee seen
cmp -s - seen <<'TEXT' || {
matrix, setEulerZYX 0.1 0.2 0.3: getEulerZYX 0.3 0.2 0.1
quaternion, setEulerZYX 0.1 0.2 0.3: getEulerZYX 0.1 0.2 0.3
matrix, setEulerZYX(0.5, 0, 0), turns by 0.5 about X
quaternion, setEulerZYX(0.5, 0, 0), turns by 0.5 about Z
matrix, setEulerYPR with yaw 0.5, turns by 0.5 about Z
quaternion, setEuler with yaw 0.5, turns by 0.5 about Y
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
