#!/bin/bash
# The studio's engine: bindings/wasm compiled for the browser, with its JavaScript, into the folder given.
#   tools/wasm.sh studio/src/engine/wasm
set -euo pipefail
outdir=$1
module=$("$(dirname "$0")/wasm-compile.sh" --package pforms-wasm)/pforms_wasm.wasm

rm -rf "$outdir"
cargo run --locked --quiet --package xtask -- wasm "$module" "$outdir"
echo "wasm: $(stat --format=%s "$outdir"/pforms_wasm_bg.wasm) bytes in $outdir"
