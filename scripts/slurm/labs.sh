# What strong.sh, weak.sh, hybrid.sh and threads.sh share; they are submitted from the kit's top folder.
set -euo pipefail
export CARGO_NET_OFFLINE=true

# Prints lines such as «solution8:spatial-cuts»: the programs of all labs with such workers (threads or ranks) that
# simulate such discs (soft or hard), each with the variant that its facts name for `role`: cluster, or hybrid for one
# with threads in each rank. Of a lab without a solution it is the student's own program, such as «lab3:team».
programs() { # WORKERS DISCS ROLE
    cargo lab facts | awk -v workers="$1" -v discs="$2" -v role="$3" '
        $2 == "program" { program = $3 }
        $2 == "workers" { found = $3 == workers }
        $2 == "discs" { found = found && $3 == discs }
        $2 == role && found { print program ":" $3 }'
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
