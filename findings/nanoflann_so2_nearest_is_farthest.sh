#!/bin/sh
# SPDX-License-Identifier: MIT
# nanoflann 1.4.3 (Debian libnanoflann-dev 1.4.3+ds-2): of angles, the nearest neighbour is the one
# that lies farthest clockwise, and a quaternion is not found by its negative.
#
# Expected: metric_SO2 is for angles in [-pi, pi], its README calls it the absolute angular
# difference, so the neighbour of an angle is the one with the shortest way to it. metric_SO3 is for
# unit quaternions, where q and -q are one rotation.
# Seen: SO2_Adaptor's distance is signed, the stored angle less the asked one. The least distance is
# the most negative one: of eight angles around the circle, 2.90, 2.98 and 2.50 rad away are the
# "nearest", each nearly a half turn, and the distance that comes with it is negative. SO3_Adaptor
# is the Euclidean distance of the four numbers, which its comment says, so of 100 rotations none is
# found by its negative.
# Flinch: searches numbers only, by FLANN.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libnanoflann-dev=1.4.3+ds-2 >/dev/null
dpkg-deb -x libnanoflann-dev_*.deb .
cat >nearest.cpp <<'CPP'
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <nanoflann.hpp>
#include <random>
#include <vector>

template <int N>
struct Points : std::vector<std::array<double, N>> {
  std::size_t kdtree_get_point_count() const { return this->size(); }
  double kdtree_get_pt(std::size_t point, std::size_t number) const { return (*this)[point][number]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const { return false; }
};

int main() {
  Points<1> angles;
  for (int i = 0; i < 8; ++i) angles.push_back({-3.0 + 0.8 * i});
  using Circle =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::SO2_Adaptor<double, Points<1>>, Points<1>, 1>;
  const Circle circle(1, angles);
  for (const double asked : {-3.1, 0.3, 3.1}) {
    std::uint32_t found = 0;
    double distance = 0;
    circle.knnSearch(&asked, 1, &found, &distance);
    double nearest = 4;
    for (const auto& [angle] : angles) {
      nearest = std::fmin(nearest, std::fabs(std::remainder(angle - asked, 2 * M_PI)));
    }
    std::printf("of %.1f rad: %.2f rad away by metric_SO2, the nearest is %.2f rad away\n", asked,
                distance, nearest);
  }

  std::mt19937 draw(1);
  std::normal_distribution<double> normal;
  Points<4> rotations;
  for (int i = 0; i < 100; ++i) {
    std::array<double, 4> q = {normal(draw), normal(draw), normal(draw), normal(draw)};
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& number : q) number /= length;
    rotations.push_back(q);
  }
  using Sphere =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::SO3_Adaptor<double, Points<4>>, Points<4>, 4>;
  const Sphere sphere(4, rotations);
  int itself = 0;
  for (std::uint32_t i = 0; i < 100; ++i) {
    std::array<double, 4> negative = rotations[i];
    for (double& number : negative) number = -number;
    std::uint32_t found = 0;
    double distance = 0;
    sphere.knnSearch(negative.data(), 1, &found, &distance);
    itself += found == i ? 1 : 0;
  }
  std::printf("of 100 rotations %d are found by the negative quaternion\n", itself);
}
CPP
g++ -std=c++17 -O1 -I usr/include nearest.cpp -o nearest
./nearest | tee seen
printf '%s\n' 'of -3.1 rad: -2.98 rad away by metric_SO2, the nearest is 0.10 rad away' \
  'of 0.3 rad: -2.50 rad away by metric_SO2, the nearest is 0.10 rad away' \
  'of 3.1 rad: -2.90 rad away by metric_SO2, the nearest is 0.18 rad away' \
  'of 100 rotations 0 are found by the negative quaternion' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
