#!/bin/sh
# SPDX-License-Identifier: MIT
# DART 6.12.1 (Debian libdart-dev 6.12.1+dfsg4-12+b2): a body's momentum is in the body's own axes,
# unlike its velocity.
#
# Expected: BodyNode::getLinearMomentum() is the mass times getCOMLinearVelocity(), and the momentum
# of a skeleton is the sum over its bodies. All velocities and accelerations of a BodyNode are in
# world coordinates unless one asks for others.
# Seen: both momenta are in the axes of the body, and the angular one is about the body's origin, or
# a pivot in its coordinates. A body of 2 kg that moves at 1 m/s along X has 2 along X only while it
# is not turned: after a quarter turn about Z it has -2 along Y. A sum over bodies that are turned
# otherwise means nothing. Header and reference say "Return linear momentum", without a frame.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libdart-dev libdart6.12 libdart-external-odelcpsolver6.12 \
  libdart-external-odelcpsolver-dev libdart-external-convhull-3d-dev libdart-external-ikfast-dev; do
  apt-get -o APT::Sandbox::User=root download -q "$package=6.12.1+dfsg4-12+b2" >/dev/null
done
for package in libfcl-dev libfcl0.7 libccd-dev libccd2 liboctomap-dev liboctomap1.9 libeigen3-dev \
  libassimp-dev libassimp5 libboost1.74-dev libboost-filesystem1.74.0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'libdart.so' | head -n 1)")
cat >momentum.cpp <<'CPP'
#include <cstdio>
#include <dart/dart.hpp>
#include <initializer_list>

int main() {
  for (const double turn : {0.0, 90.0}) {
    const auto skeleton = dart::dynamics::Skeleton::create();
    const auto [joint, body] =
        skeleton->createJointAndBodyNodePair<dart::dynamics::FreeJoint>();
    body->setMass(2);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.rotate(Eigen::AngleAxisd(turn * M_PI / 180, Eigen::Vector3d::UnitZ()));
    joint->setTransform(pose);
    joint->setLinearVelocity({1, 0, 0});
    const Eigen::Vector3d velocity = body->getCOMLinearVelocity();
    const Eigen::Vector3d momentum = body->getLinearMomentum();
    std::printf("turned by %.0f: velocity %.0f %.0f, momentum %.0f %.0f\n", turn, velocity.x(),
                velocity.y() + 0.0, momentum.x() + 0.0, momentum.y() + 0.0);
  }
}
CPP
g++ -std=c++17 -w -O1 -I usr/include -I usr/include/eigen3 momentum.cpp -o momentum -L "$library" \
  -Wl,-rpath-link,"$library" -ldart -lassimp -lfcl -lccd -loctomap
LD_LIBRARY_PATH=$library ./momentum | sed 's/-0\b/0/g' | tee seen
printf '%s\n' 'turned by 0: velocity 1 0, momentum 2 0' 'turned by 90: velocity 1 0, momentum 0 -2' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
