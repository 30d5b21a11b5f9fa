#!/bin/sh
# SPDX-License-Identifier: MIT
# Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4): the sum of the same numbers depends on where they lie in
# memory.
#
# Expected: sum() of a Map, or of a part of a vector, adds the same values in the same order whatever
# their address is. mean() likewise.
# Seen: what lies before the first aligned address is added last and by itself, so a shift by a few
# bytes deals the numbers to the four lanes in another way. The sums of 1001 floats at the eight
# places of a 32-byte line, in one program, have more than one value. A Map over data that another
# library allocated, or a segment, can so change its last bits from run to run. dot() does not.
# Flinch: sums that decide what a file holds are in Flinch's own fixed order.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libeigen3-dev=3.4.0-4 >/dev/null
dpkg-deb -x libeigen3-dev_3.4.0-4_all.deb .
cat >sum.cpp <<'CPP'
#include <Eigen/Dense>
#include <cstdio>
#include <set>

int main() {
  constexpr int kCount = 1001;
  alignas(32) static float memory[kCount + 8];
  const Eigen::VectorXf ones = Eigen::VectorXf::Ones(kCount);
  std::set<float> sums, dots;
  for (int shift = 0; shift < 8; ++shift) {
    Eigen::Map<Eigen::VectorXf> numbers(memory + shift, kCount);
    for (int i = 0; i < kCount; ++i) numbers[i] = 1.0F / static_cast<float>(1 + i % 97);
    std::printf("shifted by %2d bytes: sum %.9g, dot with ones %.9g\n", 4 * shift,
                static_cast<double>(numbers.sum()), static_cast<double>(numbers.dot(ones)));
    sums.insert(numbers.sum());
    dots.insert(numbers.dot(ones));
  }
  return sums.size() > 1 && dots.size() == 1 ? 0 : 1;
}
CPP
g++ -O2 -I usr/include/eigen3 sum.cpp -o sum
./sum || { echo "the behaviour has changed" >&2; exit 1; }
