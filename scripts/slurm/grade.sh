#!/bin/sh
# Grades a class on a node of its own: first the tests of all submissions, on all cores at once, then the run times, one
# submission after the other.
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
# If the time limit ends the job, submit the same job again: it continues where it stopped.
target/release/lab-grading grade "$folder" --lab "$lab" --into "grades/lab$lab"
