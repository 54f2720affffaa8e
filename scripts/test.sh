#!/bin/bash
# What the kit checks about itself, in stages; the first that fails ends it and is named.
#
#   scripts/test.sh           set up, then each lab, each package and the book, within some ten minutes
#   scripts/test.sh --all     that and the rest, for most of an hour: lints, an editor's view of all, what students
#                             get, known-wrong solutions, marks, the book's pages in a browser, measuring commands
#   scripts/test.sh --list    the stages' names, the rest last
#   scripts/test.sh NAME…     only these stages
#
# A stage that this machine cannot run says so («skipped: no mdBook»), and so does a part of one («left out: no MPI»).
# A test program that has passed is not run again within half a day while nothing that it reads changes; after
# `rm target/debug/deps/*.passed` all are. The last line counts.
set -uo pipefail
cd "$(dirname "$0")/.."

STAGES=(format tests doctests starters figures book)
REST=(lint editor handout proof marks pages smoke)
# Run by name after a change of scripts/gradescope: it builds the kit once more.
BY_NAME=(gradescope)

# What is here besides Rust?
have() { command -v "$1" >/dev/null 2>&1; }
has_mpi() { have "${MPICC:-mpicc}" && have mpiexec; }
has_vulkan() { [ "$(uname)" = Darwin ] || ldconfig -p 2>/dev/null | grep 'libvulkan\.so' >/dev/null; }

# The labs with such workers (threads, ranks or device), as their facts say.
labs_with() { labs_of workers "$1"; }
labs_of() { # FACT VALUE
    grep -lx "$1 = \"$2\"" solutions/lab*/lab.toml | sort -V | sed 's/[^0-9]*\([0-9]*\).*/\1/'
}
# All packages that this machine can build and that are not red by design. Always all of them: which features of a
# dependency are chosen depends on the packages that are named, and with others much would be compiled once more.
everything() {
    echo --workspace
    { labs_with threads; labs_with ranks; labs_with device; } | sed 's/^/--exclude lab/'
    has_mpi || { echo '--exclude common-mpi --exclude mpi-sys --exclude oracle-mpi --exclude halo --exclude hard-disc-ranks --exclude strips'; labs_with ranks | sed 's/^/--exclude solution/'; }
    has_vulkan || { echo '--exclude device --exclude device-discs'; labs_with device | sed 's/^/--exclude solution/'; }
}
# What that leaves out.
name_left_out() {
    has_mpi || leave_out "no MPI"
    has_vulkan || leave_out "no Vulkan"
}
# A command of the kit from the same build as the tests, where `cargo lab` would build its package by itself.
lab() { build "$1" && "$(built "$1")" "${@:2}"; } # lab PACKAGE COMMAND…
# A test is asked for as well: where none is, cargo chooses other features.
# shellcheck disable=SC2046 # one word each
build() { cargo build --quiet $(everything) --bin "$1" --test lab1; }
built() { realpath "${CARGO_TARGET_DIR:-target}/debug/$1"; }

skip() { echo "skipped: $*"; SKIPPED=1; }
# A part of a stage that this machine cannot run; the rest of it counts.
leave_out() { echo "left out: $*"; }

stage_format() {
    cargo fmt --all --check && rustfmt --edition 2024 --check tests/lab*.rs tests/lab*/*.rs
}

# shellcheck disable=SC2046
stage_lint() {
    name_left_out
    cargo clippy --all-targets $(everything) -- -D warnings
}

# What cargo and an editor say of all labs on a machine with only Rust: no error. The folder is its own, for in the
# usual one an MPI library was found, perhaps, and that is not asked twice.
stage_editor() (
    CARGO_TARGET_DIR=$(realpath "${CARGO_TARGET_DIR:-target}")/editor
    export CARGO_TARGET_DIR MPICC=/none PKG_CONFIG_LIBDIR=/none
    cargo check --workspace || return
    rust-analyzer --version >/dev/null 2>&1 || { leave_out "no rust-analyzer"; return; }
    rust-analyzer diagnostics . >"$LOG.editor" 2>&1 && return
    tr '\r\b' '\n\n' <"$LOG.editor" | grep ': Error '
    return 1
)

UNLESS_PASSED="target.'cfg(all())'.runner = ['$PWD/scripts/unless-passed.sh']"
# shellcheck disable=SC2046 # one word each
stage_tests() {
    name_left_out
    cargo test --all-targets --no-fail-fast --config "$UNLESS_PASSED" $(everything)
}

# shellcheck disable=SC2046
stage_doctests() { cargo test --doc $(everything); }

stage_starters() { lab lab-keep starter --check; }

# A class's kit after labs 1 and 2: it builds by itself, lab 2 is red at its first todo, its book is whole. Its builds
# stay in a folder of their own, and the next time only what is the kit's is compiled.
stage_handout() {
    local folder said
    folder=$(mktemp -d)
    lab lab-keep handout 1 --into "$folder/kit" && lab lab-keep handout 2 --into "$folder/kit" && build lab || return
    said=$(in_handout test 2)
    echo "$said"
    grep -q '^Lab 2, .*: 0 of [0-9]* tasks done, start with task 2\.1' <<<"$said" || return
    if have mdbook; then in_handout book || return; fi
    rm -rf "$folder"
}
in_handout() ( # in_handout COMMAND…
    lab=$(built lab)
    export CARGO_TARGET_DIR=${lab%/debug/lab}/handout
    cd "$folder/kit" && cargo tree --locked --offline -p lab2 >/dev/null && "$lab" "$@"
)

stage_proof() { cargo lab prove; }

full_marks() { cargo lab grade solutions --lab "$1" --no-timing --into "$2" >"$LOG.marks" 2>&1; }
# Each solution has full marks: its answers are recorded and judged as a submission's are.
stage_marks() {
    local folder lab labs
    labs=$(labs_with threads)
    has_mpi && labs+=" $(labs_with ranks)"
    has_vulkan && labs+=" $(labs_with device)"
    folder=$(mktemp -d)
    for lab in $labs; do
        full_marks "$lab" "$folder/$lab"
        # Open MPI 4.1 crashes at the end of one job in some hundred, though it has answered.
        grep -q 'exited on signal' "$LOG.marks" && full_marks "$lab" "$folder/$lab-again"
        if grep -Eo '^solutions +100 of [0-9.]+( |$)' "$LOG.marks" | sed "s/^solutions */lab $lab: /"; then
            continue
        elif grep -q -- '--trusted' "$LOG.marks"; then
            skip "no sandbox"
            break
        elif grep -q 'no adapter' "$LOG.marks"; then
            leave_out "no adapter for lab $lab"
        else
            cat "$LOG.marks"
            return 1
        fi
    done
    rm -rf "$folder"
}

# Gradescope's way in a fresh folder: the image grades the solution, and then a submission of it compiles nothing of
# the kit. Where no sandbox can be made, a submission reads no solution.
stage_gradescope() {
    local folder compiled
    have unzip || { skip "no unzip"; return; }
    folder=$(mktemp -d)
    scripts/gradescope/pack.sh 1 "$folder/autograder.zip" || return
    unzip -q "$folder/autograder.zip" -d "$folder/source" && mkdir -p "$folder/submission/labs/lab1" || return
    in_image "$folder" "$folder/source/kit/solutions" || return
    cp -R solutions/lab1/src "$folder/submission/labs/lab1"
    sed -i 's/solution1/lab1/' "$folder/submission/labs/lab1/src/main.rs"
    touch "$folder/primed"
    in_image "$folder" || return
    compiled=$(find "$folder/source/kit/target" -newer "$folder/primed" -path '*/.fingerprint/*.json' | head -n 1)
    [ -z "$compiled" ] || { echo "a submission compiles the kit: $compiled"; return 1; }
    rm -rf "$folder"
    cargo test --package lab-grading --test grading -- --ignored --nocapture without_namespaces
}
in_image() { # in_image FOLDER [PATH]
    env -u CARGO_TARGET_DIR AUTOGRADER="$1" LIMIT=3600 sh "$1/source/run_autograder" "${@:2}" &&
        grep '^  "score": 100' "$1/results/results.json"
}

stage_figures() { lab lab-keep figures --check; }

stage_book() {
    have mdbook || { skip "no mdBook"; return; }
    # The check asks all solutions' programs for their variants.
    # shellcheck disable=SC2046 # one word each
    cargo build --quiet $(everything) --bins && lab lab-book book --check || return
    # Its snippets for readers of C compile and run.
    mdbook test book --chapter 'Rust for people who know OpenMP and MPI'
}

# Pages of `cargo lab movie`: of the first lab of soft discs, of hard discs, of ranks.
make_movies() { # make_movies FOLDER
    local lab
    for lab in $(labs_of discs soft | head -n 1) $(labs_of discs hard | head -n 1) $(labs_with ranks | head -n 1); do
        if labs_with ranks | grep -qx "$lab" && ! has_mpi; then
            leave_out "no MPI for 'cargo lab movie $lab'"
        else
            cargo lab movie "$lab" --solution -t 2 -o "$1/movie-of-lab$lab.html" >"$1/said" 2>&1 </dev/null ||
                { cat "$1/said"; return 1; }
        fi
    done
}
# Every page of the book that stage `book` built, and movies, as readers see them: two widths, two themes, what
# plays is played.
stage_pages() {
    local browser folder
    browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) ||
        { skip "no browser"; return; }
    have npm || { skip "no npm"; return; }
    [ -f book/build/index.html ] || { skip "no book built"; return; }
    node tests/pages/search.js || return
    (cd tests/pages && npm ci --no-audit --no-fund >/dev/null) || { skip "no playwright-core"; return; }
    folder=$(mktemp -d)
    make_movies "$folder" || return
    timeout 1500 node tests/pages/pages.js "$browser" "$folder"/*.html || return
    rm -rf "$folder"
}

# Every measuring command once, for a few seconds, on a small scene. A line: the lab that names it, and the command.
smoke_commands() {
    cargo lab facts | awk '$2 == "smoke" { $2 = ""; print }'
}

stage_smoke() {
    local lab command known
    known=$(cargo lab --help) || return
    while read -r lab command; do
        if ! grep -q "^  ${command%% *} " <<<"$known"; then
            leave_out "no 'cargo lab ${command%% *}' in this kit"
        elif [ "${command%% *}" = count ] && ! have valgrind; then
            leave_out "no valgrind for 'cargo lab $command'"
        elif labs_with ranks | grep -qx "$lab" && ! has_mpi; then
            leave_out "no MPI for 'cargo lab $command'"
        elif labs_with device | grep -qx "$lab" && ! has_vulkan; then
            leave_out "no Vulkan for 'cargo lab $command'"
        else
            echo "+ cargo lab $command"
            # shellcheck disable=SC2086 # one word each
            timeout 600 cargo lab $command >"$LOG.smoke" 2>&1 </dev/null && continue
            # A Vulkan loader without a driver behind it.
            if grep -q '^error: no adapter' "$LOG.smoke"; then
                leave_out "no adapter for 'cargo lab $command'"
            else
                cat "$LOG.smoke"
                return 1
            fi
        fi
    done < <(smoke_commands)
    run_example hard-discs greedy && run_example halo reported && run_example strips model --cost 200,30
}
# An example that computes numbers of the book, but for LAMMPS's, which is installed over the network.
run_example() { # run_example PACKAGE EXAMPLE OPTION…
    echo "+ cargo run --release -p $1 --example $2 -- ${*:3}"
    cargo run --quiet --release -p "$1" --example "$2" -- "${@:3}" >"$LOG.smoke" 2>&1 || { cat "$LOG.smoke"; return 1; }
}

passed=0 failed=0 skipped=0
LOG=$(mktemp)
trap 'rm -f "$LOG" "$LOG.editor" "$LOG.smoke" "$LOG.marks"' EXIT

run_stage() { # run_stage NAME NUMBER OF
    printf '[%d/%d] %-9s at %4d s\n' "$2" "$3" "$1" "$SECONDS"
    SKIPPED=
    local begun=$SECONDS
    if ! "stage_$1" 2>&1 | tee "$LOG"; then
        echo
        echo "FAILED: stage '$1', after $((SECONDS - begun)) s. To run it alone: scripts/test.sh $1"
        failed=$((failed + 1))
        return 1
    fi
    # `tee` runs the stage in a subshell, so what it said is what is known.
    grep -E '^(skipped|left out): ' "$LOG" | sort -u | sed 's/^/    /'
    if grep -q '^skipped: ' "$LOG"; then skipped=$((skipped + 1)); else passed=$((passed + 1)); fi
}

count_tests() {
    echo
    echo "$passed passed, $failed failed, $skipped skipped (stages, in $SECONDS s)"
}

case "${1:-}" in
    --list) printf '%s\n' "${STAGES[@]}" "${REST[@]}" "${BY_NAME[@]}" && exit ;;
    '') scripts/setup.sh && chosen=("${STAGES[@]}") || exit ;;
    --all) scripts/setup.sh --pages && chosen=("${STAGES[@]}" "${REST[@]}") || exit ;;
    *)
        chosen=("$@")
        for name in "${chosen[@]}"; do
            declare -F "stage_$name" >/dev/null || { echo "there is no stage '$name'" >&2; exit 2; }
        done
        ;;
esac

number=0
for name in "${chosen[@]}"; do
    number=$((number + 1))
    run_stage "$name" "$number" "${#chosen[@]}" || break
done
count_tests
[ "$failed" = 0 ]
