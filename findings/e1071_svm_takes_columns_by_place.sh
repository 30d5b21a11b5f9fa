#!/bin/sh
# SPDX-License-Identifier: MIT
# e1071 1.7-13 for R (Debian r-cran-e1071 1.7-13-1): a machine answers by the place of the columns in one of
# its two forms and by their names in the other.
#
# Expected: svm(x, y) and svm(y ~ ., data) of the same named columns are the same machine, and predict()
# takes the columns of a new data frame by their names in both, as naiveBayes of the same package and
# randomForest do in both of theirs.
# Seen: of a table whose columns stand in another order, the machine of svm(x, y) gets half of the rows
# right, no more than a coin, without a warning; that of the formula gets all. A table of features that was
# written by another version of a program is enough. predict of a row with a missing value leaves the
# row out, so that answers and rows no longer stand side by side.
# Flinch: a selector keeps the names of its features, and the run time refuses one that it cannot compute.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in r-cran-e1071=1.7-13-1 r-base-core=4.2.2.20221110-2 r-cran-class r-cran-proxy \
  r-cran-randomforest libblas3 liblapack3 libgfortran5 libquadmath0 libtirpc3; do
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
cat >columns.R <<'R'
set.seed(1)
clip <- factor(rep(c("duck", "stand"), 50))
rows <- data.frame(height = rnorm(100) + 4 * (clip == "duck"), speed = rnorm(100, 30))
turned <- rows[, c("speed", "height")]
missing <- rows
missing$speed[3] <- NA
suppressMessages(library(randomForest))
models <- list("svm(x, y)" = e1071::svm(rows, clip),
               "svm(y ~ .)" = e1071::svm(clip ~ ., data = cbind(rows, clip)),
               "naiveBayes(x, y)" = e1071::naiveBayes(rows, clip),
               "randomForest(x, y)" = randomForest(rows, clip))
for (name in names(models)) {
  right <- function(table) sum(predict(models[[name]], table) == clip)
  cat(sprintf("%s: %d of 100 right, with the columns turned about %d\n", name, right(rows),
              right(turned)))
}
cat(sprintf("a missing value: %d answers for 100 rows\n", length(predict(models[[1]], missing))))
R
"$R_HOME/bin/exec/R" --vanilla --slave -f columns.R | tee seen
cmp -s - seen <<'TEXT' || {
svm(x, y): 99 of 100 right, with the columns turned about 50
svm(y ~ .): 99 of 100 right, with the columns turned about 99
naiveBayes(x, y): 99 of 100 right, with the columns turned about 99
randomForest(x, y): 100 of 100 right, with the columns turned about 100
a missing value: 99 answers for 100 rows
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
