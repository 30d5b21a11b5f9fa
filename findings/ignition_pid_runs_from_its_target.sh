#!/bin/sh
# SPDX-License-Identifier: MIT
# Ignition Math 6.10.0 (Debian libignition-math-dev 6.10.0+ds3-7+b4): a PID controller that is told how far
# there is to go pushes the other way.
#
# Expected: the error is the target less the state, as in textbooks and in ROS' control_toolbox, and with
# positive gains the command goes towards the target.
# Seen: Update() wants the state less the target and returns the negative of its terms. A mass that should
# go from 0 to 1 m by a spring and damper of 10 N/m and 6 N s/m is at -12 km after 10 s with the usual
# error, and at 1 m with the other. A word of the parameter's comment in the header is all that says so.
# Flinch: does not use it; the servos of evolve/ are its own.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libignition-math-dev=6.10.0+ds3-7+b4 libignition-math6-6=6.10.0+ds3-7+b4; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >servo.cpp <<'CPP'
#include <chrono>
#include <cstdio>
#include <ignition/math/PID.hh>

/// A mass of 1 kg after 10 s, that should go to 1 m.
double place(double sign) {
  const std::chrono::duration<double> step(0.01);
  ignition::math::PID controller(10, 0, 6);
  double position = 0;
  double speed = 0;
  for (int i = 0; i < 1000; ++i) {
    speed += controller.Update(sign * (1 - position), step) * step.count();
    position += speed * step.count();
  }
  return position;
}

int main() {
  std::printf("target less state: %s\n", place(1) < -1000 ? "far behind the start" : "not so");
  std::printf("state less target: %.2f m\n", place(-1));
  std::printf("1 m to go, gain 10: command %.0f\n",
              ignition::math::PID(10, 0, 0).Update(1, std::chrono::duration<double>(0.01)));
}
CPP
g++ -std=c++17 -w -I usr/include/ignition/math6 servo.cpp -o servo -L "$library" -l:libignition-math6.so.6
LD_LIBRARY_PATH=$library ./servo | tee seen
cmp -s - seen <<'TEXT' || {
target less state: far behind the start
state less target: 1.00 m
1 m to go, gain 10: command -10
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
