#!/bin/sh
# SPDX-License-Identifier: MIT
# ODE 0.16.2 (Debian libode-dev 2:0.16.2-1): with a step of 1 ms in place of 10, the same damping brakes a body
# ten times as fast, and does nothing at all below 0.01 m/s.
#
# Expected: a damping is a rate per second, as in Bullet, Box2D and Jolt, and a smaller step computes the
# same motion more precisely.
# Seen: dBodySetLinearDamping and dBodySetAngularDamping give the share of the speed that each step takes. A
# body at 1 m/s with 0.01 has 0.37 m/s after a second in steps of 10 ms, 0.13 in steps of 5 ms, and 0.01 in
# steps of 1 ms; from there on it keeps its speed for good, since damping has a threshold of its own. Who
# halves the step for precision halves the scale too, and lowers the threshold.
# Flinch: its bodies in ODE have no damping; what resists is in the joints.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libode-dev libode8; do
  apt-get -o APT::Sandbox::User=root download -q "$package=2:0.16.2-1" >/dev/null
done
apt-get -o APT::Sandbox::User=root download -q libccd2 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'libode.so' | head -n 1)")
cat >brake.cpp <<'CPP'
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <ode/ode.h>

/// The speed that is left of 1 m/s, with a damping of 0.01.
double left(double step, double seconds) {
  const dWorldID world = dWorldCreate();
  const dBodyID body = dBodyCreate(world);
  dBodySetLinearDamping(body, 0.01);
  dBodySetLinearVel(body, 1, 0, 0);
  for (long i = 0; i < std::lround(seconds / step); ++i) dWorldStep(world, step);
  const double speed = dBodyGetLinearVel(body)[0];
  dWorldDestroy(world);
  return speed;
}

int main() {
  dInitODE2(0);
  for (const double step : {0.01, 0.005, 0.001})
    std::printf("steps of %g ms: %.4f m/s after 1 s, %.4f m/s after 20 s\n", 1000 * step, left(step, 1),
                left(step, 20));
  dCloseODE();
}
CPP
g++ -DdIDEDOUBLE -I usr/include brake.cpp -o brake -L "$library" -lode
LD_LIBRARY_PATH=$library ./brake | tee seen
cmp -s - seen <<'TEXT' || {
steps of 10 ms: 0.3660 m/s after 1 s, 0.0099 m/s after 20 s
steps of 5 ms: 0.1340 m/s after 1 s, 0.0099 m/s after 20 s
steps of 1 ms: 0.0099 m/s after 1 s, 0.0099 m/s after 20 s
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
