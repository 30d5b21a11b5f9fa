#!/bin/sh
# SPDX-License-Identifier: MIT
# GLM 0.9.9.8 (Debian libglm-dev 0.9.9.8+ds-6): the smoother the keys, the worse squad() is, as
# exp() of the zero quaternion is the zero quaternion.
#
# Expected: exp(0) = 1. Of keys that turn evenly about one axis, intermediate() is the key itself,
# and squad() is slerp.
# Seen: exp() gives (0, 0, 0, 0) where the vector part is shorter than the type's epsilon. That is
# what intermediate() asks it for wherever a motion is even or at rest, so its control point has
# length 0. Halfway between keys of 0.5 and 1 rad, squad() has length 0.71 and an angle of 1.71 rad
# instead of 0.75. If the keys around are off by 1e-6 rad, it has 0.75 again. At the keys themselves
# all is right, and normalize() does not mend what is between.
# Flinch: blends by a slerp of its own, motion/interpolation.h.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libglm-dev=0.9.9.8+ds-6 >/dev/null
dpkg-deb -x libglm-dev_*.deb .
cat >turn.cpp <<'CPP'
#define GLM_ENABLE_EXPERIMENTAL
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtx/quaternion.hpp>
#include <initializer_list>

int main() {
  const glm::dquat one = glm::exp(glm::dquat(0, 0, 0, 0));
  std::printf("exp(0) = %.0f %.0f %.0f %.0f\n", one.w, one.x, one.y, one.z);
  for (const double off : {0.0, 1e-6}) {
    glm::dquat keys[4];
    for (int i = 0; i < 4; ++i) {
      keys[i] = glm::angleAxis(0.5 * i + (i % 3 == 0 ? off : 0), glm::dvec3(0, 0, 1));
    }
    const glm::dquat half = glm::squad(keys[1], keys[2], glm::intermediate(keys[0], keys[1], keys[2]),
                                       glm::intermediate(keys[1], keys[2], keys[3]), 0.5);
    std::printf("outer keys off by %.0e rad: angle %.2f, length %.2f\n", off, glm::angle(half),
                glm::length(half));
  }
}
CPP
g++ -std=c++17 -O1 -I usr/include turn.cpp -o turn
./turn | tee seen
printf '%s\n' 'exp(0) = 0 0 0 0' 'outer keys off by 0e+00 rad: angle 1.71, length 0.71' \
  'outer keys off by 1e-06 rad: angle 0.75, length 1.00' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
