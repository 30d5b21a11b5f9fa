#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Simulates many scenarios on a cluster as one MPI job: one process per node, with one thread per
# processor, so that a node rehearses each response once. Process 0 writes the store.
#
#     sbatch --nodes=8 examples/cluster/slurm_mpi.sh
#
# Submitted again after a failure or a timeout, the job resumes where it stopped.
#SBATCH --job-name=flinch
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=1
#SBATCH --cpus-per-task=32
#SBATCH --mem=8G
#SBATCH --time=04:00:00
set -euo pipefail

# Without --bind-to none, mpirun may bind the process to one core of its node.
exec mpirun --map-by node --bind-to none "${FLINCH:-flinch}" simulate \
  "${LIBRARY:-default.flinchlib}" --out "${STORE:-default.flinchobs}" \
  -n "${SCENARIOS:-10000000}" --seed "${SEED:-1}" --threads "$SLURM_CPUS_PER_TASK" \
  --memory "${MEMORY:-6G}"
