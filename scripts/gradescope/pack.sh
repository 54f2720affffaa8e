#!/bin/sh
# Packs an autograder for Gradescope: the committed files of the kit, and the two scripts that Gradescope runs.
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
refuse() {
    echo "$*" >&2
    exit 2
}
if ! git cat-file -e "HEAD:solutions/lab$lab/lab.toml" 2>/dev/null; then
    refuse "no lab $lab is committed in this kit, and only committed files are packed"
fi
changed=$(git status --porcelain --untracked-files=no)
if [ -n "$changed" ]; then
    refuse "only committed files are packed; commit these or take them back:
$changed"
fi
git archive --format=zip --output="$file" \
    --prefix= --add-file=scripts/gradescope/setup.sh --add-file=scripts/gradescope/run_autograder \
    --add-virtual-file="lab:$lab" --prefix=kit/ HEAD
echo "$file grades lab $lab, if the solution gets 100 points when Gradescope builds the image"
