#!/bin/sh
# SPDX-License-Identifier: MIT
# SciPy 1.10.1 (Debian python3-scipy 1.10.1-2): Nelder-Mead that starts at 0 looks 0.00025 around it, and
# reports success there.
#
# Expected: a method without gradients takes first steps that a rough function shows, and the same search
# from 0 or from 0.5 finds the minimum at 1.
# Seen: the first step of each variable is 5 % of its value, and 0.00025 where it is 0, a number that
# stands in _optimize.py only. What is simulated in steps, or counts hits, is flat there: the search
# from 0 evaluates it 11 times, moves nowhere and returns success. So a pose whose angles start at
# zero, or weights that do, are called optimal. Away from 0 the same search finds the minimum.
# initial_simplex gives the first steps. NLopt and GSL ask for them.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-scipy=1.10.1-2 python3-numpy=1:1.24.2-1+deb12u1 python3-decorator liblbfgsb0 \
  libblas3 liblapack3 libgfortran5 libquadmath0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >search.py <<'PY'
import numpy
from scipy.optimize import minimize


def rough(angles):  # smallest where each is 1, in steps of 0.02
    return numpy.abs(numpy.round(50 * angles) / 50 - 1).sum()


simplex = [[0, 0], [0.05, 0], [0, 0.05]]
for name, start, options in [("from 0", 0, {}), ("from 0.5", 0.5, {}),
                             ("from 0 with steps of 0.05", 0, {"initial_simplex": simplex})]:
    found = minimize(rough, [start, start], method="Nelder-Mead", options=options)
    print(f"{name}: success {found.success}, {'a few' if found.nfev < 20 else 'many'} evaluations,",
          f"ends at {found.x[0]:.1f} {found.x[1]:.1f}")
PY
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack PYTHONPATH=usr/lib/python3/dist-packages \
  /usr/bin/python3 search.py | tee seen
printf '%s\n' 'from 0: success True, a few evaluations, ends at 0.0 0.0' \
  'from 0.5: success True, many evaluations, ends at 1.0 1.0' \
  'from 0 with steps of 0.05: success True, many evaluations, ends at 1.0 1.0' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
