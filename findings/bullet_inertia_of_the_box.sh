#!/bin/sh
# SPDX-License-Identifier: MIT
# Bullet 3.24 (Debian libbullet-dev 3.24+dfsg-2): capsules, cones and convex hulls have the moments of
# inertia of the box around them.
#
# Expected: calculateLocalInertia is exact for shapes that have a formula, as it is for spheres, boxes
# and cylinders, and near for a convex hull.
# Seen: a capsule of the size of a forearm (0.25 m without its caps, radius 0.04 m) has 1.38 times its
# moment about its length. One of length 0 is a sphere and has 5/3 of a sphere's. A cone has 3.4 times
# its own about its axis. A hull of 1000 points on a sphere has 2.6 times a sphere's, as the collision
# margin widens the box too. So ragdolls of capsules twist more slowly than their masses say.
# Flinch: computes its figure's moments from its own solids.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libbullet-dev libbullet3.24; do
  apt-get -o APT::Sandbox::User=root download -q "$package=3.24+dfsg-2" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'libBulletCollision.so' | head -n 1)")
cat >inertia.cpp <<'CPP'
#include <btBulletCollisionCommon.h>
#include <cmath>
#include <cstdio>

/// Bullet's moment about the shape's Y axis, for 1 kg, over the exact one.
void compare(const char* what, const btCollisionShape& shape, double exact) {
  btVector3 inertia;
  shape.calculateLocalInertia(1, inertia);
  std::printf("%s: %.2f\n", what, static_cast<double>(inertia.y()) / exact);
}

/// A capsule's moment about its length, for 1 kg: a cylinder's and a ball's.
double about_length(double radius, double length) {
  const double cylinder = length / (length + 4.0 / 3 * radius);
  return radius * radius * (cylinder / 2 + (1 - cylinder) * 2 / 5);
}

int main() {
  compare("cylinder", btCylinderShape({0.5F, 0.5F, 0.5F}), 0.125);
  compare("capsule of a forearm", btCapsuleShape(0.04F, 0.25F), about_length(0.04, 0.25));
  compare("capsule of length 0", btCapsuleShape(0.5F, 0), 0.1);
  compare("cone", btConeShape(0.5F, 1), 0.075);
  btConvexHullShape hull;
  for (int i = 0; i < 1000; ++i) {
    const double height = 1 - (2 * i + 1) / 1000.0;
    const double around = 2.39996 * i;  // the golden angle
    const double radius = std::sqrt(1 - height * height);
    hull.addPoint(btVector3(static_cast<btScalar>(radius * std::cos(around)),
                            static_cast<btScalar>(height),
                            static_cast<btScalar>(radius * std::sin(around))) / 2);
  }
  compare("hull of a sphere", hull, 0.1);
}
CPP
g++ -O1 -I usr/include/bullet inertia.cpp -o inertia -L "$library" -lBulletCollision -lLinearMath
LD_LIBRARY_PATH=$library ./inertia | tee seen
printf '%s\n' 'cylinder: 1.00' 'capsule of a forearm: 1.38' 'capsule of length 0: 1.67' 'cone: 3.42' \
  'hull of a sphere: 2.56' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
