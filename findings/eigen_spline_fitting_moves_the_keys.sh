#!/bin/sh
# SPDX-License-Identifier: MIT
# Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4): a spline through keys does not reach them at their times,
# and with times in seconds it leaves them.
#
# Expected: SplineFitting::Interpolate of five keys that are as far from each other in time gives a curve
# which is at the second one after a quarter. With the keys' times in seconds as its third argument, the
# curve is at each key at its time.
# Seen: without times, they follow from the distances: of a hand that moves slowly to 0.3 m and strikes
# to 2 m, the curve moves evenly, and is at 0.5 m when the hand is at 0.1. With the times 0, 1, 2, 3 and 4
# the ends of its knots are still 0 and 1: the first keys are reached, and at 4 s the curve is at -7 m,
# without an error. Only times from 0 to 1 give what is expected.
# Flinch: interpolates keys by its own functions, motion/interpolation.h.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libeigen3-dev=3.4.0-4 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >strike.cpp <<'CPP'
#include <Eigen/Core>
#include <cstdio>
#include <unsupported/Eigen/Splines>

int main() {
  using Curve = Eigen::Spline<double, 1>;
  using Fit = Eigen::SplineFitting<Curve>;
  Eigen::RowVectorXd keys(5), seconds(5);
  keys << 0, 0.1, 0.2, 0.3, 2;
  seconds << 0, 1, 2, 3, 4;
  const auto tell = [](const char* name, const Curve& curve, double end) {
    std::printf("%s:", name);
    for (int key = 0; key < 5; ++key) std::printf(" %.1f", curve(key * end / 4)[0] + 1e-9);
    std::puts(" m");
  };
  tell("without times", Fit::Interpolate(keys, 3), 1);
  tell("with seconds", Fit::Interpolate(keys, 3, seconds), 4);
  tell("with seconds / 4", Fit::Interpolate(keys, 3, (seconds / 4).eval()), 1);
}
CPP
g++ -std=c++17 -w -O1 -I usr/include/eigen3 strike.cpp -o strike
./strike | tee seen
cmp -s - seen <<'TEXT' || {
without times: 0.0 0.5 1.0 1.5 2.0 m
with seconds: 0.0 0.1 0.2 0.3 -7.2 m
with seconds / 4: 0.0 0.1 0.2 0.3 2.0 m
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
