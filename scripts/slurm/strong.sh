#!/bin/bash
# Measures strong scaling of all labs with ranks on a cluster: the same scene on 1, 2, 4, … ranks.
# Build first on the login node: cargo lab facts >/dev/null && cargo build --release -p 'solution*'
# In a class's kit, name your own programs too: -p lab3
# Then: sbatch --nodes=4 --ntasks-per-node=32 scripts/slurm/strong.sh
# Each line of the output also says how long the ranks computed, communicated and waited. The folder cutoff-events then
# holds the events of each run.
#SBATCH --job-name=cutoff-strong
#SBATCH --time=00:30:00
#SBATCH --exclusive
#SBATCH --output=cutoff-strong-%j.jsonl
source scripts/slurm/labs.sh

soft() { echo "-n ${PARTICLES:-10000000} --steps ${STEPS:-100}"; }

hard() {
    echo "${DISCS:-50000} 20000 1 ${STEPS:-100} perf" >cutoff-events/strong.txt
    echo cutoff-events/strong.txt
}

curve strong
