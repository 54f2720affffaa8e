#!/bin/bash
# Tests the whole kit, in stages. The first stage that fails ends the run, and the script prints its name.
#
#   scripts/test.sh           set up, then test each lab, each package and the book, within some ten minutes
#   scripts/test.sh --all     the same and the other stages, for most of an hour: lints, what an editor reports, what
#                             students get, known-wrong solutions, marks, the book's pages in a browser, measuring
#                             commands
#   scripts/test.sh --list    print the names of all stages, those of --all last
#   scripts/test.sh NAME…     run only these stages
#
# Where this machine cannot run a stage, the stage says so («skipped: no mdBook»); where it cannot run a part of a
# stage, the stage says «left out: no MPI». A test program that has passed is not run again within half a day, unless
# a file that it reads changes; `rm target/debug/deps/*.passed` makes all test programs run again. The last line says
# how many stages passed.
set -uo pipefail
cd "$(dirname "$0")/.."

STAGES=(format tests doctests starters figures book)
REST=(lint deny editor handout proof marks pages smoke)
# Stages that run only by name: `gradescope` after a change of scripts/gradescope, for it builds the kit once more.
BY_NAME=(gradescope)

# Does this machine have the program, an MPI library, a Vulkan loader?
have() { command -v "$1" >/dev/null 2>&1; }
has_mpi() { have "${MPICC:-mpicc}" && have mpiexec; }
has_vulkan() { [ "$(uname)" = Darwin ] || ldconfig -p 2>/dev/null | grep 'libvulkan\.so' >/dev/null; }

# The numbers of the labs whose lab.toml says `workers = "$1"` (threads, ranks or device).
labs_with() { labs_of workers "$1"; }
labs_of() { # FACT VALUE
    grep -lx "$1 = \"$2\"" solutions/lab*/lab.toml | sort -V | sed 's/[^0-9]*\([0-9]*\).*/\1/'
}
# The arguments by which cargo builds all packages that this machine can build, without the starters (labs/labN), whose
# tests fail by design. Every stage names the same packages: cargo chooses the features of a dependency by the packages
# that are named, and for other packages it would compile much once more.
everything() {
    echo --workspace
    { labs_with threads; labs_with ranks; labs_with device; } | sed 's/^/--exclude lab/'
    has_mpi || { echo '--exclude common-mpi --exclude mpi-sys --exclude oracle-mpi --exclude halo --exclude hard-disc-ranks --exclude strips'; labs_with ranks | sed 's/^/--exclude solution/'; }
    has_vulkan || { echo '--exclude device --exclude device-discs'; labs_with device | sed 's/^/--exclude solution/'; }
}
# Says what `everything` leaves out on this machine.
name_left_out() {
    has_mpi || leave_out "no MPI"
    has_vulkan || leave_out "no Vulkan"
}
# Runs a command of the kit from the same build as the tests; `cargo lab` would build its package separately.
lab() { build "$1" && "$(built "$1")" "${@:2}"; } # lab PACKAGE COMMAND…
# It names a test as well: without a test, cargo chooses other features of dependencies.
# shellcheck disable=SC2046 # one word each
build() { cargo build --quiet $(everything) --bin "$1" --test lab1; }
built() { realpath "${CARGO_TARGET_DIR:-target}/debug/$1"; }

skip() { echo "skipped: $*"; SKIPPED=1; }
# Says that this machine cannot run a part of a stage; the other parts decide whether the stage passes.
leave_out() { echo "left out: $*"; }

stage_format() {
    cargo fmt --all --check && rustfmt --edition 2024 --check tests/lab*.rs tests/lab*/*.rs
}

# shellcheck disable=SC2046
stage_lint() {
    name_left_out
    cargo clippy --all-targets $(everything) -- -D warnings
}

# Compares the licences, versions and sources of all dependencies with deny.toml, and looks for advisories where they can
# be loaded.
stage_deny() {
    have cargo-deny || { skip "no cargo-deny"; return; }
    cargo deny check bans licenses sources || return
    cargo deny fetch db || { leave_out "no database of advisories"; return; }
    cargo deny check advisories
}

# On a machine with only Rust, neither cargo nor an editor reports an error in any lab. The build has its own folder: in
# the usual one a build script may have found an MPI library, and cargo would not run that script again.
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

# A class's kit with labs 1 and 2 builds by itself, lab 2 fails at its first `todo!`, and its book can be made. The
# build folder is kept, so that the next run compiles no dependency again.
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

full_marks() { # full_marks LAB FOLDER
    local times=--no-timing
    # A contest needs times.
    has_contest "$1" && times=
    # shellcheck disable=SC2086 # one word or none
    cargo lab grade solutions --lab "$1" $times --into "$2" >"$LOG.marks" 2>&1
}
has_contest() { labs_of contest yes | grep -qx "$1"; } # has_contest LAB
ranked() { ! has_contest "$1" || grep -q '"leaderboard": \[$' "$2/gradescope/solutions.json"; } # ranked LAB FOLDER
# Each solution gets full marks when it is graded as a submission, and an entry of a contest is ranked.
stage_marks() {
    local folder lab labs
    labs=$(labs_with threads)
    has_mpi && labs+=" $(labs_with ranks)"
    has_vulkan && labs+=" $(labs_with device)"
    folder=$(mktemp -d)
    for lab in $labs; do
        full_marks "$lab" "$folder/$lab"
        # Open MPI 4.1 crashes at the end of about one job in a hundred, after the program has answered.
        grep -q 'exited on signal' "$LOG.marks" && full_marks "$lab" "$folder/$lab-again"
        if grep -Eo '^solutions +100 of [0-9.]+( |$)' "$LOG.marks" | sed "s/^solutions */lab $lab: /"; then
            ranked "$lab" "$folder/$lab" && continue
            echo "the entry of lab $lab is not ranked"
            return 1
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

# Does in a fresh folder what Gradescope does: making the image grades the solution, and then grading the solution as a
# submission compiles no package of the kit. Where no sandbox can be made, a submission cannot read the solution.
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
    # The check runs the programs of all solutions to ask for their variants.
    # shellcheck disable=SC2046 # one word each
    cargo build --quiet $(everything) --bins && lab lab-book book --check || return
    # The chapter's Rust snippets compile and run.
    mdbook test book --chapter 'Rust for people who know OpenMP and MPI'
}

# Makes pages by `cargo lab movie` for the first lab with soft discs, the first with hard discs and the first with ranks.
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
# Opens every page of the book that stage `book` built, and some movies, in a browser, at two widths and in two themes,
# and plays every animation.
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

# Prints a line for each measuring command that a lab.toml names under `smoke`: the lab, and the command with a small
# scene, which takes a few seconds.
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
            # There is a Vulkan loader without a driver.
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
# Runs an example that computes numbers of the book. The example with LAMMPS is not run: it needs a network.
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
    # Because of `tee` the stage ran in a subshell, whose variables are lost; its output says what it skipped.
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
