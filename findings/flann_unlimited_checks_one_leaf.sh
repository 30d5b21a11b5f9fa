#!/bin/sh
# SPDX-License-Identifier: MIT
# FLANN 1.9.2 (Debian libflann-dev 1.9.2+dfsg-1+deb12u1): unlimited checks make the hierarchical
# clustering index search least.
#
# Expected: SearchParams(FLANN_CHECKS_UNLIMITED) looks at every leaf and finds the true nearest
# neighbour; more checks never find less.
# Seen: FLANN_CHECKS_UNLIMITED is -1. The kd-tree and k-means indexes look for that value and search
# exactly, the hierarchical clustering index compares it with its count of checks: the limit is
# passed before it begins, and it descends to one leaf. Half of 500 searches miss the nearest of 2000
# points, where 256 checks miss few and 2000 none.
# Flinch: searches by FLANN's single kd-tree, which is exact and has no checks.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libflann-dev libflann1.9; do
  apt-get -o APT::Sandbox::User=root download -q "$package=1.9.2+dfsg-1+deb12u1" >/dev/null
done
apt-get -o APT::Sandbox::User=root download -q liblz4-dev >/dev/null  # FLANN's headers need it
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'liblz4.so' | head -n 1)")
cat >search.cpp <<'CPP'
#include <flann/flann.hpp>
#include <cstdio>
#include <random>
#include <vector>

using Index = flann::Index<flann::L2<float>>;
using Points = flann::Matrix<float>;

std::vector<float> nearest(Index& index, const Points& queries, int checks) {
  std::vector<int> ids(queries.rows);
  std::vector<float> distances(queries.rows);
  flann::Matrix<int> id(ids.data(), queries.rows, 1);
  Points distance(distances.data(), queries.rows, 1);
  index.knnSearch(queries, id, distance, 1, flann::SearchParams(checks));
  return distances;
}

int main() {
  constexpr int kPoints = 2000;
  constexpr int kQueries = 500;
  constexpr int kDimensions = 8;
  std::mt19937 generator(1);
  std::vector<float> numbers((kPoints + kQueries) * kDimensions);
  for (float& number : numbers) number = static_cast<float>(generator()) / 4294967296.0F;
  const Points points(numbers.data(), kPoints, kDimensions);
  const Points queries(numbers.data() + kPoints * kDimensions, kQueries, kDimensions);
  Index exact(points, flann::LinearIndexParams());
  Index k_means(points, flann::KMeansIndexParams());
  Index hierarchical(points, flann::HierarchicalClusteringIndexParams());
  for (Index* index : {&exact, &k_means, &hierarchical}) index->buildIndex();
  const std::vector<float> truth = nearest(exact, queries, 1);
  const auto missed = [&](Index& index, int checks) {
    const std::vector<float> found = nearest(index, queries, checks);
    int count = 0;
    for (int i = 0; i < kQueries; ++i) count += found[i] > truth[i];
    return count;
  };
  const int some = missed(hierarchical, 256);
  const int many = missed(hierarchical, 2000);
  const int unlimited = missed(hierarchical, flann::FLANN_CHECKS_UNLIMITED);
  const int other = missed(k_means, flann::FLANN_CHECKS_UNLIMITED);
  std::printf("hierarchical: of %d searches 256 checks miss %d, 2000 miss %d, unlimited miss %d\n",
              kQueries, some, many, unlimited);
  std::printf("k-means: unlimited miss %d\n", other);
  return some < 50 && many == 0 && unlimited > 100 && other == 0 ? 0 : 1;
}
CPP
g++ -O1 -I usr/include search.cpp -o search -L "$library" -llz4
./search || { echo "the behaviour has changed" >&2; exit 1; }
