#!/bin/sh
# SPDX-License-Identifier: MIT
# NumPy 1.24.2 (Debian python3-numpy 1:1.24.2-1+deb12u1): the mean of the rows of a float32 table
# drifts by centimetres, and the mean of one column of it does not.
#
# Expected: NumPy sums in pairs, so that the error grows with the logarithm of the count: ten
# million floats have a mean good to a micrometre. x.mean(axis=0)[1] is x[:, 1].mean().
# Seen: the pairs are only along the axis that lies together in memory. Over the rows of a table in
# C's order, frames by coordinates, one float per column adds up all frames. Of ten million heights
# of 1.7 m, the mean is off by 96 mm and the standard deviation is 0.098 m instead of 0.020 m. x[:,
# 1].mean(), or a copy in Fortran's order, is off by 1 um. The notes on numpy.sum say so; those on
# mean and std say only that float32 can be inaccurate.
# Flinch: exports .csv, whose numbers NumPy reads as doubles.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-numpy=1:1.24.2-1+deb12u1 libblas3 liblapack3 libgfortran5 libquadmath0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >heights.py <<'PY'
import numpy

draw = numpy.random.default_rng(1)
markers = draw.normal([0.5, 1.7, -0.9], 0.02, size=(10_000_000, 3)).astype(numpy.float32)
height = markers[:, 1]
exact = height.mean(dtype=float)
print(f"mean(axis=0)[1]: off by {abs(markers.mean(axis=0)[1] - exact) * 1000:.0f} mm,",
      f"std(axis=0)[1]: {markers.std(axis=0)[1]:.3f} m")
print(f"[:, 1].mean(): off by {abs(height.mean() - exact) * 1000:.0f} mm,",
      f"[:, 1].std(): {height.std():.3f} m")
PY
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack PYTHONPATH=usr/lib/python3/dist-packages \
  /usr/bin/python3 heights.py | tee seen
printf '%s\n' 'mean(axis=0)[1]: off by 96 mm, std(axis=0)[1]: 0.098 m' \
  '[:, 1].mean(): off by 0 mm, [:, 1].std(): 0.020 m' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
