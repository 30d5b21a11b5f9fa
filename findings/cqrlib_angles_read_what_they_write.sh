#!/bin/sh
# SPDX-License-Identifier: MIT
# CQRlib 1.1.4 (Debian libcqrlib-dev 1.1.4-3): the Euler angles of a rotation depend on what the variables
# that receive them held before, and may be those of another rotation.
#
# Expected: CQRQuaternion2Angles() sets its three outputs to angles of the given rotation, and
# CQRAngles2Quaternion() makes that rotation of them again.
# Seen: it reads the outputs first, and takes of two triples of angles the one that is nearer to them. The
# second triple adds a half turn to all three angles, and is another rotation: to mean the same the
# one about Y would have to be a half turn less it. So with variables that hold 180 degrees,
# rotations of 30 and 60 degrees about Y come back 60 and 120 degrees away; with variables that hold the
# frame before, a steady turn about Y goes wrong where it passes 90 degrees; with variables that
# were not set, it is chance.
# Flinch: turns by Eigen. It makes Euler angles only to write .bvh, and its tests read them back.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libcqrlib-dev=1.1.4-3 libcqrlib2=1.1.4-3 >/dev/null
for package in libcqrlib*.deb; do dpkg-deb -x "$package" .; done
cat >angles.c <<'C'
#include <cqrlib.h>
#include <math.h>
#include <stdio.h>

static const double kDegree = 0.017453292519943295;

/* How far the rotation by `y` degrees about Y, and little about X and Z, is from that of its angles. */
static double degrees_away(double y, double angles[3]) {
  CQRQuaternion given, back;
  CQRAngles2Quaternion(&given, 0.3, y * kDegree, 0.5);
  CQRQuaternion2Angles(&angles[0], &angles[1], &angles[2], &given);
  CQRAngles2Quaternion(&back, angles[0], angles[1], angles[2]);
  const double dot = fabs(given.w * back.w + given.x * back.x + given.y * back.y + given.z * back.z);
  return 2 * acos(dot < 1 ? dot : 1) / kDegree;
}

int main(void) {
  for (int held = 0; held <= 180; held += 180) {
    printf("variables hold %d degrees:", held);
    for (int y = 30; y <= 60; y += 30) {
      double angles[3] = {held * kDegree, held * kDegree, held * kDegree};
      printf(" %d about Y is %.0f away;", y, degrees_away(y, angles));
    }
    printf("\n");
  }
  printf("from frame to frame:");
  double angles[3] = {0, 0, 0};
  for (int y = 0; y <= 120; y += 10) {
    const double away = degrees_away(y, angles);
    if (y >= 80) printf(" %d about Y is %.0f away;", y, away);
  }
  printf("\n");
  return 0;
}
C
cc -Iusr/include angles.c -o angles usr/lib/*/libCQRlib.so.2 -lm
LD_LIBRARY_PATH=$(echo usr/lib/*) ./angles | tee seen
printf '%s\n' 'variables hold 0 degrees: 30 about Y is 0 away; 60 about Y is 0 away;' \
  'variables hold 180 degrees: 30 about Y is 60 away; 60 about Y is 120 away;' \
  'from frame to frame: 80 about Y is 0 away; 90 about Y is 0 away; 100 about Y is 160 away; 110 about Y is 140 away; 120 about Y is 120 away;' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
