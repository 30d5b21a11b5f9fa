#!/bin/sh
# SPDX-License-Identifier: MIT
# NLopt 2.7.1 (Debian libnlopt-dev 2.7.1-5): the seed is that of one thread, and a search in another thread
# draws from the clock.
#
# Expected: nlopt_srand(7) at the start of a program makes all of its searches the same in each run, or a
# search without a seed begins like any other one.
# Seen: generator and seed are of the thread that called nlopt_srand. A search by ESCH in the thread that
# called it gives the same each time that it is called, and five searches in other threads give several
# results, others in each run of the program. Restarts that are spread over threads cannot be had again.
# nlopt_srand in the thread itself mends it.
# Flinch: does not use it. Each of its draws is a function of seed and counter.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libnlopt-dev libnlopt0; do
  apt-get -o APT::Sandbox::User=root download -q "$package=2.7.1-5" >/dev/null
  dpkg-deb -x "$package"_2.7.1-5_*.deb .
done
library=$(dirname "$(find . -name 'libnlopt.so' | head -n 1)")
cat >threads.cpp <<'CPP'
#include <cmath>
#include <cstdio>
#include <nlopt.h>
#include <set>
#include <thread>

double waves(unsigned count, const double* x, double*, void*) {
  double sum = 10 * count;
  for (unsigned i = 0; i < count; ++i) sum += x[i] * x[i] - 10 * std::cos(6.283185307179586 * x[i]);
  return sum;
}

double search() {
  const nlopt_opt way = nlopt_create(NLOPT_GN_ESCH, 4);
  nlopt_set_lower_bounds1(way, -5);
  nlopt_set_upper_bounds1(way, 4);
  nlopt_set_min_objective(way, waves, nullptr);
  nlopt_set_maxeval(way, 500);
  double x[4] = {1, 1, 1, 1};
  double least = 0;
  nlopt_optimize(way, x, &least);
  nlopt_destroy(way);
  return least;
}

int main() {
  std::set<double> here;
  std::set<double> in_threads;
  std::set<double> seeded_there;
  for (int i = 0; i < 5; ++i) {
    nlopt_srand(7);
    here.insert(search());
    std::thread([&] { in_threads.insert(search()); }).join();
    std::thread([&] {
      nlopt_srand(7);
      seeded_there.insert(search());
    }).join();
  }
  std::printf("seed 7: %zu result of 5 searches, in threads %s, seeded in the threads %zu\n", here.size(),
              in_threads.size() > 1 ? "several" : "one", seeded_there.size());
}
CPP
g++ -O1 -w -I usr/include threads.cpp -o threads -L "$library" -lnlopt -pthread
LD_LIBRARY_PATH=$library ./threads | tee seen
cmp -s - seen <<'TEXT' || {
seed 7: 1 result of 5 searches, in threads several, seeded in the threads 1
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
