#!/bin/sh
# SPDX-License-Identifier: MIT
# R 4.2.2 (Debian r-base-core 4.2.2.20221110-2) and SciPy 1.10.1 (Debian python3-scipy 1.10.1-2):
# the same success rates differ significantly in percent and not as fractions.
#
# Expected: Wilcoxon's signed-rank test is of ranks, so its p value is the same for rates of 0.5 and
# of 50 %, as it is for lengths in metres and in millimetres.
# Seen: of two selectors' success in 13 scenarios of ten throws each, p is 0.033 in percent and
# 0.079 as fractions in R, and 0.040 and 0.080 in SciPy. The differences are 10, 20 and 30 %, each
# several times. As fractions most of them are not equal: 0.6 - 0.4 is less than 0.5 - 0.3, which is
# less than 0.9 - 0.7. So what is tied is ranked by the rounding of its subtraction. R has an
# argument for that since 4.0, digits.rank, which is off unless one gives it; SciPy has none.
# Rounding the differences to a few digits before the test gives what percent give.
# Flinch: has no rank tests; its intervals are by bootstrap.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in r-base-core=4.2.2.20221110-2 python3-scipy=1.10.1-2 python3-numpy python3-decorator \
  liblbfgsb0 libblas3 liblapack3 libgfortran5 libquadmath0 libtirpc3; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
R_HOME=$PWD/usr/lib/R
triplet=$PWD/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$R_HOME/lib:$triplet:$triplet/blas:$triplet/lapack
EDITOR="vi"
export R_HOME LD_LIBRARY_PATH EDITOR
rm -f "$R_HOME/etc/Renviron"
: >"$R_HOME/etc/Renviron"
cat >rates.csv <<'CSV'
0.5,0.3
0.6,0.4
1.0,0.9
0.2,0.3
1.0,0.8
0.5,0.3
1.0,0.9
0.0,0.1
0.9,0.7
1.0,0.9
0.5,0.3
0.7,0.9
1.0,0.8
CSV
cat >rates.R <<'R'
rates <- read.csv("rates.csv", header = FALSE)
percent <- round(100 * rates)
for (unit in list(list("fractions", rates), list("percent", percent))) {
  p <- suppressWarnings(wilcox.test(unit[[2]]$V1, unit[[2]]$V2, paired = TRUE))$p.value
  cat(sprintf("R, %s: p = %.3f\n", unit[[1]], p))
}
R
cat >rates.py <<'PY'
import csv

from scipy.stats import wilcoxon

with open("rates.csv") as file:
    first, second = zip(*[map(float, row) for row in csv.reader(file)])
print(f"SciPy, fractions: p = {wilcoxon(first, second).pvalue:.3f}")
rounded = [round(a - b, 6) for a, b in zip(first, second)]
print(f"SciPy, rounded differences of fractions: p = {wilcoxon(rounded).pvalue:.3f}")
first, second = ([round(100 * rate) for rate in rates] for rates in (first, second))
print(f"SciPy, percent: p = {wilcoxon(first, second).pvalue:.3f}")
PY
{
  "$R_HOME/bin/exec/R" --vanilla --slave -f rates.R
  PYTHONPATH=usr/lib/python3/dist-packages /usr/bin/python3 rates.py
} | tee seen
printf '%s\n' 'R, fractions: p = 0.079' 'R, percent: p = 0.033' 'SciPy, fractions: p = 0.080' \
  'SciPy, rounded differences of fractions: p = 0.040' 'SciPy, percent: p = 0.040' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
