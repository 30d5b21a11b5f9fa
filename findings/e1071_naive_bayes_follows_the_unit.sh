#!/bin/sh
# SPDX-License-Identifier: MIT
# e1071 1.7-13 for R (Debian r-cran-e1071 1.7-13-1): naive Bayes names the class that is 98 standard
# deviations away, and which class it names depends on the unit.
#
# Expected: a clip "duck" whose head drops by 0.90 m with a deviation of 0.02, and a clip "stand" with 0
# and 0.01: a row with 0.98 m is a duck, 4 deviations off, and no stand. Centimetres change nothing.
# Seen: in metres it is a duck, in centimetres a stand, with a probability of 0.9. A density of zero,
# which is what a double holds beyond 38 deviations, is replaced by 0.001, and that is larger than an
# honest density in the tail of a wide column: 1e-4 per centimetre here. The arguments threshold and eps
# of predict() set both numbers; threshold = 1e-300 makes the two units agree.
# Flinch: its learners scale features before they see them, and it has no naive Bayes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in r-cran-e1071=1.7-13-1 r-base-core=4.2.2.20221110-2 r-cran-class r-cran-proxy libblas3 \
  liblapack3 libgfortran5 libquadmath0 libtirpc3; do
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
cat >clips.R <<'R'
around <- qnorm((1:50 - 0.5) / 50)
drop <- c(0.01 * around, 0.90 + 0.02 * around)
clip <- factor(rep(c("stand", "duck"), each = 50))
for (unit in c(1, 100, 1000)) {
  model <- e1071::naiveBayes(data.frame(drop = drop * unit), clip)
  row <- data.frame(drop = 0.98 * unit)
  cat(sprintf("a drop of %g: %s, with threshold = 1e-300 %s\n", row$drop, predict(model, row),
              predict(model, row, threshold = 1e-300)))
}
R
"$R_HOME/bin/exec/R" --vanilla --slave -f clips.R | tee seen
cmp -s - seen <<'TEXT' || {
a drop of 0.98: duck, with threshold = 1e-300 duck
a drop of 98: stand, with threshold = 1e-300 duck
a drop of 980: stand, with threshold = 1e-300 duck
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
