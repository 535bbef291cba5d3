//! Forms from data.

use divan::{Bencher, black_box};
use pforms_benches::rational;
use pforms_operators::{self as operators, Nodes};

fn main() {
    divan::main();
}

#[divan::bench(args = [4, 8, 14])]
fn interpolate(bencher: Bencher, order: usize) {
    let net = rational(&[order, order]);
    bencher.bench(|| operators::interpolate(black_box(&net), &Nodes::Uniform));
}
