#!/bin/sh
# SPDX-License-Identifier: MIT
# pyrr 0.10.3 (Debian python3-pyrr 0.10.3-5): a quaternion and the matrix made of it turn a vector in
# opposite ways, and the same Euler angles are another rotation as a matrix than as a quaternion.
#
# Expected: from_z_rotation of a quarter turn brings X to Y, as a Quaternion and as a Matrix44, and a
# matrix that is made of the quaternion does the same to a vector.
# Seen: the quaternion brings X to Y and both matrices bring X to -Y, each by the library's own operator.
# Matrices multiply rows from the left, and translations are laid out for that; rotations are laid out
# for columns. So a figure whose joints are turned by matrices stands mirrored in its angles, and a
# matrix that is sent to OpenGL, as examples do it, is right again. create_from_eulers of a matrix and
# of a quaternion differ in their order too.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-pyrr=0.10.3-5 python3-multipledispatch python3-numpy python3-six libblas3 \
  liblapack3 libgfortran5; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
triplet=$PWD/usr/lib/x86_64-linux-gnu
cat >turn.py <<'PY'
import numpy as np
from pyrr import Matrix33, Matrix44, Quaternion, Vector3, euler

def tell(name, vector):
    print(name + ":", " ".join(f"{round(float(x), 3) + 0:g}" for x in vector))

x = Vector3([1.0, 0.0, 0.0])
turn = Quaternion.from_z_rotation(np.pi / 2)
tell("X by the quaternion", turn * x)
tell("X by the matrix of the quaternion", Matrix44.from_quaternion(turn) * x)
tell("X by Matrix44.from_z_rotation", Matrix44.from_z_rotation(np.pi / 2) * x)
tell("X by Matrix44.from_translation of Y", Matrix44.from_translation([0.0, 1.0, 0.0]) * x)
angles = euler.create(roll=0.5, pitch=0.6, yaw=0.7)
tell("first row of the matrix of Euler angles", Matrix33.from_eulers(angles)[0])
tell("of the matrix of their quaternion", Matrix33.from_quaternion(Quaternion.from_eulers(angles))[0])
PY
PYTHONPATH=$PWD/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack \
  /usr/bin/python3 turn.py | tee seen
cmp -s - seen <<'TEXT' || {
X by the quaternion: 0 1 0
X by the matrix of the quaternion: 0 -1 0
X by Matrix44.from_z_rotation: 0 -1 0
X by Matrix44.from_translation of Y: 1 1 0
first row of the matrix of Euler angles: 0.631 -0.07 0.772
of the matrix of their quaternion: 0.631 -0.532 0.565
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
