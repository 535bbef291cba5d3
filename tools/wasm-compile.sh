#!/bin/bash
# Compiles for WebAssembly what cargo's options name, and prints the folder where it lies.
#   tools/wasm-compile.sh --package pforms-wasm
#
# Rust's standard library for WebAssembly comes from, in this order: the toolchain, where it is there
# already; rustup, within a time limit, since it can be out of reach; Debian's source of the library,
# built here by Debian's compiler of the same version.
set -euo pipefail
target=wasm32-unknown-unknown
patience=${RUSTUP_PATIENCE:-180}   # seconds

say() {
    echo "wasm: $*" >&2
}

has_library() {
    compgen -G "$(rustc --print target-libdir --target "$target")/libstd-*.rlib" >/dev/null
}

compile() {
    cargo build --locked --profile wasm --target "$target" "$@" >&2
}

compile_with_debian() {
    "$(dirname "$0")/packages.sh" rustc-web rust-web-src >&2
    local host linker
    host=$(rustc --version --verbose | sed -n 's/^host: //p')
    linker=$(rustc --print sysroot)/lib/rustlib/$host/bin/rust-lld
    RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker \
        compile --target-dir target/wasm-debian -Z build-std=std,panic_abort "$@"
}

if has_library; then
    say "the toolchain's own library"
elif command -v rustup >/dev/null; then
    say "asking rustup for $target, at most $patience s"
    timeout --kill-after=10 "$patience" rustup target add "$target" >&2 \
        || say "rustup did not answer in time"
fi

if has_library; then
    compile "$@"
    echo "target/$target/wasm"
else
    say "Debian's library, built from source"
    compile_with_debian "$@"
    echo "target/wasm-debian/$target/wasm"
fi
