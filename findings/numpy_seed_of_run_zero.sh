#!/bin/sh
# SPDX-License-Identifier: MIT
# NumPy 1.24.2 (Debian python3-numpy 1:1.24.2-1+deb12u1): run 0 of a seed draws the same numbers as
# the seed alone.
#
# Expected: a list of integers seeds a generator by all of them, so default_rng([7, run]) draws
# numbers of its own for each run, and other ones than default_rng(7), with which the program shuffled
# or initialised before.
# Seen: a seed is filled with zeros to four words of 32 bits. So 7, [7], [7, 0] and [7, 0, 0] are one
# seed, and run 0 repeats what was drawn with 7. Children of SeedSequence(7).spawn are apart since
# NumPy 1.19 (pull request 16551), which left lists as they were for the sake of old streams. The
# manual's own example, [worker, 7], has its zero in front and draws other numbers.
# Flinch: does not draw by NumPy. Who seeds runs there counts them from 1, or spawns them.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-numpy=1:1.24.2-1+deb12u1 libblas3 liblapack3 libgfortran5 libquadmath0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >runs.py <<'PY'
from numpy.random import SeedSequence, default_rng

alone = default_rng(7).integers(0, 1000, 5).tolist()
child = SeedSequence(7).spawn(1)[0]
for seed in [7, 0], [7, 0, 0], [7, 1], [0, 7], child:
    drawn = default_rng(seed).integers(0, 1000, 5).tolist()
    name = "first child" if seed is child else seed
    print(f"{name}: {'the numbers of 7' if drawn == alone else 'other numbers'}")
PY
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack PYTHONPATH=usr/lib/python3/dist-packages \
  /usr/bin/python3 runs.py | tee seen
printf '%s\n' '[7, 0]: the numbers of 7' '[7, 0, 0]: the numbers of 7' '[7, 1]: other numbers' \
  '[0, 7]: other numbers' 'first child: other numbers' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
