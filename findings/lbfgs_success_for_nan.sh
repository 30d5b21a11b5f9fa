#!/bin/sh
# SPDX-License-Identifier: MIT
# liblbfgs 1.10 (Debian liblbfgs-dev 1.10-8): a gradient that is not a number is called a minimum.
#
# Expected: an objective that returns NaN ends with one of the many error codes (all negative).
# Seen: lbfgs() returns LBFGS_ALREADY_MINIMIZED (2), no error, when value and gradient at the start
# are NaN; and the header says that 0 and up are successes. Where only the gradient is NaN it is the
# same. The variables stay at their start, so a caller who checks for negative codes takes the start
# for the solution.
# Flinch: the static balance of authored poses checks every value and gradient for finiteness itself.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in liblbfgs-dev liblbfgs0; do
  apt-get -o APT::Sandbox::User=root download -q "$package=1.10-8" >/dev/null
  dpkg-deb -x "$package"_1.10-8_*.deb .
done
library=$(dirname "$(find . -name 'liblbfgs.so' | head -n 1)")
cat >minimum.c <<'C'
#include <lbfgs.h>
#include <math.h>
#include <stdio.h>

static lbfgsfloatval_t value_is_nan(void *data, const lbfgsfloatval_t *x, lbfgsfloatval_t *gradient,
                                    const int n, const lbfgsfloatval_t step) {
  (void)data, (void)x, (void)step;
  for (int i = 0; i < n; ++i) gradient[i] = NAN;
  return NAN;
}
static lbfgsfloatval_t gradient_is_nan(void *data, const lbfgsfloatval_t *x,
                                       lbfgsfloatval_t *gradient, const int n,
                                       const lbfgsfloatval_t step) {
  (void)data, (void)step;
  for (int i = 0; i < n; ++i) gradient[i] = NAN;
  return x[0] * x[0];
}
static int code_of(lbfgs_evaluate_t evaluate) {
  lbfgsfloatval_t *x = lbfgs_malloc(8);
  for (int i = 0; i < 8; ++i) x[i] = 1;
  lbfgs_parameter_t parameters;
  lbfgs_parameter_init(&parameters);
  const int code = lbfgs(8, x, NULL, evaluate, NULL, NULL, &parameters);
  lbfgs_free(x);
  return code;
}
int main(void) {
  printf("value and gradient NaN: %d\n", code_of(value_is_nan));
  printf("gradient NaN: %d\n", code_of(gradient_is_nan));
  printf("LBFGS_ALREADY_MINIMIZED: %d\n", LBFGS_ALREADY_MINIMIZED);
}
C
gcc -I usr/include minimum.c -o minimum -L "$library" -llbfgs -lm
LD_LIBRARY_PATH=$library ./minimum | tee seen
[ "$(sort -u -k 2 -t : seen | wc -l)" -eq 1 ] || { echo "the behaviour has changed" >&2; exit 1; }
