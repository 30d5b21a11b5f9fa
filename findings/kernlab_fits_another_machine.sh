#!/bin/sh
# SPDX-License-Identifier: MIT
# kernlab 0.9-32 for R (Debian r-cran-kernlab 0.9-32-1): ksvm fits another machine to the same data each
# time.
#
# Expected: a support vector machine is the solution of a convex problem, so the same data and
# defaults fit the same one, as svm of the package e1071 does.
# Seen: ksvm guesses its kernel's width from rows that it draws. Of 20 fits of iris the widest kernel is
# 2.5 times the narrowest, and ten fits of 120 rows of eight features disagree on the class of 91 of
# 1000 new rows. So who compares two sets of features also compares two draws. set.seed before each
# fit, or kpar = list(sigma = ...), ends it. The help says of "automatic" that it is a heuristic of
# sigest, and only sigest's own that it takes a sample.
# Flinch: does not use it; the same seed fits the same selector.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in r-cran-kernlab=0.9-32-1 r-cran-e1071=1.7-13-1 r-base-core=4.2.2.20221110-2 r-cran-class \
  r-cran-proxy r-cran-mass libblas3 liblapack3 libgfortran5 libquadmath0 libtirpc3; do
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
cat >fits.R <<'R'
suppressMessages({
  library(kernlab)
  library(e1071)
})
set.seed(2)
rows <- matrix(rnorm(120 * 8), 120)
classes <- factor(rows[, 1]^2 + rows[, 2]^2 + rnorm(120) > 2)
asked <- matrix(rnorm(1000 * 8), 1000)
disagreed <- function(fit) {
  answers <- sapply(1:10, function(i) as.integer(predict(fit(rows, classes), asked)))
  sum(apply(answers, 1, function(answer) length(unique(answer)) > 1))
}
width <- function(i) {
  machine <- ksvm(Species ~ ., iris)
  kpar(kernelf(machine))$sigma
}
widths <- sapply(1:20, width)
cat(sprintf("ksvm: of 20 fits the widest kernel is %.1f times the narrowest,\n",
            max(widths) / min(widths)))
cat(sprintf("  and ten fits disagree on %d of 1000 rows\n", disagreed(ksvm)))
cat(sprintf("svm: ten fits disagree on %d of 1000 rows\n", disagreed(svm)))
R
"$R_HOME/bin/exec/R" --vanilla --slave -f fits.R | tee seen
printf '%s\n' 'ksvm: of 20 fits the widest kernel is 2.5 times the narrowest,' \
  '  and ten fits disagree on 91 of 1000 rows' 'svm: ten fits disagree on 0 of 1000 rows' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
