//! The works for JavaScript: `run.mjs` brings the clock.
#![expect(unsafe_code, reason = "names across the border of WebAssembly")]

use pforms_benches::works;

#[link(wasm_import_module = "clock")]
unsafe extern "C" {
    /// Seconds since some moment.
    safe fn now() -> f64;
}

/// Seconds of a call of a work; not a number when there is no such work.
#[unsafe(no_mangle)]
pub extern "C" fn seconds(number: u32, passes: u32) -> f64 {
    works::measure(number as usize, passes as usize, || now()).map_or(f64::NAN, |(time, _)| time)
}

/// The sum of what the work gives.
#[unsafe(no_mangle)]
pub extern "C" fn sum(number: u32) -> f64 {
    works::work(number as usize).map_or(f64::NAN, |mut work| work())
}
