#!/bin/sh
# SPDX-License-Identifier: MIT
# OGRE 1.12.10 (Debian libogre-1.12-dev 1.12.10+dfsg2-3+b1): a quaternion's yaw, pitch and roll do not
# make that quaternion again, and its slerp takes the long way round.
#
# Expected: getYaw, getPitch and getRoll are the angles of FromEulerAnglesYXZ, so that the three of a
# head's rotation bring the head back; and Slerp from no turn to one of 30 degrees passes 7.5 degrees at
# a quarter, whichever sign the quaternion has.
# Seen: of yaw 0.5, pitch 0.6 and roll 0.7 rad, yaw comes back as it was, pitch as 0.83 and roll as
# 0.56, and what they make is turned by 0.3 rad from the head. Each is an angle of a projection of its
# own; with the argument false two are others, and no set is one of Euler angles. Only
# Matrix3::ToEulerAnglesYXZ gives the three back. Slerp of the same rotation with the other sign is at
# 82.5 degrees at a quarter: its argument shortestPath is false unless told, as it is of nlerp.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libogre-1.12-dev=1.12.10+dfsg2-3+b1 libogre1.12.10=1.12.10+dfsg2-3+b1 libzzip-0-13 \
  libfreeimage3; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >head.cpp <<'CPP'
#include <OGRE/OgreMatrix3.h>
#include <OGRE/OgreQuaternion.h>
#include <OGRE/OgreVector.h>
#include <cstdio>

using namespace Ogre;

Quaternion made_of(Radian yaw, Radian pitch, Radian roll) {
  Matrix3 matrix;
  matrix.FromEulerAnglesYXZ(yaw, pitch, roll);
  return Quaternion(matrix);
}

void tell(const char* name, const Quaternion& head, Radian yaw, Radian pitch, Radian roll) {
  const float cosine = std::min(1.0F, std::abs(head.Dot(made_of(yaw, pitch, roll))));
  std::printf("%s: %.2f %.2f %.2f, off by %.1f rad\n", name, yaw.valueRadians(),
              pitch.valueRadians(), roll.valueRadians(), 2 * std::acos(cosine));
}

int main() {
  const Quaternion head = made_of(Radian(0.5F), Radian(0.6F), Radian(0.7F));
  tell("getYaw, getPitch, getRoll", head, head.getYaw(), head.getPitch(), head.getRoll());
  tell("with false", head, head.getYaw(false), head.getPitch(false), head.getRoll(false));
  Matrix3 matrix;
  head.ToRotationMatrix(matrix);
  Radian yaw, pitch, roll;
  matrix.ToEulerAnglesYXZ(yaw, pitch, roll);
  tell("ToEulerAnglesYXZ", head, yaw, pitch, roll);
  const Quaternion turn(Degree(30), Vector3::UNIT_X);
  for (const Quaternion& end : {turn, -turn}) {
    const Quaternion quarter = Quaternion::Slerp(0.25F, Quaternion(), end);
    std::printf("slerp: a quarter is %.1f degrees\n",
                114.592F * std::acos(std::min(1.0F, std::abs(quarter.w))));
  }
}
CPP
g++ -std=c++17 -w -I usr/include -I usr/include/OGRE head.cpp -o head -L "$library" -lOgreMain \
  -Wl,--unresolved-symbols=ignore-in-shared-libs
LD_LIBRARY_PATH=$library ./head | tee seen
cmp -s - seen <<'TEXT' || {
getYaw, getPitch, getRoll: 0.50 0.83 0.56, off by 0.3 rad
with false: 0.05 0.76 0.56, off by 0.4 rad
ToEulerAnglesYXZ: 0.50 0.60 0.70, off by 0.0 rad
slerp: a quarter is 7.5 degrees
slerp: a quarter is 82.5 degrees
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
