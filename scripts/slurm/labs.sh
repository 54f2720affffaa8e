# Functions for strong.sh, weak.sh, hybrid.sh and threads.sh. Submit these scripts from the kit's top folder.
set -euo pipefail
export CARGO_NET_OFFLINE=true

# Prints lines such as «solution8:spatial-cuts»: the program and the variant of each lab that has WORKERS (threads or
# ranks) and simulates DISCS (soft or hard). The lab's facts name the variant for ROLE: `cluster`, or `hybrid` for ranks
# with threads within each. For a lab without a solution the program is the student's own, as in «lab3:team».
programs() { # WORKERS DISCS ROLE
    cargo lab facts | awk -v workers="$1" -v discs="$2" -v role="$3" '
        $2 == "program" { program = $3 }
        $2 == "workers" { found = $3 == workers }
        $2 == "discs" { found = found && $3 == discs }
        $2 == role && found { print program ":" $3 }'
}

# Runs every lab with ranks on 1, 2, 4, … ranks. The calling script defines the functions `soft` and `hard`: they take
# the number of ranks, and print the arguments by which a program simulates the scene.
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
