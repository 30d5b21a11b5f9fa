#!/bin/sh
# SPDX-License-Identifier: MIT
# glibc 2.36 (Debian libc6-dev 2.36-9+deb12u*): exp, log, pow, sin, cos, tan, atan and atan2 give other
# last bits on processors without FMA, also in a static program.
#
# Expected: a program that was linked statically, for the oldest x86-64 processor and with
# -ffp-contract=off, computes the same bits on all of them.
# Seen: the static library holds these functions twice, with and without fused multiply-add, and
# chooses when the program starts. Without FMA, here by GLIBC_TUNABLES, one binary gives other values
# for one in 1400 arguments of exp, pow, sin and cos, and of the others for fewer. sinf and expf agree
# for all of these arguments: they compute in double and round once.
# Flinch: has its own in place of these functions; docs/determinism.md says how that is tested.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=$(dpkg-query -W -f '${Version}' libc6-dev)
case "$version" in
  2.36-9+deb12u*) ;;
  *) echo "libc6-dev is $version: the behaviour has changed" >&2; exit 1 ;;
esac
grep -qw fma /proc/cpuinfo || { echo "a processor without FMA: nothing to see"; exit 0; }
cd "$folder"
cat >values.c <<'C'
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { kFunctions = 10, kArguments = 200000 };
static const char *const names[kFunctions] = {"exp",  "log",   "pow",  "sin",  "cos",
                                              "tan", "atan", "atan2", "sinf", "expf"};
static double now[kArguments][kFunctions];
static double before[kArguments][kFunctions];

// Without an argument it writes all values to the standard output; with one, it compares them.
int main(int argc, char **argv) {
  for (int i = 0; i < kArguments; ++i) {
    const double x = (i + 1) * 1.37e-4;
    const double values[kFunctions] = {exp(x), log(x),  pow(x, 1.7),   sin(x),  cos(x),
                                       tan(x), atan(x), atan2(x, 1.3), sinf(x), expf(x)};
    memcpy(now[i], values, sizeof values);
  }
  if (argc == 1) return fwrite(now, sizeof now, 1, stdout) != 1;
  FILE *const file = fopen(argv[1], "rb");
  if (!file || fread(before, sizeof before, 1, file) != 1) return 1;
  for (int f = 0; f < kFunctions; ++f) {
    int differ = 0;
    for (int i = 0; i < kArguments; ++i) differ += memcmp(&now[i][f], &before[i][f], 8) != 0;
    printf("%s: %d of %d values differ\n", names[f], differ, kArguments);
  }
  return 0;
}
C
gcc -O2 -fno-builtin -ffp-contract=off -static values.c -o values -lm
./values >with_fma
GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA ./values with_fma | tee seen
[ "$(grep -cv ': 0 of' seen)" = 8 ] && grep -q '^sinf: 0 of' seen && grep -q '^expf: 0 of' seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
