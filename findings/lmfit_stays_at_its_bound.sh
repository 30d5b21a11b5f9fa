#!/bin/sh
# SPDX-License-Identifier: MIT
# lmfit 1.1.0 (Debian python3-lmfit 1.1.0-1): a parameter that starts at its bound stays there, and the fit
# succeeds.
#
# Expected: a bound is where a parameter must not go beyond. A damping that is at least 0 and starts at 0
# goes to 0.8, which fits the data exactly, as it does without the bound, and as SciPy 1.10.1's least_squares
# finds it.
# Seen: it ends at 0, success is True, and the rate beside it is off by 1 %. A value with a lower bound is
# a root of a square inside, whose slope at the bound is 0, so that no step ever leaves it. From 1e-6 the
# fit is right. All that tells is that the errors are missing, "Could not estimate error-bars", in the
# message and in the report.
# Flinch: does not use it. Who fits a model of a joint by it starts inside the bounds.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in python3-lmfit=1.1.0-1 python3-asteval python3-uncertainties python3-future \
  python3-scipy=1.10.1-2 python3-numpy python3-decorator libblas3 liblapack3 libgfortran5; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
triplet=$PWD/usr/lib/x86_64-linux-gnu
cat >swing.py <<'PY'
import numpy as np
from lmfit import Model
from scipy.optimize import least_squares

time = np.linspace(0, 2, 121)

def swing(time, damping, rate):
    return np.exp(-damping * time) * np.cos(rate * time)

seen = swing(time, 0.8, 6)
for name, start, bound in [("0", 0, 0), ("0.000001", 1e-6, 0), ("0, no bound", 0, -np.inf)]:
    model = Model(swing)
    parameters = model.make_params(damping=start, rate=5.5)
    parameters["damping"].min = bound
    fit = model.fit(seen, parameters, time=time)
    print(f"from {name}: damping {fit.best_values['damping']:.3f}, rate {fit.best_values['rate']:.3f}, "
          f"success {fit.success}")
other = least_squares(lambda x: swing(time, *x) - seen, [0, 5.5], bounds=([0, 0], np.inf))
print(f"least_squares from 0: damping {other.x[0]:.3f}, rate {other.x[1]:.3f}")
PY
PYTHONPATH=$PWD/usr/lib/python3/dist-packages LD_LIBRARY_PATH=$triplet:$triplet/blas:$triplet/lapack \
  /usr/bin/python3 swing.py | tee seen
cmp -s - seen <<'TEXT' || {
from 0: damping 0.000, rate 5.945, success True
from 0.000001: damping 0.800, rate 6.000, success True
from 0, no bound: damping 0.800, rate 6.000, success True
least_squares from 0: damping 0.800, rate 6.000
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
