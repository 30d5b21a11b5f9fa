#!/bin/sh
# SPDX-License-Identifier: MIT
# Irrlicht 1.8.5 (Debian libirrlicht-dev 1.8.5+ds2-1): halfway to a turn of less than 37 degrees, slerp
# and toAngleAxis say 1.4 times the angle, and a vector gets shorter.
#
# Expected: slerp between unit quaternions is a unit quaternion; halfway from none to a turn by 30
# degrees toAngleAxis says 15, as it says 30 of 60.
# Seen: it says 21. Where the quaternions are within 0.05 of each other, which is 36 degrees, slerp mixes
# them linearly and does not normalize; toAngleAxis takes the arc cosine of w all the same. A vector is
# turned by 14.7 degrees. Animation blends turns of that size in nearly each frame. normalize() after
# slerp, or a threshold of 0 as its last argument, makes both right.
# Flinch: blends by a slerp of its own, motion/interpolation.h.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libirrlicht-dev=1.8.5+ds2-1 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >halfway.cpp <<'CPP'
#include <initializer_list>
#include <irrlicht.h>
#include <cmath>
#include <cstdio>

using namespace irr::core;

void tell(const char* name, float degrees, const quaternion& halfway) {
  float angle;
  vector3df axis;
  halfway.toAngleAxis(angle, axis);
  const vector3df turned = halfway * vector3df(0, 1, 0);
  std::printf("halfway to %.0f degrees%s: toAngleAxis %.1f, a vector %.1f and of length %.3f\n", degrees,
              name, angle * RADTODEG, std::atan2(turned.Z, turned.Y) * RADTODEG, turned.getLength());
}

int main() {
  for (const float degrees : {10.0F, 30.0F, 36.0F, 60.0F}) {
    quaternion end, halfway;
    end.fromAngleAxis(degrees * DEGTORAD, vector3df(1, 0, 0));
    halfway.slerp(quaternion(), end, 0.5F);
    tell("", degrees, halfway);
    tell(", threshold 0", degrees, quaternion().slerp(quaternion(), end, 0.5F, 0));
  }
}
CPP
g++ -std=c++17 -w -I usr/include/irrlicht halfway.cpp -o halfway
./halfway | tee seen
cmp -s - seen <<'TEXT' || {
halfway to 10 degrees: toAngleAxis 7.1, a vector 5.0 and of length 1.000
halfway to 10 degrees, threshold 0: toAngleAxis 5.0, a vector 5.0 and of length 1.000
halfway to 30 degrees: toAngleAxis 21.2, a vector 14.7 and of length 0.999
halfway to 30 degrees, threshold 0: toAngleAxis 15.0, a vector 15.0 and of length 1.000
halfway to 36 degrees: toAngleAxis 25.4, a vector 17.6 and of length 0.999
halfway to 36 degrees, threshold 0: toAngleAxis 18.0, a vector 18.0 and of length 1.000
halfway to 60 degrees: toAngleAxis 30.0, a vector 30.0 and of length 1.000
halfway to 60 degrees, threshold 0: toAngleAxis 30.0, a vector 30.0 and of length 1.000
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
