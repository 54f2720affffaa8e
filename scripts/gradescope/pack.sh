#!/bin/sh
# Packs an autograder for Gradescope: the kit as it was committed, and how to run it.
#
#   scripts/gradescope/pack.sh LAB FILE.zip
set -eu
if [ $# -ne 2 ]; then
    echo "usage: scripts/gradescope/pack.sh LAB FILE.zip" >&2
    exit 2
fi
lab=$1
case "$2" in
    /*) file=$2 ;;
    *) file=$PWD/$2 ;;
esac
cd "$(dirname "$0")/../.."
if [ ! -f "solutions/lab$lab/lab.toml" ]; then
    echo "there is no lab $lab in this kit" >&2
    exit 2
fi
git archive --format=zip --output="$file" \
    --prefix= --add-file=scripts/gradescope/setup.sh --add-file=scripts/gradescope/run_autograder \
    --add-virtual-file="lab:$lab" --prefix=kit/ HEAD
echo "$file grades lab $lab"
