#!/bin/sh
# SPDX-License-Identifier: MIT
# matgeom 1.2.3 for GNU Octave (Debian octave-matgeom 1.2.3-3): points that are registered to a target run away
# from it, parallel lines are at no distance, and a rotation to the opposite direction mirrors.
#
# Expected: registerPoints3dAffine(points, target) brings points that are turned by 3 degrees onto their target;
# lines that are parallel are as far from each other as their points; a rotation has the determinant 1.
# Seen: it asks fitAffineTransform3d, which takes the reference first, for the transform from the points
# to their nearest targets with the points first, gets that from the targets to the points, and applies
# it: each iteration doubles the error, and the 10 that are the default make 779 m of 7 cm. Two axes that
# are 1 m apart and parallel are at distance 0 by distanceLines3d, those that differ by a millionth of a
# radian at 1. createRotationVector3d([1 0 0], [-1 0 0]) is a reflection in the origin, which
# turns a left hand into a right one.
# Flinch: turns by Eigen, and makes a half turn of opposite directions, with a test.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -s install --no-install-recommends octave >plan
# shellcheck disable=SC2046
apt-get -o APT::Sandbox::User=root download -q octave-matgeom=1.2.3-3 octave \
  $(awk '/^Inst/ && $2 != "octave" { print $2 }' plan) >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
OCTAVE_HOME=$PWD/usr
LD_LIBRARY_PATH=$(find usr/lib -name '*.so*' -printf "$PWD/%h\n" | sort -u | tr '\n' ':')
export OCTAVE_HOME OCTAVE_EXEC_HOME="$OCTAVE_HOME" LD_LIBRARY_PATH HOME="$folder"
cat >markers.m <<'M'
warning("off", "all");
for part = {"geom2d", "geom3d", "utils"}
  addpath([getenv("OCTAVE_HOME") "/share/octave/packages/matgeom-1.2.3/" part{1}]);
end
[x, y, z] = ndgrid(0:0.5:1, 0:0.5:1, 0:0.5:1);
target = [x(:) y(:) z(:)];
points = transformPoint3d(target, createRotationOz(pi / 60));
error_of = @(moved) max(vectorNorm3d(moved - target));
printf("at first: %.3f m from the target\n", error_of(points));
for iterations = [1 2 3 10]
  [~, moved] = registerPoints3dAffine(points, target, iterations);
  printf("after %d: %.3g m\n", iterations, error_of(moved));
end
for slope = [0 1e-6]
  d = distanceLines3d([0 0 0 1 0 0], [0 1 0 1 0 slope]);
  printf("lines 1 m apart, slope %g: %.2f m apart\n", slope, d);
end
printf("determinant of a turn to the opposite: %d\n", det(createRotationVector3d([1 0 0], [-1 0 0])));
M
usr/bin/octave-cli --norc --quiet markers.m 2>/dev/null | tee seen
cmp -s - seen <<'TEXT' || {
at first: 0.074 m from the target
after 1: 0.148 m
after 2: 0.296 m
after 3: 0.588 m
after 10: 779 m
lines 1 m apart, slope 0: 0.00 m apart
lines 1 m apart, slope 1e-06: 1.00 m apart
determinant of a turn to the opposite: -1
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
