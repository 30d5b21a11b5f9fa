#!/bin/sh
# SPDX-License-Identifier: MIT
# SymPy 1.11.1 (Debian python3-sympy 1.11.1-1): the quaternion of a matrix that turns by 180 degrees is 0.
#
# Expected: Quaternion.from_rotation_matrix() of a rotation gives a quaternion of length 1 that makes the
# same matrix, for a half turn too.
# Seen: for each half turn, about whatever axis, it is 0 + 0*i + 0*j + 0*k, without an error: each of the
# three components takes its sign from a difference of the matrix that is 0 there. A quaternion so made
# turns every point to the origin. A hundredth of a degree less and it is right.
# Flinch: turns by Eigen.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-sympy=1.11.1-1 python3-mpmath; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >half_turns.py <<'PY'
from sympy import Rational, pi
from sympy.algebras.quaternion import Quaternion

for axis in ((1, 0, 0), (0, 0, 1), (1, 1, 0), (1, 2, 2)):
    for angle in (pi, pi * Rational(17999, 18000)):
        turn = Quaternion.from_axis_angle(axis, angle)
        again = Quaternion.from_rotation_matrix(turn.to_rotation_matrix())
        degrees = float(angle / pi * 180)
        print(f"{degrees:.2f} degrees about {axis}: length {float(turn.norm()):.3f}, by its matrix "
              f"{float(again.norm()):.3f}")
PY
PYTHONPATH=$PWD/usr/lib/python3/dist-packages /usr/bin/python3 half_turns.py | tee seen
cmp -s - seen <<'TEXT' || {
180.00 degrees about (1, 0, 0): length 1.000, by its matrix 0.000
179.99 degrees about (1, 0, 0): length 1.000, by its matrix 1.000
180.00 degrees about (0, 0, 1): length 1.000, by its matrix 0.000
179.99 degrees about (0, 0, 1): length 1.000, by its matrix 1.000
180.00 degrees about (1, 1, 0): length 1.000, by its matrix 0.000
179.99 degrees about (1, 1, 0): length 1.000, by its matrix 1.000
180.00 degrees about (1, 2, 2): length 1.000, by its matrix 0.000
179.99 degrees about (1, 2, 2): length 1.000, by its matrix 1.000
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
