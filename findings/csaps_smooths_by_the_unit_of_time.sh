#!/bin/sh
# SPDX-License-Identifier: MIT
# csaps 1.1.0 (Python; Debian python3-csaps 1.1.0-2): the same smoothing parameter makes a line of a
# movement in seconds, and keeps all of its noise in milliseconds.
#
# Expected: smooth goes from 0, a straight line, to 1, through all points, and 0.9 is near the points,
# whether times are frames, seconds or milliseconds.
# Seen: the parameter weighs squared distances against the integral of a squared second derivative, which
# has the third power of the unit of time in it. Of a swing with noise of 0.1, sampled at 100 per second,
# smooth=0.9 leaves 0.41 (the swing itself is gone) in seconds, 0.05 in frames and 0.0002 in
# milliseconds. With normalizedsmooth=True it is 0.08 in all.
# Flinch: does not use it. Who filters captures by it passes normalizedsmooth=True.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-csaps=1.1.0-2 python3-scipy=1.10.1-2 python3-numpy python3-decorator liblbfgsb0 \
  libblas3 liblapack3 libgfortran5; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >swing.py <<'PY'
import numpy
from csaps import csaps

time = numpy.arange(200) / 100
swing = numpy.sin(2 * numpy.pi * time) + 0.1 * numpy.random.default_rng(1).normal(size=200)
for unit, scale in ("seconds", 1), ("frames", 100), ("milliseconds", 1000):
    left = [numpy.sqrt(numpy.mean((csaps(time * scale, swing, time * scale, smooth=0.9,
                                         normalizedsmooth=normalized) - swing) ** 2))
            for normalized in (False, True)]
    print(f"{unit}: distance from the data {left[0]:.4f}, normalized {left[1]:.4f}")
PY
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack PYTHONPATH=usr/lib/python3/dist-packages \
  /usr/bin/python3 swing.py | tee seen
cmp -s - seen <<'TEXT' || {
seconds: distance from the data 0.4057, normalized 0.0841
frames: distance from the data 0.0482, normalized 0.0841
milliseconds: distance from the data 0.0002, normalized 0.0841
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
