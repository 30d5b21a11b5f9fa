#!/bin/sh
# SPDX-License-Identifier: MIT
# liblinear 2.3.0 (Debian liblinear-tools 2.3.0+dfsg-5): the line between two classes goes through the
# origin.
#
# Expected: liblinear-train separates rows of 2 m from rows of 4 m, as svm-train's linear kernel (Debian
# libsvm-tools 3.24+ds-6) does with the same file.
# Seen: it gets 50 of 100 right, all of one class: it has no constant unless one asks for it by -B. With
# -B 1 the constant is held small like any weight, so that 100 and 102 m are not told apart by most
# solvers, and with -B 100 they are. Features that are all positive, as times, distances and speeds are,
# need it most. Nothing is printed of it but an accuracy that looks as if nothing could be learned.
# Flinch: its machines are of libsvm's form, whose constant is free.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in liblinear-tools=2.3.0+dfsg-5 liblinear4=2.3.0+dfsg-5 libsvm-tools=3.24+ds-6 \
  libsvm3=3.24+ds-6 libblas3 libgfortran5; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
triplet=$PWD/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH="$triplet:$triplet/blas"
rows() { # FROM: 100 rows at about FROM and FROM + 2, of the classes 1 and 2.
  seq 0 99 | awk -v from="$1" '{ print 1 + $1 % 2, "1:" from + 2 * ($1 % 2) + (7 * $1 % 11 - 5) / 20 }'
}
for from in 2 100; do
  rows "$from" >rows
  for solver in 0 1 2 5; do
    for bias in -1 1 100; do
      usr/bin/liblinear-train -q -s "$solver" -B "$bias" rows model
      echo "$from and $((from + 2)) m, -s $solver -B $bias:" \
        "$(usr/bin/liblinear-predict rows model answers | sed 's/Accuracy = \([^ ]*\).*/\1/')"
    done
  done
  usr/bin/svm-train -q -t 0 rows model
  echo "$from and $((from + 2)) m, svm-train: $(usr/bin/svm-predict rows model answers |
    sed 's/Accuracy = \([^ ]*\).*/\1/')"
done | tee seen
cmp -s - seen <<'TEXT' || {
2 and 4 m, -s 0 -B -1: 50%
2 and 4 m, -s 0 -B 1: 100%
2 and 4 m, -s 0 -B 100: 100%
2 and 4 m, -s 1 -B -1: 50%
2 and 4 m, -s 1 -B 1: 100%
2 and 4 m, -s 1 -B 100: 100%
2 and 4 m, -s 2 -B -1: 50%
2 and 4 m, -s 2 -B 1: 100%
2 and 4 m, -s 2 -B 100: 100%
2 and 4 m, -s 5 -B -1: 50%
2 and 4 m, -s 5 -B 1: 100%
2 and 4 m, -s 5 -B 100: 100%
2 and 4 m, svm-train: 100%
100 and 102 m, -s 0 -B -1: 50%
100 and 102 m, -s 0 -B 1: 50%
100 and 102 m, -s 0 -B 100: 100%
100 and 102 m, -s 1 -B -1: 50%
100 and 102 m, -s 1 -B 1: 50%
100 and 102 m, -s 1 -B 100: 100%
100 and 102 m, -s 2 -B -1: 50%
100 and 102 m, -s 2 -B 1: 100%
100 and 102 m, -s 2 -B 100: 100%
100 and 102 m, -s 5 -B -1: 50%
100 and 102 m, -s 5 -B 1: 50%
100 and 102 m, -s 5 -B 100: 100%
100 and 102 m, svm-train: 100%
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
