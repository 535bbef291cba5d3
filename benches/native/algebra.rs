//! Exact operators on forms of `f64`.

use divan::{Bencher, black_box};
use pforms_benches::{inside_the_cube, rational};
use pforms_operators as operators;

fn main() {
    divan::main();
}

#[divan::bench(args = [4, 13, 31])]
fn elevate(bencher: Bencher, order: usize) {
    let form = rational(&[order, order]);
    bencher.bench(|| operators::elevate(black_box(&form), &[4, 4]));
}

#[divan::bench(args = [4, 14, 31])]
fn diagonal(bencher: Bencher, order: usize) {
    let form = rational(&[order, order]);
    bencher.bench(|| operators::diagonal(black_box(&form), 0, 1));
}

#[divan::bench(args = [1, 3])]
fn subdivide(bencher: Bencher, depth: u32) {
    let form = rational(&[4, 4]);
    bencher.bench(|| operators::subdivide(black_box(&form), &[depth; 2]));
}

/// A volume of the given order on each axis in a triquadratic host.
#[divan::bench(args = [2, 3])]
fn immerse(bencher: Bencher, order: usize) {
    let inner = inside_the_cube(&[order; 3]);
    let host = rational(&[3, 3, 3]);
    bencher.bench(|| operators::immerse(black_box(&inner), &host));
}
