#!/bin/sh
# SPDX-License-Identifier: MIT
# SciPy 1.10.1 (Debian python3-scipy 1.10.1-2): the rotation of a matrix with a scale is another one, and
# that of a matrix that mirrors is a half turn, without an error.
#
# Expected: Rotation.from_matrix is said to orthogonalize a matrix that is not one of a rotation. A
# rotation by 0.5 rad that is scaled in all directions by 2 is then that rotation, which is the nearest
# one, and a matrix that mirrors is refused, as no rotation is like it.
# Seen: scaled by 2 it is 0.57 rad, and scaled by 0.01, as a figure in centimetres has it at its root, 0.02
# rad; of 2.5 rad it makes 3.12. The formula takes the numbers as those of a rotation. What mirrors,
# such as a limb that was copied to the other side, is turned by pi. Divide the columns by their lengths
# and look at the determinant first.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-scipy=1.10.1-2 python3-numpy python3-decorator libblas3 liblapack3 libgfortran5 \
  liblbfgsb0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
triplet=$PWD/usr/lib/x86_64-linux-gnu
cat >scaled.py <<'PY'
import numpy as np
from scipy.spatial.transform import Rotation

for angle in (0.5, 2.5):
    matrix = Rotation.from_euler("x", angle).as_matrix()
    for scale in (1, 2, 0.01):
        seen = Rotation.from_matrix(scale * matrix).magnitude()
        print(f"{angle} rad scaled by {scale}: {seen:.2f} rad")
    seen = Rotation.from_matrix(matrix @ np.diag([-1, 1, 1])).magnitude()
    print(f"{angle} rad and mirrored: {seen:.2f} rad")
PY
PYTHONPATH=$PWD/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack \
  /usr/bin/python3 scaled.py | tee seen
cmp -s - seen <<'TEXT' || {
0.5 rad scaled by 1: 0.50 rad
0.5 rad scaled by 2: 0.57 rad
0.5 rad scaled by 0.01: 0.02 rad
0.5 rad and mirrored: 3.14 rad
2.5 rad scaled by 1: 2.50 rad
2.5 rad scaled by 2: 2.41 rad
2.5 rad scaled by 0.01: 3.12 rad
2.5 rad and mirrored: 3.14 rad
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
