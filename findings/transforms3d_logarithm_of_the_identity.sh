#!/bin/sh
# SPDX-License-Identifier: MIT
# transforms3d 0.4 (Debian python3-transforms3d 0.4+ds-2): the logarithm of the identity is the identity
# instead of 0, and a quaternion times its inverse is its length.
#
# Expected: qlog([1, 0, 0, 0]) is 0, as the logarithm of a rotation goes to 0 with its angle; qmult(q, qinverse(q))
# is 1 for every q; and numbers that are written without a point are numbers.
# Seen: the logarithm of a turn by 0.001 rad has a length of 0.0005, that of no turn a length of 1. So a
# mean of rotations by their logarithms, or a filter over them, jumps where a joint stands still. The inverse of
# 2 is 1. Of integers, logarithms are cut to integers: half of the half turn (0, 1, 0, 0) is four zeros, of
# (0., 1., 0., 0.) it is right.
# Flinch: takes rotation vectors by motion/rotation.h, which are 0 at the identity.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-transforms3d=0.4+ds-2 python3-numpy libblas3 liblapack3 libgfortran5; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
triplet=$PWD/usr/lib/x86_64-linux-gnu
cat >logarithm.py <<'PY'
import numpy as np
from transforms3d.quaternions import axangle2quat, qinverse, qlog, qmult, qpow

def tell(name, quaternion):
    print(name + ":", " ".join(f"{round(float(x), 4) + 0:g}" for x in quaternion))

for angle in (0.001, 0.0):
    log = qlog(axangle2quat([1, 0, 0], angle))
    print(f"length of the logarithm of a turn by {angle:g} rad: {np.linalg.norm(log):g}")
two = np.array([2.0, 0, 0, 0])
tell("2 times the inverse of 2", qmult(two, qinverse(two)))
tell("half of (0., 1., 0., 0.)", qpow([0.0, 1.0, 0.0, 0.0], 0.5))
tell("half of (0, 1, 0, 0)", qpow([0, 1, 0, 0], 0.5))
PY
PYTHONPATH=$PWD/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack \
  /usr/bin/python3 logarithm.py | tee seen
cmp -s - seen <<'TEXT' || {
length of the logarithm of a turn by 0.001 rad: 0.0005
length of the logarithm of a turn by 0 rad: 1
2 times the inverse of 2: 2 0 0 0
half of (0., 1., 0., 0.): 0.7071 0.7071 0 0
half of (0, 1, 0, 0): 0 0 0 0
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
