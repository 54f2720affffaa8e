#!/bin/bash
# Runs every lab that has soft discs and threads on 1, 2, 4, … threads of one node: first with the same scene, then with
# the same number of particles per thread.
# Build first on the login node: cargo lab facts >/dev/null && cargo build --release -p 'solution*'
# In a class's kit, name your own programs too: -p lab3
# Then: sbatch --nodes=1 scripts/slurm/threads.sh
#SBATCH --job-name=cutoff-threads
#SBATCH --time=00:30:00
#SBATCH --exclusive
#SBATCH --output=cutoff-threads-%j.jsonl
source scripts/slurm/labs.sh

particles=${PARTICLES:-1000000}
steps=${STEPS:-100}
cores=$SLURM_CPUS_ON_NODE

on() { # THREADS PROGRAM PARTICLES
    srun --ntasks=1 --cpus-per-task="$1" --cpu-bind=cores "target/release/${2%:*}" \
        --variant "${2#*:}" -t "$1" -n "$3" --steps "$steps" --json
}

for program in $(programs threads soft cluster); do
    for ((threads = 1; threads <= cores; threads *= 2)); do
        on "$threads" "$program" "$particles"
    done
    for ((threads = 1; threads <= cores; threads *= 2)); do
        on "$threads" "$program" "$((particles * threads))"
    done
done
