#!/bin/sh
# SPDX-License-Identifier: MIT
# pracma 2.4.2 (R; Debian r-cran-pracma 2.4.2-1): the second derivative by savgol() is half of it, the third
# a sixth.
#
# Expected: savgol(x, fl, forder, dorder) gives the derivative of the order dorder, per frame. Divided by
# the frame time squared, the second is the acceleration, as by SciPy's savgol_filter(deriv=2).
# Seen: it gives the coefficient of the fitted polynomial, so the derivative divided by the factorial of
# its order. Velocities are right, and a falling body falls with 4.905 m/s2. The help says "derivative
# order in the smoothing", no more.
# Flinch: does not use it. Who does multiplies by factorial(dorder).
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in r-cran-pracma=2.4.2-1 r-base-core=4.2.2.20221110-2 libblas3 liblapack3 libgfortran5 \
  libquadmath0 libtirpc3 python3-scipy=1.10.1-2 python3-numpy python3-decorator liblbfgsb0; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
R_HOME=$PWD/usr/lib/R
R_LIBS=$R_HOME/site-library
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$R_HOME/lib:$triplet:$triplet/blas:$triplet/lapack
EDITOR="vi"
export R_HOME R_LIBS LD_LIBRARY_PATH EDITOR
rm -f "$R_HOME/etc/Renviron"
: >"$R_HOME/etc/Renviron"
cat >fall.R <<'R'
time <- (0:100) / 100
falls <- list("fall" = -9.81 * time^2 / 2, "cube" = time^3)
for (name in names(falls)) for (order in 1:3) {
  derivative <- pracma::savgol(falls[[name]], 11, 3, order)[51] / 0.01^order
  cat(sprintf("pracma, %s: derivative %d at 0.5 s is %.3f\n", name, order, derivative))
}
R
cat >fall.py <<'PY'
import numpy
from scipy.signal import savgol_filter

time = numpy.arange(101) / 100
for name, falls in (("fall", -9.81 * time**2 / 2), ("cube", time**3)):
    for order in 1, 2, 3:
        derivative = savgol_filter(falls, 11, 3, deriv=order, delta=0.01)[50]
        print(f"SciPy, {name}: derivative {order} at 0.5 s is {derivative + 0:.3f}")
PY
{
  "$R_HOME/bin/exec/R" --vanilla --slave -f fall.R
  PYTHONPATH=usr/lib/python3/dist-packages /usr/bin/python3 fall.py
} | sed 's/-0\.000/0.000/' | tee seen
cmp -s - seen <<'TEXT' || {
pracma, fall: derivative 1 at 0.5 s is -4.905
pracma, fall: derivative 2 at 0.5 s is -4.905
pracma, fall: derivative 3 at 0.5 s is 0.000
pracma, cube: derivative 1 at 0.5 s is 0.750
pracma, cube: derivative 2 at 0.5 s is 1.500
pracma, cube: derivative 3 at 0.5 s is 1.000
SciPy, fall: derivative 1 at 0.5 s is -4.905
SciPy, fall: derivative 2 at 0.5 s is -9.810
SciPy, fall: derivative 3 at 0.5 s is 0.000
SciPy, cube: derivative 1 at 0.5 s is 0.750
SciPy, cube: derivative 2 at 0.5 s is 3.000
SciPy, cube: derivative 3 at 0.5 s is 6.000
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
