#!/bin/bash
# The peers' own environment, in the folder given; nothing outside it is touched.
#   benches/setup.sh .tools/bench
#
# What cannot be had is left out with a message. SISL is Debian's libsisl-dev, if it is there (its
# licence is the AGPL: the library built here stays on this machine).
set -euo pipefail
here=$(dirname "$0")
folder=$1

[ -x "$folder/bin/python" ] || python3 -m venv "$folder"
grep -v '^#' "$here/requirements.txt" | while read -r package; do
    "$folder/bin/pip" install --quiet "$package" || echo "bench: without $package" >&2
done

# Debian's archive is not position-independent, and its error printer cannot be linked: the shim has its own.
cc -O3 -march=native -shared -fPIC -Wl,-Bsymbolic -Wl,-z,notext \
    "$here/peers/sisl.c" -o "$folder/lib/libsisl_shim.so" -lsisl -lm 2>/dev/null \
    || echo "bench: without SISL (apt-get install libsisl-dev)" >&2
