#!/bin/sh
# SPDX-License-Identifier: MIT
# libkdtree++ 0.7.1 (Debian libkdtree++-dev 0.7.1+git20101123-6): the points within a range are those in a
# cube, while the greatest distance of find_nearest is the radius of a ball.
#
# Expected: find_within_range(point, 0.2) gives the points at most 0.2 away, as find_nearest(point, 0.2)
# gives the nearest of these.
# Seen: it gives all whose coordinates differ by at most 0.2, up to 0.35 away: nearly twice as many in
# three dimensions (a cube has 1.91 times the volume of its ball), and here fifteen times in six. A comment
# in the header says so, and calls it Manhattan distance, which it is not.
# Flinch: searches by FLANN, by Euclidean distance.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libkdtree++-dev=0.7.1+git20101123-6 >/dev/null
dpkg-deb -x libkdtree++-dev_*.deb .
cat >range.cpp <<'CPP'
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <kdtree++/kdtree.hpp>
#include <random>
#include <vector>

template <std::size_t kSize>
void count(double range) {
  using Point = std::array<double, kSize>;
  std::mt19937 draw(1);
  KDTree::KDTree<kSize, Point> tree;
  std::vector<Point> points(20000);
  for (Point& point : points) {
    for (double& x : point) x = draw() / 4294967296.0 - 0.5;
    tree.insert(point);
  }
  tree.optimise();
  const Point origin{};
  const auto distance = [](const Point& point) {
    double sum = 0;
    for (const double x : point) sum += x * x;
    return std::sqrt(sum);
  };
  std::vector<Point> found;
  tree.find_within_range(origin, range, std::back_inserter(found));
  double farthest = 0;
  for (const Point& point : found) farthest = std::max(farthest, distance(point));
  const auto within = std::count_if(points.begin(), points.end(), [&](const Point& point) {
    return distance(point) <= range;
  });
  std::printf("%zu dimensions, range %.1f: %zu found, the farthest at %.2f; %td are within\n", kSize,
              range, found.size(), farthest, within);
}

int main() {
  count<3>(0.2);
  count<6>(0.3);
}
CPP
g++ -std=c++17 -O1 -w -I usr/include range.cpp -o range
./range | tee seen
cmp -s - seen <<'TEXT' || {
3 dimensions, range 0.2: 1309 found, the farthest at 0.33; 699 are within
6 dimensions, range 0.3: 944 found, the farthest at 0.64; 63 are within
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
