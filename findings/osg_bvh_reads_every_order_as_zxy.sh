#!/bin/sh
# SPDX-License-Identifier: MIT
# OpenSceneGraph 3.6.5 (Debian openscenegraph 3.6.5+dfsg1-8+b2): its .bvh reader takes the rotation
# channels of every joint for Z, X, Y, whatever the file says.
#
# Expected: CHANNELS names the channels in the order in which their values stand and their rotations
# are applied, so "Xrotation Yrotation Zrotation" with 10 20 30 turns by 10 about X, 20 about Y and
# 30 about Z.
# Seen: the names do not matter. The first value turns about Z, the second about X and the third
# about Y, so the same values give the same quaternions under any order of names. A file of another
# order than ZXY loads without a word, and its joints bend about the wrong axes. three.js and Assimp
# go by the names.
# Flinch: applies each joint's rotation channels in the file's order.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in openscenegraph libopenscenegraph161 libopenthreads21; do
  apt-get -o APT::Sandbox::User=root download -q "$package=3.6.5+dfsg1-8+b2" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu
OSG_LIBRARY_PATH=$LD_LIBRARY_PATH/osgPlugins-3.6.5
export LD_LIBRARY_PATH OSG_LIBRARY_PATH
for order in 'Z X Y' 'X Y Z' 'Z Y X'; do
  # shellcheck disable=SC2086  # one word an axis
  rotations=$(printf '%srotation ' $order)
  cat >turn.bvh <<BVH
HIERARCHY
ROOT hip
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition $rotations
  End Site
  {
    OFFSET 0 1 0
  }
}
MOTION
Frames: 2
Frame Time: 0.1
0 9 0 10 20 30
0 9 0 10 20 30
BVH
  usr/bin/osgconv turn.bvh turn.osgt >/dev/null 2>&1
  echo "$order: $(sed -n '/"quaternion"/,/}/s/^ *0 //p' turn.osgt | sed 's/ $//')"
done | tee seen
# The quaternions, x y z w, that each order stands for.
python3 - <<'PY'
from math import cos, radians, sin

for order in "ZXY", "XYZ", "ZYX":
    x, y, z, w = 0, 0, 0, 1
    for axis, angle in zip(order, (10, 20, 30)):
        s, c = sin(radians(angle) / 2), cos(radians(angle) / 2)
        a, b, d = (s * (axis == name) for name in "XYZ")
        x, y, z, w = (w * a + x * c + y * d - z * b, w * b - x * d + y * c + z * a,
                      w * d + x * b - y * a + z * c, w * c - x * a - y * b - z * d)
    print(f"expected of {' '.join(order)}: {x:.6f} {y:.6f} {z:.6f} {w:.6f}")
PY
printf '%s: 0.144878 0.268536 0.127679 0.943714\n' 'Z X Y' 'X Y Z' 'Z Y X' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
