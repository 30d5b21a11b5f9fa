#!/bin/sh
# SPDX-License-Identifier: MIT
# PLIB 1.8.5 (Debian libplib-dev 1.8.5-14+b1): heading and roll are exchanged after sgEulerToQuat() and
# sgQuatToEuler(), and a quaternion turns a vector against its own matrix.
#
# Expected: in one header, a function and the one of the opposite name undo each other.
# Seen: heading, pitch and roll of 30, 20 and 10 degrees come back as 10, 20 and 30, and the quaternion of
# them is another rotation than the matrix of them, by 73 degrees. An angle about an axis comes back as
# the angle about the opposite axis. sgRotateVecQuat() turns a vector one way, sgQuatToMatrix() and
# sgXformVec3() the other. sgMakeRotMat4() and sgSetCoord(), by matrices, do undo each other.
# Flinch: turns by Eigen.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libplib-dev=1.8.5-14+b1 >/dev/null
dpkg-deb -x libplib-dev_*.deb .
cat >angles.cpp <<'CPP'
#include <cmath>
#include <cstdio>
#include <plib/sg.h>

int main() {
  sgVec3 given = {30, 20, 10};
  sgVec3 back;
  sgQuat turn;
  sgEulerToQuat(turn, given);
  sgQuatToEuler(back, turn);
  std::printf("by the quaternion: %.0f %.0f %.0f\n", back[0], back[1], back[2]);

  sgMat4 matrix;
  sgCoord coordinates;
  sgMakeRotMat4(matrix, 30, 20, 10);
  sgSetCoord(&coordinates, matrix);
  std::printf("by the matrix: %.0f %.0f %.0f\n", coordinates.hpr[0], coordinates.hpr[1],
              coordinates.hpr[2]);
  sgQuat of_matrix;
  sgMatrixToQuat(of_matrix, matrix);
  const double dot = sgScalarProductVec4(turn, of_matrix);
  std::printf("quaternion and matrix are %.0f degrees apart\n",
              2 * std::acos(std::fabs(dot)) * SG_RADIANS_TO_DEGREES);

  sgVec3 up = {0, 0, 1};
  sgVec3 axis;
  SGfloat angle;
  sgAngleAxisToQuat(turn, 90, up);
  sgQuatToAngleAxis(&angle, axis, turn);
  std::printf("90 degrees about Z: %.0f about %.0f Z\n", angle, axis[2]);

  sgVec3 by_quaternion = {1, 0, 0};
  sgVec3 by_matrix = {1, 0, 0};
  sgRotateVecQuat(by_quaternion, turn);
  sgQuatToMatrix(matrix, turn);
  sgXformVec3(by_matrix, matrix);
  std::printf("X turned by it: y %.0f by the quaternion, y %.0f by its matrix\n", by_quaternion[1],
              by_matrix[1]);
}
CPP
library=$PWD/usr/lib/x86_64-linux-gnu
g++ -w -I usr/include angles.cpp -o angles -L "$library" -lplibsg -lplibul -ldl
./angles | tee seen
cmp -s - seen <<'TEXT' || {
by the quaternion: 10 20 30
by the matrix: 30 20 10
quaternion and matrix are 73 degrees apart
90 degrees about Z: 90 about -1 Z
X turned by it: y -1 by the quaternion, y 1 by its matrix
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
