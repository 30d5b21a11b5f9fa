#!/bin/sh
# SPDX-License-Identifier: MIT
# Assimp 5.2.5 (Debian libassimp-dev 5.2.5~ds0-1+b1): a quaternion of three angles takes those about Y, Z and
# X, and a matrix of three angles those about X, Y and Z.
#
# Expected: aiQuaternion(x, y, z) is the rotation of aiMatrix4x4::FromEulerAnglesXYZ(x, y, z), whose angles
# aiMatrix4x4::Decompose() gives back.
# Seen: aiQuaternion(0.5, 0, 0) turns about Y. The three are called roty, rotz and rotx in the declaration
# and pitch, yaw and roll in the definition, of an aircraft whose Z is up, while Y is up in Assimp. Angles
# of 0.3, 0.5 and 0.7 rad that a matrix gives and a quaternion takes make a rotation that is 31 degrees off.
# aiQuaternion(aiMatrix3x3) of the matrix is right.
# Flinch: takes matrices and quaternions from Assimp, and makes none of angles.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libassimp-dev=5.2.5~ds0-1+b1 >/dev/null
dpkg-deb -x libassimp-dev_*.deb .
cat >angles.cpp <<'CPP'
#include <algorithm>
#include <assimp/scene.h>
#include <cmath>
#include <cstdio>

#include <assimp/matrix3x3.inl>
#include <assimp/matrix4x4.inl>
#include <assimp/quaternion.inl>
#include <assimp/vector3.inl>

void tell(const char* name, const aiQuaternion& q) {
  std::printf("%s: x %.3f, y %.3f, z %.3f, w %.3f\n", name, q.x, q.y, q.z, q.w);
}

int main() {
  aiMatrix4x4 matrix;
  matrix.FromEulerAnglesXYZ(0.5f, 0, 0);
  tell("aiQuaternion(0.5, 0, 0)", aiQuaternion(0.5f, 0, 0));
  tell("FromEulerAnglesXYZ(0.5, 0, 0)", aiQuaternion(aiMatrix3x3(matrix)));

  matrix = aiMatrix4x4();
  matrix.FromEulerAnglesXYZ(0.3f, 0.5f, 0.7f);
  aiVector3D scale;
  aiVector3D angles;
  aiVector3D place;
  matrix.Decompose(scale, angles, place);
  const aiQuaternion right{aiMatrix3x3(matrix)};
  const aiQuaternion made(angles.x, angles.y, angles.z);
  const double dot = made.w * right.w + made.x * right.x + made.y * right.y + made.z * right.z;
  std::printf("the angles of the matrix %.1f %.1f %.1f make a quaternion %.0f degrees off\n", angles.x,
              angles.y, angles.z, 2 * std::acos(std::min(1.0, std::fabs(dot))) * 180 / std::acos(-1.0));
}
CPP
g++ -std=c++17 -w -I usr/include angles.cpp -o angles
./angles | tee seen
cmp -s - seen <<'TEXT' || {
aiQuaternion(0.5, 0, 0): x 0.000, y 0.247, z 0.000, w 0.969
FromEulerAnglesXYZ(0.5, 0, 0): x 0.247, y 0.000, z 0.000, w 0.969
the angles of the matrix 0.3 0.5 0.7 make a quaternion 31 degrees off
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
