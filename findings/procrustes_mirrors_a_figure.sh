#!/bin/sh
# SPDX-License-Identifier: MIT
# SciPy 1.10.1 (Debian python3-scipy 1.10.1-2), vegan 2.6-4 and pracma 2.4.2 (R; Debian r-cran-vegan
# 2.6-4+dfsg-1, r-cran-pracma 2.4.2-1): a figure fits on its mirror image without an error.
#
# Expected: what superimposes one set of markers on another turns and moves it, and scales it if asked. A
# right hand does not fit on a left one.
# Seen: scipy.spatial.procrustes, scipy.linalg.orthogonal_procrustes and procrustes() of both R packages
# also mirror: the distance is 0, and the determinant of the "rotation" is -1. None of them has a switch
# against it. A capture with left and right exchanged, or from a tool with the other handedness, passes
# such a comparison. Rotation.align_vectors of SciPy and kabsch() of pracma turn only, and tell them apart.
# Flinch: has no such fit; its oracles compare joints where they are.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in r-cran-pracma=2.4.2-1 r-cran-vegan=2.6-4+dfsg-1 r-cran-permute r-cran-lattice r-cran-mass \
  r-cran-cluster r-cran-mgcv r-cran-nlme r-cran-matrix r-base-core=4.2.2.20221110-2 libblas3 \
  liblapack3 libgfortran5 libquadmath0 libtirpc3 python3-scipy=1.10.1-2 python3-numpy python3-decorator liblbfgsb0; do
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
cat >mirror.R <<'R'
hand <- rbind(c(0, 0, 0), c(1, 0, 0), c(0, 2, 0), c(0, 0, 3), c(1, 1, 1))
mirrored <- hand %*% diag(c(-1, 1, 1))
told <- function(name, error, rotation)
  cat(sprintf("%s: distance %.2f, determinant %.0f\n", name, abs(error), det(rotation)))
suppressPackageStartupMessages(library(vegan))
fit <- vegan::procrustes(hand, mirrored)
told("vegan, procrustes", fit$ss, fit$rotation)
fit <- pracma::procrustes(hand, mirrored)
told("pracma, procrustes", fit$d, fit$Q)
fit <- pracma::kabsch(t(mirrored), t(hand))
told("pracma, kabsch", fit$d, fit$U)
R
cat >mirror.py <<'PY'
import numpy
import scipy.linalg
import scipy.spatial
from scipy.spatial.transform import Rotation

hand = numpy.array([[0.0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3], [1, 1, 1]])
hand -= hand.mean(axis=0)
mirrored = hand * [-1, 1, 1]
print(f"SciPy, spatial.procrustes: distance {scipy.spatial.procrustes(hand, mirrored)[2]:.2f}")
rotation, _ = scipy.linalg.orthogonal_procrustes(mirrored, hand)
print(f"SciPy, orthogonal_procrustes: distance {numpy.linalg.norm(mirrored @ rotation - hand):.2f}, "
      f"determinant {numpy.linalg.det(rotation):.0f}")
rotation, distance = Rotation.align_vectors(hand, mirrored)
print(f"SciPy, align_vectors: distance {distance:.2f}, determinant "
      f"{numpy.linalg.det(rotation.as_matrix()):.0f}")
PY
{
  "$R_HOME/bin/exec/R" --vanilla --slave -f mirror.R
  PYTHONPATH=usr/lib/python3/dist-packages /usr/bin/python3 mirror.py
} | tee seen
cmp -s - seen <<'TEXT' || {
vegan, procrustes: distance 0.00, determinant -1
pracma, procrustes: distance 0.00, determinant -1
pracma, kabsch: distance 0.93, determinant 1
SciPy, spatial.procrustes: distance 0.00
SciPy, orthogonal_procrustes: distance 0.00, determinant -1
SciPy, align_vectors: distance 2.07, determinant 1
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
