#!/bin/sh
# Run once by Gradescope, as root, when it makes the image: a compiler, a sandbox if the container
# lets it work, and the grader.
set -eu
kit=$(dirname "$0")/kit
apt-get update
DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
    build-essential ca-certificates curl bubblewrap util-linux
if ! command -v cargo >/dev/null 2>&1; then
    curl --proto '=https' --tlsv1.2 -sSf https://sh.rustup.rs | sh -s -- -y --profile minimal
    . "$HOME/.cargo/env"
fi
cd "$kit"
# rust-toolchain.toml says which compiler; submissions are built without a network.
cargo fetch --locked
cargo build --release --locked --package lab --package lab-grading
