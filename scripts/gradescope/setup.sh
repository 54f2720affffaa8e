#!/bin/sh
# Gradescope runs this script once, as root, when it makes the image. It installs a compiler, what the lab's workers
# need and bubblewrap for a sandbox, and it builds the grader. It fails if the kit's solution does not get full marks in
# this image.
set -eu
source=$(cd "$(dirname "$0")" && pwd)
apt-get update
DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
    build-essential ca-certificates curl bubblewrap util-linux
# The compiler lies where run_autograder and users other than root find it too.
export RUSTUP_HOME=/opt/rustup CARGO_HOME=/opt/cargo PATH="/opt/cargo/bin:$PATH"
if [ ! -x /opt/cargo/bin/cargo ]; then
    curl --proto '=https' --tlsv1.2 -sSf https://sh.rustup.rs | sh -s -- -y --profile minimal --no-modify-path
fi
cd "$source/kit"
# This also installs the compiler that rust-toolchain.toml names. Submissions are built without a network.
cargo fetch --locked
lab=$(cat "$source/lab")
scripts/setup.sh --for "$(cargo lab facts | awk -v lab="$lab" '$1 == lab && $2 == "workers" { print $3 }')"

# Grading the solution compiles all packages that grading a submission needs.
prime=$(mktemp -d)
trap 'rm -rf "$prime"' EXIT
ln -s "$source" "$prime/source"
LIMIT=3600 AUTOGRADER=$prime sh "$source/run_autograder" "$source/kit/solutions"
if ! grep -q '^  "score": 100' "$prime/results/results.json"; then
    cat "$prime/results/results.json"
    echo "The solution of lab $lab does not get full marks in this image." >&2
    exit 1
fi
