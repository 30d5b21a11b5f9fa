#!/bin/sh
# SPDX-License-Identifier: MIT
# Open MPI 4.1.4 (Debian openmpi-bin and libopenmpi-dev 4.1.4-3+b1): the sum of the first numbers of
# the ranks depends on how many other numbers are summed in the same call.
#
# Expected: MPI_Reduce adds in an order of its own, which the number of ranks decides. With the same
# ranks on one machine, an element's sum is the same bits, however many elements the call has, as
# elements have nothing to do with each other.
# Seen: the algorithm is chosen by the length of the message, and each adds in another order. Of
# five ranks, the first sum has three different values for lengths of 1, 1024 and 16384 doubles.
# MPI_Allreduce differs from MPI_Reduce too. So a program that sums one more quantity in a call, or
# a larger table, gives other last bits in all that it summed before. The standard's advice on equal
# results speaks of equal arguments.
# Flinch: sends rows between ranks and lets none of them sum.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=$(dpkg-query -W -f '${Version}' libopenmpi-dev 2>/dev/null || true)
if [ "$version" != 4.1.4-3+b1 ]; then
  # mpirun is not relocatable: it is installed.
  apt-get install -q -y --no-install-recommends openmpi-bin=4.1.4-3+b1 \
    libopenmpi-dev=4.1.4-3+b1 >/dev/null
fi
cat >sum.c <<'C'
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

int main(int count, char** arguments) {
  static double of_rank[16384], sums[16384];
  int rank = 0;
  MPI_Init(&count, &arguments);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  srand(rank + 1);
  of_rank[0] = (rank % 2 ? 1 : -1) * (rand() / (double)RAND_MAX);
  for (int length = 1; length <= 16384; length *= 4) {
    MPI_Reduce(of_rank, sums, length, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
    if (rank == 0) printf("%d doubles: the first sum is %.17g\n", length, sums[0]);
  }
  MPI_Finalize();
}
C
OMPI_ALLOW_RUN_AS_ROOT=1
OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_ALLOW_RUN_AS_ROOT OMPI_ALLOW_RUN_AS_ROOT_CONFIRM
mpicc -O1 sum.c -o sum
mpirun --oversubscribe --bind-to none -n 5 ./sum | tee seen
[ "$(sed 's/.* is //' seen | sort -u | wc -l)" -gt 1 ] || {
  echo "the behaviour has changed" >&2
  exit 1
}
