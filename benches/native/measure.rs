//! Prints the seconds of a work, natively, and the sum of its results.
//!
//!     measure NUMBER PASSES

use std::time::Instant;

use pforms_benches::works;

fn main() {
    let numbers: Vec<usize> =
        std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let started = Instant::now();
    let measured = match numbers[..] {
        [number, passes] => works::measure(number, passes, || started.elapsed().as_secs_f64()),
        _ => None,
    };
    match measured {
        Some((seconds, sum)) => println!("{seconds:e} {sum:e}"),
        None => eprintln!("usage: measure NUMBER PASSES"),
    }
}
