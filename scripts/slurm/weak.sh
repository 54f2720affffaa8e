#!/bin/bash
# Weak scaling of labs 5, 6 and 8 on a cluster: as many particles for each of 1, 2, 4, … ranks.
# Build first on the login node: cargo build --release -p solution5 -p solution6 -p solution8
# Then: sbatch --nodes=4 --ntasks-per-node=32 scripts/slurm/weak.sh
#SBATCH --job-name=cutoff-weak
#SBATCH --time=00:30:00
#SBATCH --exclusive
#SBATCH --output=cutoff-weak-%j.jsonl
set -euo pipefail

particles=${PARTICLES:-1000000}
discs=${DISCS:-100000}
steps=${STEPS:-100}
mkdir -p cutoff-events

on() { # RANKS PROGRAM ARGUMENTS...
    srun --ntasks="$1" --cpu-bind=cores "target/release/$2" "${@:3}" --json \
        --events "cutoff-events/weak-$2-$1.txt"
}

for ((ranks = 1; ranks <= SLURM_NTASKS; ranks *= 2)); do
    for program in solution5 solution6; do
        on "$ranks" "$program" -n "$((particles * ranks))" --steps "$steps"
    done
    # The square grows with the discs and their speeds do not, so that each has as many near it.
    side=$(awk -v n="$((discs * ranks))" 'BEGIN { print 100 * sqrt(n) }')
    echo "$((discs * ranks)) $side 1 $steps perf" >cutoff-events/weak.txt
    on "$ranks" solution8 --variant spatial-cuts --speeds 100,200 cutoff-events/weak.txt
done
