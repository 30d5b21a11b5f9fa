#!/bin/sh
# SPDX-License-Identifier: MIT
# Orocos KDL 1.5.1 (Debian liborocos-kdl-dev 1.5.1-2+b4): a joint's damping and stiffness are in
# none of its equations of motion.
#
# Expected: Joint takes inertia, damping and stiffness "along the joint axis", and the dynamic
# solvers of the same library add them to the links' own: a joint with a damping of 5 N m s/rad that
# turns at 2 rad/s needs 10 N m more, or accelerates less.
# Seen: the joint's inertia is in the inverse and the forward dynamics. Damping and stiffness are
# kept by the joint and read by no solver: with 5 and 50 the torque stays 3 N m and the acceleration
# 4 rad/s^2, as with 0. So a model's damping is lost without a word.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in liborocos-kdl-dev=1.5.1-2+b4 liborocos-kdl1.5=1.5.1-2+b4 libeigen3-dev; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'liborocos-kdl.so' | head -n 1)")
cat >joint.cpp <<'CPP'
#include <cstdio>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

/// Prints the torque for 3 rad/s^2 and the acceleration for 4 N m of one joint with a mass of 1 kg at
/// 1 m, at 0.5 rad and 2 rad/s, without gravity.
void move(double inertia, double damping, double stiffness) {
  KDL::Chain chain;
  chain.addSegment(
      KDL::Segment(KDL::Joint(KDL::Joint::RotZ, 1, 0, inertia, damping, stiffness),
                   KDL::Frame(KDL::Vector(1, 0, 0)), KDL::RigidBodyInertia(1, KDL::Vector::Zero())));
  KDL::JntArray angle(1), velocity(1), acceleration(1), torque(1), given(1), gained(1);
  angle(0) = 0.5;
  velocity(0) = 2;
  acceleration(0) = 3;
  given(0) = 4;
  const KDL::Wrenches none(1);
  KDL::ChainIdSolver_RNE(chain, KDL::Vector::Zero())
      .CartToJnt(angle, velocity, acceleration, none, torque);
  KDL::ChainFdSolver_RNE(chain, KDL::Vector::Zero()).CartToJnt(angle, velocity, given, none, gained);
  std::printf("inertia %.0f, damping %.0f, stiffness %.0f: %.2f N m, %.2f rad/s^2\n", inertia, damping,
              stiffness, torque(0), gained(0));
}

int main() {
  move(0, 0, 0);
  move(1, 0, 0);
  move(0, 5, 0);
  move(0, 0, 50);
}
CPP
g++ -std=c++17 -w -O1 -I usr/include -I usr/include/eigen3 joint.cpp -o joint -L "$library" -lorocos-kdl
LD_LIBRARY_PATH=$library ./joint | tee seen
printf 'inertia %s, damping %s, stiffness %s: %s N m, %s rad/s^2\n' 0 0 0 3.00 4.00 1 0 0 6.00 2.00 \
  0 5 0 3.00 4.00 0 0 50 3.00 4.00 | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
