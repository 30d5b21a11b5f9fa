#!/bin/sh
# SPDX-License-Identifier: MIT
# Cal3D 0.11.0 (Debian libcal3d12-dev 0.11.0-8): with quaternions a and b, a *= b is not a = a * b.
#
# Expected: after a *= b, a is what a * b is.
# Seen: a *= b makes the product of a and b, a * b that of b and a. Two turns by 90 degrees, one about X
# and one about Z, differ by 120 degrees between the two. The header has both formulas, without a word.
# For the rotation of a joint below its parent the skeleton has "absolute *= parent".
# Flinch: turns by Eigen.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libcal3d12-dev=0.11.0-8 >/dev/null
dpkg-deb -x libcal3d12-dev_*.deb .
cat >products.cpp <<'CPP'
#include <cal3d/global.h>
#include <cal3d/vector.h>
#include <cal3d/quaternion.h>
#include <cmath>
#include <cstdio>

void tell(const char* name, const CalQuaternion& q) {
  std::printf("%s: x %.1f, y %.1f, z %.1f, w %.1f\n", name, q.x, q.y, q.z, q.w);
}

int main() {
  const float half = std::sqrt(0.5f);
  const CalQuaternion a(half, 0, 0, half);
  const CalQuaternion b(0, 0, half, half);
  CalQuaternion c = a;
  c *= b;
  tell("a *= b", c);
  tell("a * b ", a * b);
  tell("b * a ", b * a);
}
CPP
g++ -w -I usr/include products.cpp -o products
./products | tee seen
cmp -s - seen <<'TEXT' || {
a *= b: x 0.5, y -0.5, z 0.5, w 0.5
a * b : x 0.5, y 0.5, z 0.5, w 0.5
b * a : x 0.5, y -0.5, z 0.5, w 0.5
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
