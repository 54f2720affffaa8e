#!/bin/sh
# Writes what a release holds: the book, and for each lab the kit that its students get.
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
# A folder there, as an archive.
pack() { tar -czf "$folder/$1.tar.gz" -C "$trees" "$1" && echo "$folder/$1.tar.gz"; }

cargo lab book
cp -R book/build "$trees/cutoff-book"
pack cutoff-book
for lab in solutions/lab*; do
    number=${lab#solutions/lab}
    cargo lab handout "$number" --into "$trees/cutoff-lab$number" >/dev/null
    pack "cutoff-lab$number"
done
