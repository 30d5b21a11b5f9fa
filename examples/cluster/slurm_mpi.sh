#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Simulates many scenarios on a cluster as one MPI job: one process a node, with a thread for each of
# its processors, so that a node rehearses each response once. Process 0 writes the store.
#
#     sbatch --nodes=8 examples/cluster/slurm_mpi.sh
#
# Submitted again after a failure or at the end of its time, the job goes on where it was.
#SBATCH --job-name=flinch
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=1
#SBATCH --cpus-per-task=32
#SBATCH --mem=8G
#SBATCH --time=04:00:00
set -euo pipefail

# One process must not be bound to one core of its node.
exec mpirun --map-by node --bind-to none "${FLINCH:-flinch}" simulate \
  "${LIBRARY:-default.flinchlib}" --out "${STORE:-default.flinchobs}" \
  -n "${SCENARIOS:-10000000}" --seed "${SEED:-1}" --threads "$SLURM_CPUS_PER_TASK" \
  --memory "${MEMORY:-6G}"
