#!/bin/sh
# SPDX-License-Identifier: MIT
# Ignition Math 6.10.0 (Debian libignition-math-dev 6.10.0+ds3-7+b4): a + b of two poses is b * a, and poses
# that differ by 0.9 mm are equal.
#
# Expected: the class has one composition of poses, whatever its sign, and == compares what it holds.
# Seen: a * b is a and then b in the axes of a, as by matrices, and a + b is b and then a. A hand 1 m in
# front of a body that stands at (1, 2, 3) and looks along Y is at (1, 3, 3) by *, at (2, 2, 3) by +. And
# == has a tolerance of 1e-3 for each coordinate and each part of the quaternion, so a joint that has
# turned by a tenth of a degree, or a body that has moved by 0.9 mm, is where it was: a loop that stops
# when the pose no longer changes stops at once where it moves slowly.
# Flinch: turns by Eigen, and compares poses by tolerances that are named.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libignition-math-dev=6.10.0+ds3-7+b4 libignition-math6-6=6.10.0+ds3-7+b4; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >poses.cpp <<'CPP'
#include <cmath>
#include <ignition/math/Matrix4.hh>
#include <ignition/math/Pose3.hh>
#include <iostream>

using ignition::math::Matrix4d;
using ignition::math::Pose3d;

int main() {
  const Pose3d body(1, 2, 3, 0, 0, std::acos(0.0));
  const Pose3d hand(1, 0, 0, 0, 0, 0);
  std::cout << "by matrices: " << (Matrix4d(body) * Matrix4d(hand)).Pose().Pos() << "\n"
            << "body * hand: " << (body * hand).Pos() << "\nbody + hand: " << (body + hand).Pos()
            << "\nhand * body: " << (hand * body).Pos() << "\n"
            << "moved by 0.9 mm: " << (hand == Pose3d(1.0009, 0, 0, 0, 0, 0) ? "equal" : "not equal")
            << "\nturned by 0.1 degrees: "
            << (hand == Pose3d(1, 0, 0, 0, 0, 0.1 * std::acos(-1.0) / 180) ? "equal" : "not equal")
            << "\nmoved by 1.1 mm: " << (hand == Pose3d(1.0011, 0, 0, 0, 0, 0) ? "equal" : "not equal")
            << "\n";
}
CPP
g++ -std=c++17 -w -I usr/include/ignition/math6 poses.cpp -o poses -L "$library" -l:libignition-math6.so.6
LD_LIBRARY_PATH=$library ./poses | tee seen
cmp -s - seen <<'TEXT' || {
by matrices: 1 3 3
body * hand: 1 3 3
body + hand: 2 2 3
hand * body: 2 2 3
moved by 0.9 mm: equal
turned by 0.1 degrees: equal
moved by 1.1 mm: not equal
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
