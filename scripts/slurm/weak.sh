#!/bin/bash
# Measures weak scaling of all labs with ranks on a cluster: 1, 2, 4, … ranks with the same number of particles per rank.
# Build first on the login node: cargo lab facts >/dev/null && cargo build --release -p 'solution*'
# In a class's kit, name your own programs too: -p lab3
# Then: sbatch --nodes=4 --ntasks-per-node=32 scripts/slurm/weak.sh
#SBATCH --job-name=cutoff-weak
#SBATCH --time=00:30:00
#SBATCH --exclusive
#SBATCH --output=cutoff-weak-%j.jsonl
source scripts/slurm/labs.sh

soft() { echo "-n $((${PARTICLES:-1000000} * $1)) --steps ${STEPS:-100}"; }

# The area of the square grows with the number of discs and their speeds stay the same, so that each disc has as many
# others near it on every number of ranks.
hard() {
    local discs=$((${DISCS:-100000} * $1))
    echo "$discs $(awk -v n="$discs" 'BEGIN { print 100 * sqrt(n) }') 1 ${STEPS:-100} perf" >cutoff-events/weak.txt
    echo --speeds 100,200 cutoff-events/weak.txt
}

curve weak
