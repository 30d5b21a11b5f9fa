#!/bin/sh
# SPDX-License-Identifier: MIT
# FCL 0.7.0 (Debian libfcl-dev 0.7.0-3+b1): continuousCollide with its defaults looks at ten poses,
# and a ball goes through a plate between them.
#
# Expected: a continuous collision is what discrete checks miss: with the poses before and after a
# step, it finds whether and when two bodies touch on the way, to the given toc_err of 0.0001.
# Seen: the default of ContinuousCollisionRequest is CCDC_NAIVE, ten discrete checks along the way.
# A ball of 0.1 m that crosses a plate of 20 mm on a way of 2 m touches it at 0.445 of the way, and
# the answer is that they do not collide. Where a sample happens to hit, the time is the sample's:
# 0.333 for 0.260. Neither toc_err nor a warning has a part in it. With
# CCDC_CONSERVATIVE_ADVANCEMENT both times are right. The header calls the default a type of solver,
# without saying what it does.
# Flinch: does not use it. It solves for a ball's time of contact with each solid.
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
cat >through.cpp <<'CPP'
#include <cstdio>
#include <fcl/fcl.h>
#include <initializer_list>

int main() {
  const fcl::Sphered ball(0.1);
  const fcl::Boxd plate(2, 2, 0.02);
  const auto at = [](double height) {
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    pose.translation().z() = height;
    return pose;
  };
  for (const double from : {1.0, 0.5}) {
    for (const bool advance : {false, true}) {
      fcl::ContinuousCollisionRequestd request;
      if (advance) request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
      fcl::ContinuousCollisionResultd result;
      fcl::continuousCollide(&ball, at(from), at(-1), &plate, at(0), at(0), request, result);
      std::printf("from %.1f m to -1 m, %s: %s at %.3f, true at %.3f\n", from,
                  advance ? "advancement" : "default", result.is_collide ? "touch" : "no touch",
                  result.time_of_contact, (from - 0.11) / (from + 1));
    }
  }
}
CPP
g++ -std=c++17 -w -O1 -I usr/include -I usr/include/eigen3 through.cpp -o through -L "$library" \
  -lfcl -lccd -Wl,-rpath-link,"$library"
LD_LIBRARY_PATH=$library ./through | tee seen
printf 'from %s\n' '1.0 m to -1 m, default: no touch at 1.000, true at 0.445' \
  '1.0 m to -1 m, advancement: touch at 0.445, true at 0.445' \
  '0.5 m to -1 m, default: touch at 0.333, true at 0.260' \
  '0.5 m to -1 m, advancement: touch at 0.260, true at 0.260' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
