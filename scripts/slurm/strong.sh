#!/bin/bash
# Strong scaling of labs 5 and 6 on a cluster: the same scene on 1, 2, 4, … ranks.
# Build first on the login node: cargo build --release -p solution5 -p solution6
# Then: sbatch --nodes=4 --ntasks-per-node=32 scripts/slurm/strong.sh
#SBATCH --job-name=cutoff-strong
#SBATCH --time=00:30:00
#SBATCH --exclusive
#SBATCH --output=cutoff-strong-%j.jsonl
set -euo pipefail

particles=${PARTICLES:-10000000}
steps=${STEPS:-100}
for lab in 5 6; do
    for ((ranks = 1; ranks <= SLURM_NTASKS; ranks *= 2)); do
        srun --ntasks="$ranks" --cpu-bind=cores "target/release/solution$lab" \
            -n "$particles" --steps "$steps" --json
    done
done
