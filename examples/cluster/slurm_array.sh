#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Simulates many scenarios on a cluster as a Slurm job array, without MPI: each task simulates its
# own range of scenarios into its own store, and a last job merges the stores.
#
#     array=$(sbatch --parsable --array=0-99 examples/cluster/slurm_array.sh)
#     sbatch --dependency=afterok:$array examples/cluster/slurm_array.sh merge
#
# Submit a task that fails or runs out of time again (--array=17): it resumes where it stopped.
#SBATCH --job-name=flinch
#SBATCH --cpus-per-task=32
#SBATCH --mem=4G
#SBATCH --time=04:00:00
set -euo pipefail

flinch=${FLINCH:-flinch}
library=${LIBRARY:-default.flinchlib}
store=${STORE:-default.flinchobs}
scenarios=${SCENARIOS:-10000000}
seed=${SEED:-1}

if [[ ${1-} == merge ]]; then
  exec "$flinch" merge "$store".part-?????? --out "$store"
fi

# If the number does not divide evenly, the first tasks take one scenario more.
tasks=$SLURM_ARRAY_TASK_COUNT
task=$((SLURM_ARRAY_TASK_ID - ${SLURM_ARRAY_TASK_MIN:-0}))
count=$((scenarios / tasks + (task < scenarios % tasks)))
first=$((task * (scenarios / tasks) + (task < scenarios % tasks ? task : scenarios % tasks)))

printf -v part '%s.part-%06d' "$store" "$task"
exec "$flinch" simulate "$library" --out "$part" --first "$first" -n "$count" --seed "$seed" \
  --threads "$SLURM_CPUS_PER_TASK" --memory "${MEMORY:-3G}"
