#!/bin/sh
# SPDX-License-Identifier: MIT
# SciPy 1.10.1 (Debian python3-scipy 1.10.1-2): at half the frame rate, a figure that stands at 1 m is at
# 0.75 m in its first frame, or at 0.989 m in all, and one that walks begins at its end.
#
# Expected: signal.decimate, resample_poly and resample bring motion capture from 120 to 60 frames per
# second: a constant stays as it is, and a walk of 3 m begins at 0.
# Seen: decimate's Chebyshev filter of even order has its ripple at a frequency of zero: it makes each
# height smaller by 1.1 %, 11 mm of 1 m. resample_poly, and decimate with ftype="fir", take all before the
# first and after the last frame for zero, so the figure jumps from 0.75 m to 1.07. resample takes the
# clip for periodic, and the walk begins at 0.74 m. resample_poly with padtype="line" keeps the constant and the
# walk; each function says its part of it, and none is the plain choice.
# Flinch: resamples once, at import, by interpolation between frames.
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
cat >half.py <<'PY'
import numpy as np
from scipy import signal

seconds = np.arange(240) / 120
motions = {"stands at 1 m": np.ones(240), "walks at 1.5 m/s": 1.5 * seconds}
ways = {
    "decimate": lambda motion: signal.decimate(motion, 2),
    'decimate, ftype="fir"': lambda motion: signal.decimate(motion, 2, ftype="fir"),
    "resample_poly": lambda motion: signal.resample_poly(motion, 1, 2),
    "resample": lambda motion: signal.resample(motion, 120),
    'resample_poly, padtype="line"': lambda motion: signal.resample_poly(motion, 1, 2, padtype="line"),
}
for way, half in ways.items():
    for name, motion in motions.items():
        error = 1000 * np.abs(half(motion) - motion[::2])
        print(f"{way}: {name}, {error[0]:.0f} mm off at first and {error[60]:.0f} mm in the middle")
PY
PYTHONPATH=$PWD/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack \
  /usr/bin/python3 half.py | tee seen
cmp -s - seen <<'TEXT' || {
decimate: stands at 1 m, 11 mm off at first and 11 mm in the middle
decimate: walks at 1.5 m/s, 0 mm off at first and 17 mm in the middle
decimate, ftype="fir": stands at 1 m, 250 mm off at first and 0 mm in the middle
decimate, ftype="fir": walks at 1.5 m/s, 2 mm off at first and 0 mm in the middle
resample_poly: stands at 1 m, 250 mm off at first and 0 mm in the middle
resample_poly: walks at 1.5 m/s, 2 mm off at first and 0 mm in the middle
resample: stands at 1 m, 0 mm off at first and 0 mm in the middle
resample: walks at 1.5 m/s, 744 mm off at first and 6 mm in the middle
resample_poly, padtype="line": stands at 1 m, 0 mm off at first and 0 mm in the middle
resample_poly, padtype="line": walks at 1.5 m/s, 0 mm off at first and 0 mm in the middle
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
