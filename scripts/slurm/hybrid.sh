#!/bin/bash
# Lab 6 with ranks and threads: every split of a node's cores between the two.
# Build first on the login node: cargo build --release -p solution6
# Then: sbatch --nodes=4 scripts/slurm/hybrid.sh
#SBATCH --job-name=cutoff-hybrid
#SBATCH --time=00:30:00
#SBATCH --exclusive
#SBATCH --output=cutoff-hybrid-%j.jsonl
set -euo pipefail

particles=${PARTICLES:-10000000}
steps=${STEPS:-100}
cores=$SLURM_CPUS_ON_NODE
for ((threads = 1; threads <= cores; threads *= 2)); do
    srun --ntasks-per-node="$((cores / threads))" --cpus-per-task="$threads" --cpu-bind=cores \
        target/release/solution6 --variant hybrid -t "$threads" \
        -n "$particles" --steps "$steps" --json
done
