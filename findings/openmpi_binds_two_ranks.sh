#!/bin/sh
# SPDX-License-Identifier: MIT
# Open MPI 4.1.4 (Debian openmpi-bin 4.1.4-3+b1): up to two ranks are each bound to one core, more
# are not.
#
# Expected: mpirun leaves to a threaded program the cores that it has without mpirun, or takes the
# same away from it whatever the number of ranks.
# Seen: the default binding is by core for one or two ranks, and by socket (NUMA domain) beyond. So
# OpenMP in the single rank of "mpirun -n 1" sees one core; a program that scales is as slow as
# without threads, and the same program with three ranks is not.
# Flinch: warns where a rank has fewer cores than threads; every command shown has --bind-to none.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=$(dpkg-query -W -f '${Version}' openmpi-bin 2>/dev/null || true)
if [ "$version" != 4.1.4-3+b1 ]; then
  # mpirun is not relocatable: it is installed.
  apt-get install -q -y --no-install-recommends openmpi-bin=4.1.4-3+b1 >/dev/null
fi
cores() {
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
    mpirun --oversubscribe "$@" nproc | sort -u
}
all=$(nproc)
[ "$all" -gt 1 ] || { echo "one core: nothing to see"; exit 0; }
one=$(cores -n 1)
two=$(cores -n 2)
free=$(cores --bind-to none -n 1)
echo "$all cores; mpirun -n 1: $one; -n 2: $two; -n 1 --bind-to none: $free"
[ "$one $two $free" = "1 1 $all" ] || { echo "the behaviour has changed" >&2; exit 1; }
