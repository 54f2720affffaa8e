#!/bin/sh
# Writes the archives of a release: the book with the documentation of the libraries, and for each lab a class's kit
# with this lab and all labs before it.
#
#   scripts/release.sh FOLDER
set -eu
if [ $# -ne 1 ]; then
    echo "usage: scripts/release.sh FOLDER" >&2
    exit 2
fi
mkdir -p "$1"
folder=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."

trees=$(mktemp -d)
trap 'rm -rf "$trees"' EXIT
# Packs the folder $trees/$1 as the archive $1$2.tar.gz, and prints the name of the archive.
pack() { tar -czf "$folder/$1${2:-}.tar.gz" -C "$trees" "$1" && echo "$folder/$1${2:-}.tar.gz"; }

cargo lab book
# The documentation of the libraries that the labs call is published beside the book, in its folder doc.
documentation=${CARGO_TARGET_DIR:-target}/doc
rm -rf "$documentation"
cargo doc --quiet --no-deps --workspace --exclude 'lab*' --exclude 'solution*' \
    --exclude exam --exclude live --exclude steps
cp -R "$documentation" book/build/doc
cp -R book/build "$trees/cutoff-book"
pack cutoff-book
for number in $(printf '%s\n' solutions/lab* | sed 's/.*lab//' | sort -n); do
    cargo lab handout "$number" --into "$trees/cutoff" >/dev/null
    pack cutoff "-lab$number"
done
