#!/bin/bash
# The studio's engine: bindings/wasm compiled for the browser, with its JavaScript, into the folder given.
#   tools/wasm.sh studio/src/engine/wasm
#
# Rust's standard library for WebAssembly comes from, in this order: the toolchain, where it is there
# already; rustup, within a time limit, since it can be out of reach; Debian's source of the library,
# built here by Debian's compiler of the same version.
set -euo pipefail
outdir=$1
target=wasm32-unknown-unknown
patience=${RUSTUP_PATIENCE:-180}   # seconds

has_library() {
    compgen -G "$(rustc --print target-libdir --target "$target")/libstd-*.rlib" >/dev/null
}

compile() {
    cargo build --locked --profile wasm --package pforms-wasm --target "$target" "$@"
}

compile_with_debian() {
    "$(dirname "$0")/packages.sh" rustc-web rust-web-src
    local host linker
    host=$(rustc --version --verbose | sed -n 's/^host: //p')
    linker=$(rustc --print sysroot)/lib/rustlib/$host/bin/rust-lld
    RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker \
        compile --target-dir target/wasm-debian -Z build-std=std,panic_abort
}

if has_library; then
    echo "wasm: the toolchain's own library"
elif command -v rustup >/dev/null; then
    echo "wasm: asking rustup for $target, at most $patience s"
    timeout --kill-after=10 "$patience" rustup target add "$target" \
        || echo "wasm: rustup did not answer in time"
fi

if has_library; then
    compile
    module=target/$target/wasm/pforms_wasm.wasm
else
    echo "wasm: Debian's library, built from source"
    compile_with_debian
    module=target/wasm-debian/$target/wasm/pforms_wasm.wasm
fi

rm -rf "$outdir"
cargo run --locked --quiet --package xtask -- wasm "$module" "$outdir"
echo "wasm: $(stat --format=%s "$outdir"/pforms_wasm_bg.wasm) bytes in $outdir"
