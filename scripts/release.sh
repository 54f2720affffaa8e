#!/bin/sh
# Writes what a release holds: the book, and a class's kit after each lab that is added to it.
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
# A folder there, as an archive, with an ending to its name.
pack() { tar -czf "$folder/$1${2:-}.tar.gz" -C "$trees" "$1" && echo "$folder/$1${2:-}.tar.gz"; }

cargo lab book
cp -R book/build "$trees/cutoff-book"
pack cutoff-book
for number in $(printf '%s\n' solutions/lab* | sed 's/.*lab//' | sort -n); do
    cargo lab handout "$number" --into "$trees/cutoff" >/dev/null
    pack cutoff "-lab$number"
done
