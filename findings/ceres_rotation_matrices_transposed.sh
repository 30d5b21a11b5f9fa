#!/bin/sh
# SPDX-License-Identifier: MIT
# Ceres 2.1.0 (Debian libceres-dev 2.1.0+really2.1.0+dfsg-1): functions of one header disagree on the
# layout of a 3x3 matrix, and on units.
#
# Expected: ceres/rotation.h has one convention for `T R[9]`, so what one of its functions writes
# another one reads, and angles are in radians.
# Seen: AngleAxisToRotationMatrix, RotationMatrixToAngleAxis and RotationMatrixToQuaternion take the
# nine numbers column by column, QuaternionToRotation and EulerAnglesToRotationMatrix row by row. So
# a quaternion that goes to a matrix and back comes out conjugated, a turn to the left as one to the
# right. Euler angles alone are in degrees. Comments beside the functions say so, for who compares
# them.
# Flinch: takes rotations from Eigen only.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libceres-dev=2.1.0+really2.1.0+dfsg-1 libgoogle-glog-dev libgflags-dev; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
apt-get -o APT::Sandbox::User=root download -q libeigen3-dev=3.4.0-4 >/dev/null
dpkg-deb -x libeigen3-dev_3.4.0-4_all.deb .
cat >turn.cpp <<'CPP'
#include <ceres/rotation.h>
#include <cmath>
#include <cstdio>

void print(const char* what, const double* numbers, int count) {
  std::printf("%s:", what);
  for (int i = 0; i < count; ++i) std::printf(" %.3g", numbers[i] + 0.0);  // no minus zero
  std::puts("");
}

int main() {
  // A quarter turn about Z.
  const double angle_axis[3] = {0, 0, std::acos(-1) / 2};
  const double euler[3] = {0, 0, 90};
  double quaternion[4];
  double matrix[9];
  ceres::AngleAxisToQuaternion(angle_axis, quaternion);
  print("quaternion", quaternion, 4);
  ceres::QuaternionToRotation(quaternion, matrix);
  ceres::RotationMatrixToQuaternion(matrix, quaternion);
  print("to a matrix and back", quaternion, 4);
  double back[3];
  ceres::EulerAnglesToRotationMatrix(euler, 3, matrix);
  ceres::RotationMatrixToAngleAxis(matrix, back);
  print("Euler angles 0 0 90 as angle and axis", back, 3);
}
CPP
# The functions are templates in the header; nothing of the library is called.
g++ -O1 -I usr/include -I usr/include/eigen3 turn.cpp -o turn -Wl,--unresolved-symbols=ignore-all
./turn | tee seen
printf '%s\n' 'quaternion: 0.707 0 0 0.707' 'to a matrix and back: 0.707 0 0 -0.707' \
  'Euler angles 0 0 90 as angle and axis: 0 0 -1.57' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
