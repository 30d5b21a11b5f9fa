#!/bin/sh
# SPDX-License-Identifier: MIT
# GLM 0.9.9.8 (Debian libglm-dev 0.9.9.8+ds-6): axisAngle() says 45 degrees of every matrix, and
# interpolate() turns by that.
#
# Expected: axisAngle(m, axis, angle) of gtx/matrix_interpolation.hpp gives the angle by which m
# turns, and interpolate(a, b, 1) is b.
# Seen: axis is right and angle is pi / 4, whether m turns by 5, 90 or 170 degrees. A test for an angle
# of about zero asks whether cos(angle) - 1 < 0.01, without the absolute value, which is always so.
# So interpolate() between poses 20 degrees apart goes past the second one and ends at 45. Issue 764
# of g-truc/glm tells of it; it is mended in 0.9.9.9. slerp of quaternions is right.
# Flinch: turns by Eigen, and blends by a slerp of its own, motion/interpolation.h.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libglm-dev=0.9.9.8+ds-6 >/dev/null
dpkg-deb -x libglm-dev_*.deb .
cat >turn.cpp <<'CPP'
#define GLM_ENABLE_EXPERIMENTAL
#include <cstdio>
#include <initializer_list>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/matrix_interpolation.hpp>

int main() {
  const glm::dvec3 up(0, 0, 1);
  const glm::dmat4 start(1);
  for (const double degrees : {5.0, 20.0, 90.0, 170.0}) {
    const glm::dmat4 turn = glm::rotate(start, glm::radians(degrees), up);
    glm::dvec3 axis;
    double angle = 0;
    glm::axisAngle(turn, axis, angle);
    const double by_quaternion = glm::angle(glm::quat_cast(glm::interpolate(start, turn, 1.0)));
    std::printf("%.0f: axisAngle %.0f, interpolate to the end %.0f, quat_cast %.0f\n", degrees,
                glm::degrees(angle), glm::degrees(by_quaternion),
                glm::degrees(glm::angle(glm::quat_cast(turn))));
  }
}
CPP
g++ -std=c++17 -I usr/include turn.cpp -o turn
./turn | tee seen
for degrees in 5 20 90 170; do
  echo "$degrees: axisAngle 45, interpolate to the end 45, quat_cast $degrees"
done | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
