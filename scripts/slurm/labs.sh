# What strong.sh, weak.sh, hybrid.sh and threads.sh share; they are submitted from the kit's top folder.
set -euo pipefail

# Lines «solution8:spatial-cuts»: the solutions of labs with such workers (threads or ranks) that simulate such discs
# (soft or hard), each with the variant that its facts name for `role`: cluster, or hybrid for one with threads in
# each rank.
programs() { # WORKERS DISCS ROLE
    local lab variant
    for lab in $(grep -lx "workers = \"$1\"" solutions/lab*/lab.toml | xargs grep -lx "discs = \"$2\"" | sort -V); do
        variant=$(sed -n "s/^$3 = \"\(.*\)\"\$/\1/p" "$lab")
        lab=${lab%/lab.toml}
        if [ -n "$variant" ]; then echo "solution${lab#solutions/lab}:$variant"; fi
    done
}

# Every lab with ranks on 1, 2, 4, … of them. `soft` and `hard` are functions that say for a number of ranks what is
# simulated, as arguments of a program.
curve() { # NAME
    local ranks discs program
    mkdir -p cutoff-events
    for ((ranks = 1; ranks <= SLURM_NTASKS; ranks *= 2)); do
        for discs in soft hard; do
            for program in $(programs ranks "$discs" cluster); do
                # shellcheck disable=SC2046 # one word each
                srun --ntasks="$ranks" --cpu-bind=cores "target/release/${program%:*}" --variant "${program#*:}" \
                    $("$discs" "$ranks") --json --events "cutoff-events/$1-${program%:*}-$ranks.txt"
            done
        done
    done
}
