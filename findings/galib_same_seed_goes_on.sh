#!/bin/sh
# SPDX-License-Identifier: MIT
# GAlib 2.4.7 (Debian libga-dev 1:2.4.7-6): the second run with the same seed draws other numbers.
#
# Expected: evolve(42) starts the generator anew from 42, so two runs in one process are alike.
# Seen: evolve() calls GARandomSeed, which does nothing where the seed is the one that was set last.
# The second run goes on in the stream of the first. With another seed set between them the runs are
# alike. So a sweep over populations or rates with one seed compares runs of different streams, and
# none but the first can be had again alone.
# Flinch: does not use it. Each of its draws is a function of seed and counter.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libga-dev libga2; do
  apt-get -o APT::Sandbox::User=root download -q "$package=1:2.4.7-6" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'libga.so' | head -n 1)")
cat >runs.cpp <<'CPP'
#include <cstdio>
#include <ga/ga.h>

float ones(GAGenome& genome) {
  const auto& bits = dynamic_cast<const GA1DBinaryStringGenome&>(genome);
  int sum = 0;
  for (int i = 0; i < bits.length(); ++i) sum += bits.gene(i);
  return static_cast<float>(sum);
}

/// Evolves 8 strings of 64 bits for 20 generations.
void run(const char* what, unsigned seed) {
  const GA1DBinaryStringGenome genome(64, ones);
  GASimpleGA algorithm(genome);
  algorithm.populationSize(8);
  algorithm.nGenerations(20);
  algorithm.evolve(seed);
  const GAStatistics& of = algorithm.statistics();
  std::printf("%s: %.3f ones at first, %.3f at last\n", what, of.initial(), of.current());
}

int main() {
  run("seed 42", 42);
  run("seed 42 again", 42);
  GARandomSeed(7);
  run("seed 42 after 7", 42);
}
CPP
g++ -w -O1 -I usr/include runs.cpp -o runs -L "$library" -lga
LD_LIBRARY_PATH=$library ./runs | tee seen
sed 's/.*: //' seen | {
  read -r first
  read -r again
  read -r after
  [ "$again" != "$first" ] && [ "$after" = "$first" ]
} || {
  echo "the behaviour has changed" >&2
  exit 1
}
