#!/bin/sh
# SPDX-License-Identifier: MIT
# Bullet 3.24 (Debian libbullet-dev 3.24+dfsg-2), Imath 3.1.6 (libimath-dev 3.1.6-1) and OMPL 1.5.2
# (libompl-dev 1.5.2+ds1-1): the angle between two rotations is half of it.
#
# Expected: the angle between the quaternions of two rotations that differ by 1 rad about one axis is
# 1 rad, as Eigen 3.4.0's angularDistance gives it, and that of opposite ones is pi.
# Seen: btQuaternion::angle, Imath's angle4D and the distance of OMPL's SO3StateSpace give 0.5, and their
# largest value is pi / 2, or pi for a quaternion and its negative in the first two. It is the angle
# between the quaternions as vectors with four numbers. Bullet's angleShortestPath beside it gives 1. A
# joint's error that is taken so is half as large as it is, and a stop at 90 degrees lets 180 pass.
# Flinch: turns by Eigen.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libbullet-dev=3.24+dfsg-2 libimath-dev=3.1.6-1 libimath-3-1-29=3.1.6-1 \
  libompl-dev=1.5.2+ds1-1 libompl16=1.5.2+ds1-1 libeigen3-dev libode8 libboost1.74-dev \
  libboost-serialization1.74.0 libboost-filesystem1.74.0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >angle.cpp <<'CPP'
#include <ImathQuat.h>
#include <LinearMath/btQuaternion.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <Eigen/Geometry>
#include <cstdio>
#include <memory>

int main() {
  const double from = 0.2, to = 1.2;
  const auto by_eigen = [](double angle) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()));
  };
  std::printf("Eigen: %.2f\n", by_eigen(from).angularDistance(by_eigen(to)));
  const auto by_bullet = [](double angle) { return btQuaternion(btVector3(1, 0, 0), btScalar(angle)); };
  std::printf("Bullet, angle: %.2f\n", by_bullet(from).angle(by_bullet(to)));
  std::printf("Bullet, angleShortestPath: %.2f\n", by_bullet(from).angleShortestPath(by_bullet(to)));
  const auto by_imath = [](double angle) {
    return Imath::Quatd().setAxisAngle(Imath::V3d(1, 0, 0), angle);
  };
  std::printf("Imath: %.2f\n", Imath::angle4D(by_imath(from), by_imath(to)));
  using Space = ompl::base::SO3StateSpace;
  const auto space = std::make_shared<Space>();
  ompl::base::ScopedState<Space> first(space), second(space);
  first->setAxisAngle(1, 0, 0, from);
  second->setAxisAngle(1, 0, 0, to);
  std::printf("OMPL: %.2f\n", first.distance(second));
}
CPP
g++ -std=c++17 -w -I usr/include -I usr/include/bullet -I usr/include/Imath -I usr/include/ompl-1.5 \
  -I usr/include/eigen3 angle.cpp -o angle -L "$library" -lompl -lImath-3_1 \
  -Wl,--unresolved-symbols=ignore-in-shared-libs -Wl,-rpath-link,"$library"
LD_LIBRARY_PATH=$library ./angle | tee seen
cmp -s - seen <<'TEXT' || {
Eigen: 1.00
Bullet, angle: 0.50
Bullet, angleShortestPath: 1.00
Imath: 0.50
OMPL: 0.50
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
