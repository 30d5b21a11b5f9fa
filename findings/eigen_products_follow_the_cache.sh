#!/bin/sh
# SPDX-License-Identifier: MIT
# Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4): the bits of a matrix product depend on the size of the
# processor's caches.
#
# Expected: one binary, built for one instruction set, gives the same product on any processor that
# runs it.
# Seen: a product of two larger matrices is cut into blocks whose depth follows the first-level cache
# that the processor reports (CPUID), and each block's sums are added one after the other. So the
# order of the additions, and with it the last bits, change with the machine. Eigen lets a program
# state the sizes (setCpuCacheSizes); stated sizes of 16, 32 and 48 KiB, which are those of real
# processors, give three different products here.
# Flinch: sums that decide what a file holds are in Flinch's own fixed order.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libeigen3-dev=3.4.0-4 >/dev/null
dpkg-deb -x libeigen3-dev_3.4.0-4_all.deb .
cat >product.cpp <<'CPP'
#include <Eigen/Dense>
#include <cstdio>

int main() {
  Eigen::MatrixXd a(64, 4000), b(4000, 64);
  for (int i = 0; i < a.size(); ++i) a.data()[i] = 1.0 / (1 + i % 97);
  for (int i = 0; i < b.size(); ++i) b.data()[i] = 1.0 / (3 + i % 89);
  Eigen::MatrixXd first;
  for (const int cache_kib : {16, 32, 48}) {
    Eigen::setCpuCacheSizes(cache_kib * 1024, 1 << 20, 8 << 20);
    const Eigen::MatrixXd product = a * b;
    if (first.size() == 0) first = product;
    std::printf("%d KiB: %td of %td entries differ from those of 16 KiB\n", cache_kib,
                (product.array() != first.array()).count(), product.size());
  }
}
CPP
g++ -O2 -I usr/include/eigen3 product.cpp -o product
./product | tee seen
grep -q '^16 KiB: 0 of' seen && ! grep -qE '^(32|48) KiB: 0 of' seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
