#!/bin/sh
# SPDX-License-Identifier: MIT
# pandas 1.5.3 (Debian python3-pandas 1.5.3+dfsg-2) and zoo 1.8-11 (R; Debian r-cran-zoo 1.8-11-1): with the
# greatest gap given, one fills the first frames of a longer gap, the other none; one invents frames after
# the last one, and does not look at their times.
#
# Expected: a marker is interpolated over gaps of up to 5 frames, and stays away in longer ones, and before
# its first and after its last frame.
# Seen: zoo's na.approx(maxgap = 5) does that. pandas' interpolate(limit=5) fills the first 5 frames of a
# gap of 8, on the line to its far end, and puts up to 5 copies of the last value after it. And without
# method="index" frames count as evenly spaced whatever times the index has: between 0 s and 1 s, a
# frame at 0.9 s gets the half; zoo takes the times. limit_area="inside" keeps pandas from what is after
# the end; nothing keeps it from beginning a gap that it does not close.
# Flinch: imports rotations of joints, not markers, and fills no gaps.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in r-cran-zoo=1.8-11-1 r-cran-lattice r-base-core=4.2.2.20221110-2 libblas3 liblapack3 \
  libgfortran5 libquadmath0 libtirpc3 python3-pandas=1.5.3+dfsg-2 python3-pandas-lib=1.5.3+dfsg-2 \
  python3-numpy python3-dateutil python3-tz python3-six; do
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
cat >gaps.R <<'R'
suppressPackageStartupMessages(library(zoo))
marker <- c(0, NA, 2, rep(NA, 8), 11, rep(NA, 3))
told <- function(name, filled)
  cat(name, ifelse(is.na(filled), "-", sprintf("%.1f", filled)), "\n")
told("zoo, maxgap = 5:", na.approx(marker, maxgap = 5, na.rm = FALSE))
told("zoo, at 0, 0.9 and 1 s:", coredata(na.approx(zoo(c(0, NA, 10), c(0, 0.9, 1)))))
R
cat >gaps.py <<'PY'
import pandas
nan = float("nan")


def told(name, filled):
    print(name, *("-" if x != x else f"{x:.1f}" for x in filled), "")


marker = pandas.Series([0, nan, 2] + [nan] * 8 + [11] + [nan] * 3)
told("pandas, limit=5:", marker.interpolate(limit=5))
told("pandas, at 0, 0.9 and 1 s:", pandas.Series([0, nan, 10], index=[0, 0.9, 1]).interpolate())
PY
{
  "$R_HOME/bin/exec/R" --vanilla --slave -f gaps.R
  PYTHONPATH=usr/lib/python3/dist-packages /usr/bin/python3 gaps.py
} | sed 's/ *$//' | tee seen
cmp -s - seen <<'TEXT' || {
zoo, maxgap = 5: 0.0 1.0 2.0 - - - - - - - - 11.0 - - -
zoo, at 0, 0.9 and 1 s: 0.0 9.0 10.0
pandas, limit=5: 0.0 1.0 2.0 3.0 4.0 5.0 6.0 7.0 - - - 11.0 11.0 11.0 11.0
pandas, at 0, 0.9 and 1 s: 0.0 5.0 10.0
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
