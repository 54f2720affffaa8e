#!/bin/sh
# Grade a class on a node of its own: tasks on all cores at once, then the times one by one.
#
#   sbatch scripts/slurm/grade.sh LAB FOLDER
#
# Build first on a node that reaches the network: cargo fetch && cargo build --release --package lab-grading
#SBATCH --job-name=cutoff-grade
#SBATCH --nodes=1
#SBATCH --exclusive
#SBATCH --time=02:00:00
set -eu
cd "${SLURM_SUBMIT_DIR:-.}"
lab=${1:?which lab}
folder=${2:?which folder}
# Killed by the time limit, the same job goes on where it was.
target/release/lab-grading grade "$folder" --lab "$lab" --into "grades/lab$lab"
