#!/bin/sh
# SPDX-License-Identifier: MIT
# OpenCV 4.6.0 (Debian libopencv-core-dev 4.6.0+dfsg-12): slerp between two quaternions of the same
# rotation is NaN where their signs differ, and OpenCV's own functions give both signs.
#
# Expected: q and -q are one rotation, so slerp, which takes the short way unless told not to, stays
# there, as it does for q and q.
# Seen: Quat::slerp changes the sign and then divides zero by the sine of zero. The signs come by
# themselves: createFromRotMat() of the matrix of a quaternion with w > 0 has w < 0. So a joint that
# rests between one frame from an angle and one from a matrix is at NaN, and toRotVec() of the latter is
# 5.78 rad the other way round. nlerp is right.
# Flinch: turns by Eigen, and blends by a slerp of its own, motion/interpolation.h.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libopencv-core-dev=4.6.0+dfsg-12 libopencv-core406=4.6.0+dfsg-12 libtbb12 libblas3 \
  liblapack3 libgfortran5; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >rest.cpp <<'CPP'
#include <cstdio>
#include <opencv2/core.hpp>
#include <opencv2/core/quaternion.hpp>

void tell(const char* name, const cv::Quatd& q) {
  // A NaN has no sign that means anything.
  if (q.w != q.w) return void(std::printf("%s: NaN\n", name));
  std::printf("%s: %.3f %.3f %.3f %.3f\n", name, q.w, q.x, q.y, q.z);
}

int main() {
  const cv::Quatd turn = cv::Quatd::createFromAngleAxis(0.5, cv::Vec3d(1, 0, 0));
  const cv::Quatd same = cv::Quatd::createFromRotMat(turn.toRotMat3x3());
  tell("from the angle", turn);
  tell("from the matrix of it", same);
  tell("slerp of the first and itself", cv::Quatd::slerp(turn, turn, 0.5));
  tell("slerp of both", cv::Quatd::slerp(turn, same, 0.5));
  tell("nlerp of both", cv::Quatd::nlerp(turn, same, 0.5));
  std::printf("rotation vectors: %.3f and %.3f along X\n", turn.toRotVec()[0], same.toRotVec()[0]);
}
CPP
g++ -std=c++17 -w -I usr/include/opencv4 rest.cpp -o rest -L "$library" -l:libopencv_core.so.406 \
  -Wl,--unresolved-symbols=ignore-in-shared-libs
LD_LIBRARY_PATH=$library:$library/blas:$library/lapack ./rest | tee seen
cmp -s - seen <<'TEXT' || {
from the angle: 0.969 0.247 0.000 0.000
from the matrix of it: -0.969 -0.247 0.000 0.000
slerp of the first and itself: 0.969 0.247 0.000 0.000
slerp of both: NaN
nlerp of both: -0.969 -0.247 0.000 0.000
rotation vectors: 0.500 and -5.783 along X
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
