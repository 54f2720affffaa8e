#!/bin/bash
# Scaling of labs 3 to 8 as the book has it, with 1, 2, 4, … workers up to all cores of a node, each beside the book's own: as
# numbers in book/data, as a figure, and in the chapter below the figure that it repeats.
# Build first on the login node: cargo fetch && cargo build && cargo build --release -p 'solution*'
# Then: sbatch --nodes=1 scripts/slurm/book.sh [book/data/lab3-scaling.json …]
#SBATCH --job-name=cutoff-book
#SBATCH --time=04:00:00
#SBATCH --exclusive
set -euo pipefail
cd "${SLURM_SUBMIT_DIR:-.}"
export CARGO_NET_OFFLINE=true
cores=${SLURM_CPUS_ON_NODE:-$(nproc)}
workers=1
for ((p = 2; p < cores; p *= 2)); do workers+=,$p; done
workers+=,$cores

if [ $# -eq 0 ]; then
    mapfile -t found < <(grep -lE '"command": "cargo lab scaling [3-8] .*--svg ' book/data/*.json | grep -v -- '-cores\.json$')
    set -- "${found[@]}"
fi
for file; do
    old=$(basename "$file" .json)
    new=$old-$cores-cores
    command=$(sed -nE 's/^  "command": "(.*)",$/\1/p' "$file" | sed -E 's/ --(workers|json|svg) [^ ]+//g')
    # Its words are as a shell takes them.
    eval "$command --workers $workers --json book/data/$new.json --svg book/src/figures/$new.svg"
    if ! grep -q "figures/$new\.svg" book/src/*.md; then
        line="<img src=\"figures/$new.svg\" alt=\"The same on $cores cores.\">"
        sed -i "/<img src=\"figures\/$old\.svg\"/a $line" book/src/*.md
    fi
done
cargo lab figures
