#!/bin/sh
# SPDX-License-Identifier: MIT
# Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4): Quaternionf::FromTwoVectors loses four digits near a
# half turn.
#
# Expected: the rotation takes one unit vector to the other within float rounding, some 1e-7, for
# whatever angle is between them.
# Seen: the error grows from 3e-7 at 90 degrees to 4e-4 at 178 and 9e-3 at 179.5, which is 9 mm for an
# arm of 1 m, and falls again beyond: the float axis is taken from the sum of two vectors that almost
# cancel, and only within some 0.1 degrees of opposite from a decomposition. In double it is 5e-8 at
# the worst. So a retargeted bone that points almost backwards comes out bent.
# Flinch: motion/rotation.h has rotation_between, whose error stays below 2e-6, by test.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libeigen3-dev=3.4.0-4 >/dev/null
dpkg-deb -x libeigen3-dev_3.4.0-4_all.deb .
cat >two_vectors.cpp <<'CPP'
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>

/// The largest distance of the rotated vector from where it should be, over 360 pairs of unit vectors.
double worst(double degrees) {
  double worst = 0;
  for (int i = 0; i < 360; ++i) {
    const double t = i * M_PI / 180;
    const Eigen::Vector3d from = Eigen::Vector3d(std::cos(t), std::sin(t), 0.3).normalized();
    const Eigen::Vector3d axis = from.cross(Eigen::Vector3d(0.2, 0.5, 1)).normalized();
    const Eigen::Vector3d to = Eigen::AngleAxisd(degrees * M_PI / 180, axis) * from;
    const Eigen::Vector3f f = from.cast<float>(), g = to.cast<float>();
    worst = std::max(worst, double((Eigen::Quaternionf::FromTwoVectors(f, g) * f - g).norm()));
  }
  return worst;
}

int main() {
  for (double degrees : {90.0, 170.0, 178.0, 179.0, 179.5, 179.9})
    std::printf("%5.1f degrees apart: error %.1e\n", degrees, worst(degrees));
  return worst(90) < 1e-6 && worst(178) > 1e-4 && worst(179.5) > 1e-3 ? 0 : 1;
}
CPP
g++ -std=c++17 -O1 -I usr/include/eigen3 two_vectors.cpp -o two_vectors
./two_vectors || { echo "the behaviour has changed" >&2; exit 1; }
