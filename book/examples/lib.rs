//! The Rust examples of the manual, one module for each page, for `cargo test` to run.

include!(concat!(env!("OUT_DIR"), "/examples.rs"));
