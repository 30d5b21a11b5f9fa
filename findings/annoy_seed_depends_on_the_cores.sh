#!/bin/sh
# SPDX-License-Identifier: MIT
# Annoy 1.17 (Debian r-cran-rcppannoy 0.0.20-1, its annoylib.h): with the same seed, the neighbours depend on
# the number of threads, which is by default that of the cores.
#
# Expected: set_seed(7) makes an index that is the same on each machine. Threads build its trees faster, and
# the trees are the same.
# Seen: each thread has a generator of its own that starts from the seed plus the thread's number, and
# builds its share of the trees by it. With 2 threads 120 of 200 queries have another nearest neighbour
# than with 1, with 4 threads 165. The same number of threads gives the same index. So a study that was
# run on a laptop is not the one of the server, unless build() is given a number of threads.
# Flinch: has no approximate index, and its answers do not depend on threads.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q r-cran-rcppannoy=0.0.20-1 >/dev/null
dpkg-deb -x r-cran-rcppannoy_*.deb .
cat >threads.cpp <<'CPP'
#include <annoylib.h>
#include <cstdio>
#include <kissrandom.h>
#include <random>
#include <vector>

using Index = AnnoyIndex<int, float, Euclidean, Kiss64Random, AnnoyIndexMultiThreadedBuildPolicy>;
using Rows = std::vector<std::vector<float>>;

Rows draw(std::mt19937& generator, int count) {
  Rows rows(count, std::vector<float>(20));
  for (auto& row : rows)
    for (float& x : row) x = static_cast<float>(generator() / 4294967296.0);
  return rows;
}

std::vector<int> nearest(const Rows& rows, const Rows& asked, int threads) {
  Index index(20);
  index.set_seed(7);
  for (std::size_t i = 0; i < rows.size(); ++i) index.add_item(static_cast<int>(i), rows[i].data());
  index.build(8, threads);
  std::vector<int> found;
  std::vector<float> distances;
  for (const auto& row : asked) index.get_nns_by_vector(row.data(), 1, -1, &found, &distances);
  return found;
}

int main() {
  std::mt19937 generator(1);
  const Rows rows = draw(generator, 3000);
  const Rows asked = draw(generator, 200);
  const std::vector<int> first = nearest(rows, asked, 1);
  for (const int threads : {1, 2, 2, 4, 4}) {
    const std::vector<int> found = nearest(rows, asked, threads);
    int others = 0;
    for (std::size_t i = 0; i < found.size(); ++i) others += found[i] != first[i];
    std::printf("%d threads: %d of 200 neighbours are others\n", threads, others);
  }
}
CPP
g++ -std=c++14 -O1 -w -DANNOYLIB_MULTITHREADED_BUILD -I usr/lib/R/site-library/RcppAnnoy/include \
  threads.cpp -o threads -pthread
./threads | tee seen
cmp -s - seen <<'TEXT' || {
1 threads: 0 of 200 neighbours are others
2 threads: 120 of 200 neighbours are others
2 threads: 120 of 200 neighbours are others
4 threads: 165 of 200 neighbours are others
4 threads: 165 of 200 neighbours are others
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
