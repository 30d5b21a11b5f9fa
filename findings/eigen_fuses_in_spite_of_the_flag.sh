#!/bin/sh
# SPDX-License-Identifier: MIT
# Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4): -ffp-contract=off does not keep Eigen from fused
# multiply-add.
#
# Expected: compiled with -ffp-contract=off, a product is rounded before it is added, with -mfma or
# -march=native as without. The flag is there for that.
# Seen: the flag binds the compiler, and Eigen's own kernels call the intrinsics of FMA wherever
# __FMA__ is defined. A 3x3 matrix times a vector has another last bit with -mfma, while the same sum
# written as a loop has not. 3.4 has no macro that turns FMA alone off.
# Flinch: the default build has no -mfma, and docs/determinism.md says what other builds leave open.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
grep -qw fma /proc/cpuinfo || { echo "a processor without FMA: nothing to see"; exit 0; }
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libeigen3-dev=3.4.0-4 >/dev/null
dpkg-deb -x libeigen3-dev_3.4.0-4_all.deb .
cat >product.cpp <<'CPP'
#include <Eigen/Dense>
#include <cstdio>

int main() {
  Eigen::Matrix3d m;
  m << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9;
  const Eigen::Vector3d v(0.1, 0.7, 0.3);
  const Eigen::Vector3d product = m * v;
  double loop = 0;
  for (int i = 0; i < 3; ++i) loop += m(1, i) * v[i];
  std::printf("loop %.17g, Eigen %.17g\n", loop, product[1]);
}
CPP
for fma in -mno-fma -mfma; do
  g++ -O2 -mavx2 -ffp-contract=off $fma -I usr/include/eigen3 product.cpp -o product
  echo "$fma: $(./product)"
done | tee seen
printf '%s\n' '-mno-fma: loop 0.57000000000000006, Eigen 0.57000000000000006' \
  '-mfma: loop 0.57000000000000006, Eigen 0.56999999999999995' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
