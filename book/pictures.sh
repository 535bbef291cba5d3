#!/bin/sh
# Draws the pictures of the manual again: for each images/NAME.png that a page shows, the sheet
# cases/sheets/NAME.pfs, by the command line and POV-Ray.
set -eu
cd "$(dirname "$0")/.."
images=book/src/operators/images
scene=$(mktemp -d)
trap 'rm -r "$scene"' EXIT
mkdir -p "$images"
grep -rhoE 'images/[a-z0-9_]+\.png' book/src README.md | sort -u | while read -r picture; do
    name=$(basename "$picture" .png)
    cargo run --quiet --package pforms -- draw "cases/sheets/$name.pfs" --output "$scene/$name.pov"
    povray "+I$scene/$name.pov" "+O$images/$name.png" +W480 +H480 +A0.1 +J0 -D >"$scene/log" 2>&1 ||
        { cat "$scene/log"; exit 1; }
done
