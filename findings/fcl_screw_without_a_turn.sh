#!/bin/sh
# SPDX-License-Identifier: MIT
# FCL 0.7.0 (Debian libfcl-dev 0.7.0-3+b1): a screw motion between two poses that differ by a
# translation only covers the square of the way.
#
# Expected: ScrewMotion(a, b) is at a at time 0 and at b at time 1, as the other motions are, and
# without a turn it is the straight way between them.
# Seen: with a turn, of 0.001 rad too, it ends at b. Without one the axis is the whole way instead
# of its direction, and is multiplied by the way's length once more: 2 m become 4 m, and 0.5 m
# become 0.25 m. So with CCDM_SCREW continuousCollide gives a contact's time as 0.22 where it is
# 0.445. Only a way of 1, the usual one in a test, comes out right. Issue 119 of the project, open
# since 2016, shows a case.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libfcl-dev=0.7.0-3+b1 libfcl0.7=0.7.0-3+b1 libccd-dev libccd2 liboctomap-dev \
  liboctomap1.9 libeigen3-dev; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'libfcl.so' | head -n 1)")
cat >screw.cpp <<'CPP'
#include <cstdio>
#include <fcl/fcl.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/screw_motion.h>
#include <initializer_list>

double end(const fcl::MotionBase<double>& motion) {
  fcl::Transform3d pose;
  motion.integrate(1);
  motion.getCurrentTransform(pose);
  return pose.translation().z();
}

int main() {
  for (const double turn : {0.0, 0.001}) {
    for (const double way : {0.5, 1.0, 2.0}) {
      const fcl::Transform3d from = fcl::Transform3d::Identity();
      fcl::Transform3d to = from;
      to.rotate(fcl::AngleAxisd(turn, fcl::Vector3d::UnitZ()));
      to.translation().z() = way;
      std::printf("turn %.3f, way %.1f: the screw ends at %.2f, the interpolation at %.2f\n", turn, way,
                  end(fcl::ScrewMotion<double>(from, to)), end(fcl::InterpMotion<double>(from, to)));
    }
  }
}
CPP
g++ -std=c++17 -w -O1 -I usr/include -I usr/include/eigen3 screw.cpp -o screw -L "$library" \
  -lfcl -lccd -Wl,-rpath-link,"$library"
LD_LIBRARY_PATH=$library ./screw | tee seen
printf 'turn %s, way %s: the screw ends at %s, the interpolation at %s\n' 0.000 0.5 0.25 0.50 \
  0.000 1.0 1.00 1.00 0.000 2.0 4.00 2.00 0.001 0.5 0.50 0.50 0.001 1.0 1.00 1.00 \
  0.001 2.0 2.00 2.00 | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
