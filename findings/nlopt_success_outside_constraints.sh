#!/bin/sh
# SPDX-License-Identifier: MIT
# NLopt 2.7.1 (Debian libnlopt-dev 2.7.1-5): where no point meets the constraints, several algorithms
# report success.
#
# Expected: minimising x^2 + y^2 where x is to be at least 1 and at most -1 ends with a negative code,
# which is what NLopt calls an error, or the result can be told from a solution by its code.
# Seen: MMA, CCSA and COBYLA return NLOPT_XTOL_REACHED (4), a success, with a point that misses a
# constraint by 1 or more where 1e-8 was allowed. The codes speak of the stopping criterion only. The value
# returned is that of the point, so nothing of it shows. SLSQP alone answers with an error here.
# Flinch: does not use it. Who does evaluates the constraints at the result.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libnlopt-dev libnlopt0; do
  apt-get -o APT::Sandbox::User=root download -q "$package=2.7.1-5" >/dev/null
  dpkg-deb -x "$package"_2.7.1-5_*.deb .
done
library=$(dirname "$(find . -name 'libnlopt.so' | head -n 1)")
cat >infeasible.c <<'C'
#include <math.h>
#include <nlopt.h>
#include <stdio.h>

static double squares(unsigned n, const double *x, double *gradient, void *unused) {
  (void)n, (void)unused;
  for (int i = 0; gradient && i < 2; ++i) gradient[i] = 2 * x[i];
  return x[0] * x[0] + x[1] * x[1];
}
// 1 - sign * x, which is to be at most 0.
static double beyond_one(unsigned n, const double *x, double *gradient, void *sign) {
  (void)n;
  if (gradient) gradient[0] = -*(double *)sign, gradient[1] = 0;
  return 1 - *(double *)sign * x[0];
}
int main(void) {
  const nlopt_algorithm algorithms[] = {NLOPT_LD_MMA, NLOPT_LD_CCSAQ, NLOPT_LN_COBYLA,
                                        NLOPT_LD_SLSQP};
  double signs[] = {1, -1};
  for (int i = 0; i < 4; ++i) {
    nlopt_opt optimizer = nlopt_create(algorithms[i], 2);
    nlopt_set_lower_bounds1(optimizer, -5);
    nlopt_set_upper_bounds1(optimizer, 5);
    nlopt_set_min_objective(optimizer, squares, NULL);
    for (int k = 0; k < 2; ++k) {
      nlopt_add_inequality_constraint(optimizer, beyond_one, &signs[k], 1e-8);
    }
    nlopt_set_xtol_rel(optimizer, 1e-6);
    nlopt_set_maxeval(optimizer, 10000);
    double x[] = {0.3, 0.4};
    double value = 0;
    const nlopt_result code = nlopt_optimize(optimizer, x, &value);
    printf("%s: %s (%d), misses a constraint by %.1f\n", nlopt_algorithm_to_string(algorithms[i]),
           nlopt_result_to_string(code), code, 1 + fabs(x[0]));
    nlopt_destroy(optimizer);
  }
  return 0;
}
C
gcc -I usr/include infeasible.c -o infeasible -L "$library" -lnlopt -lm
LD_LIBRARY_PATH=$library ./infeasible | tee seen
[ "$(grep -c 'XTOL_REACHED (4), misses' seen)" = 3 ] && grep -q '^LD_SLSQP: .*(-' seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
