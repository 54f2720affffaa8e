#!/bin/bash
# Runs the labs that have threads within ranks, with every split of a node's cores into ranks and threads.
# Build first on the login node: cargo lab facts >/dev/null && cargo build --release -p 'solution*'
# In a class's kit, name your own programs too: -p lab3
# Then: sbatch --nodes=4 scripts/slurm/hybrid.sh
#SBATCH --job-name=cutoff-hybrid
#SBATCH --time=00:30:00
#SBATCH --exclusive
#SBATCH --output=cutoff-hybrid-%j.jsonl
source scripts/slurm/labs.sh

for program in $(programs ranks soft hybrid); do
    for ((threads = 1; threads <= SLURM_CPUS_ON_NODE; threads *= 2)); do
        srun --ntasks-per-node="$((SLURM_CPUS_ON_NODE / threads))" --cpus-per-task="$threads" --cpu-bind=cores \
            "target/release/${program%:*}" --variant "${program#*:}" -t "$threads" \
            -n "${PARTICLES:-10000000}" --steps "${STEPS:-100}" --json
    done
done
