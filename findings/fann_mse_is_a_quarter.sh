#!/bin/sh
# SPDX-License-Identifier: MIT
# FANN 2.2.0 (Debian libfann-dev 2.2.0+ds-8): the mean square error is a quarter of it where the
# output is symmetric.
#
# Expected: fann_get_MSE is the mean of the squared differences between outputs and targets, so two
# networks that are off by as much have the same error, whatever their output activation.
# Seen: for the activations between -1 and 1 (SIGMOID_SYMMETRIC, ELLIOT_SYMMETRIC,
# LINEAR_PIECE_SYMMETRIC, GAUSSIAN_SYMMETRIC, SIN_SYMMETRIC) the difference is halved first, so the
# error is a quarter. Training to a desired error stops by the same figure. So a choice of the
# output activation by the least error takes a symmetric one that is up to twice as far off. The
# manual's pages on fann_get_MSE and on the activations do not say so.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libfann-dev libfann2; do
  apt-get -o APT::Sandbox::User=root download -q "$package=2.2.0+ds-8" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
library=$(dirname "$(find . -name 'libfloatfann.so' | head -n 1)")
cat >mse.c <<'C'
#include <floatfann.h>
#include <stdio.h>

/* The error that FANN gives for one input and one output, over the square of their difference. */
static void test(const char* what, enum fann_activationfunc_enum output) {
  const unsigned int layers[] = {1, 1};
  struct fann* network = fann_create_standard_array(2, layers);
  fann_type input = 0.3F;
  fann_type target = 1;
  fann_set_activation_function_output(network, output);
  const double off = target - fann_test(network, &input, &target)[0];
  printf("%s: %.2f of the squared difference\n", what, fann_get_MSE(network) / (off * off));
  fann_destroy(network);
}

int main(void) {
  test("linear", FANN_LINEAR);
  test("sigmoid", FANN_SIGMOID);
  test("symmetric sigmoid", FANN_SIGMOID_SYMMETRIC);
  test("symmetric Elliot", FANN_ELLIOT_SYMMETRIC);
}
C
gcc -w -O1 -I usr/include mse.c -o mse -L "$library" -lfloatfann
LD_LIBRARY_PATH=$library ./mse | tee seen
printf '%s of the squared difference\n' 'linear: 1.00' 'sigmoid: 1.00' 'symmetric sigmoid: 0.25' \
  'symmetric Elliot: 0.25' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
