#!/bin/bash
# Strong scaling of labs 5, 6 and 8 on a cluster: the same scene on 1, 2, 4, … ranks.
# Build first on the login node: cargo build --release -p solution5 -p solution6 -p solution8
# Then: sbatch --nodes=4 --ntasks-per-node=32 scripts/slurm/strong.sh
# Each line says too how long the ranks computed, communicated and waited; the events are in the folder
# cutoff-events.
#SBATCH --job-name=cutoff-strong
#SBATCH --time=00:30:00
#SBATCH --exclusive
#SBATCH --output=cutoff-strong-%j.jsonl
set -euo pipefail

particles=${PARTICLES:-10000000}
discs=${DISCS:-50000}
steps=${STEPS:-100}
mkdir -p cutoff-events
echo "$discs 20000 1 $steps perf" >cutoff-events/strong.txt

on() { # RANKS PROGRAM ARGUMENTS...
    srun --ntasks="$1" --cpu-bind=cores "target/release/$2" "${@:3}" --json \
        --events "cutoff-events/strong-$2-$1.txt"
}

for ((ranks = 1; ranks <= SLURM_NTASKS; ranks *= 2)); do
    for program in solution5 solution6; do
        on "$ranks" "$program" -n "$particles" --steps "$steps"
    done
    on "$ranks" solution8 --variant spatial-cuts cutoff-events/strong.txt
done
