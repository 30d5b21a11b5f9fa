#!/bin/sh
# SPDX-License-Identifier: MIT
# OpenCV 4.6.0 (Debian libopencv-ml-dev 4.6.0+dfsg-12): an SVM's decision value is positive for the class -1
# and negative for the class 1.
#
# Expected: a machine that was trained with the labels -1 and 1 has a decision value whose sign is the
# class, as the form w x + b says.
# Seen: predict() with RAW_OUTPUT gives 2 at the middle of the class -1 and -2 at that of 1: it is the
# distance towards the smaller label. predict() without it names the right class, so a threshold or a
# ranking by the raw value is wrong for each row, and nothing else is. With the labels 1 and -1 put in
# another order of rows it is the same.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libopencv-core-dev=4.6.0+dfsg-12 libopencv-core406=4.6.0+dfsg-12 \
  libopencv-ml-dev=4.6.0+dfsg-12 libopencv-ml406=4.6.0+dfsg-12 libtbb12 libblas3 liblapack3 \
  libgfortran5; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$PWD/usr/lib/x86_64-linux-gnu
cat >sign.cpp <<'CPP'
#include <cstdio>
#include <vector>
#include <opencv2/core.hpp>
#include <opencv2/ml.hpp>

void train(std::vector<float> places, std::vector<int> classes) {
  const auto machine = cv::ml::SVM::create();
  machine->setKernel(cv::ml::SVM::LINEAR);
  machine->train(cv::Mat(places), cv::ml::ROW_SAMPLE, cv::Mat(classes));
  for (float place : {-2.0F, 2.0F}) {
    const cv::Mat row(1, 1, CV_32F, &place);
    std::printf("the first row is of class %d: at %.0f class %.0f, raw %.1f\n", classes[0], place,
                machine->predict(row),
                machine->predict(row, cv::noArray(), cv::ml::StatModel::RAW_OUTPUT));
  }
}

int main() {
  train({-2, -1, 1, 2}, {-1, -1, 1, 1});
  train({2, 1, -1, -2}, {1, 1, -1, -1});
}
CPP
g++ -std=c++17 -w -I usr/include/opencv4 sign.cpp -o sign -L "$library" -l:libopencv_core.so.406 \
  -l:libopencv_ml.so.406 -Wl,--unresolved-symbols=ignore-in-shared-libs
LD_LIBRARY_PATH=$library:$library/blas:$library/lapack ./sign | tee seen
cmp -s - seen <<'TEXT' || {
the first row is of class -1: at -2 class -1, raw 2.0
the first row is of class -1: at 2 class 1, raw -2.0
the first row is of class 1: at -2 class -1, raw 2.0
the first row is of class 1: at 2 class 1, raw -2.0
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
