//! Points of a rational bicubic surface: on a grid, and scattered.

use divan::Bencher;
use divan::counter::ItemsCount;
use pforms_benches::{parameters, rational};

fn main() {
    divan::main();
}

#[divan::bench(args = [32, 400])]
fn grid(bencher: Bencher, side: usize) {
    let form = rational(&[4, 4]);
    let at = parameters(side);
    let mut out = vec![0.0; side * side * 3];
    bencher
        .counter(ItemsCount::new(side * side))
        .bench_local(|| form.grid_into(&[&at, &at], divan::black_box(&mut out)));
}

#[divan::bench(args = [1_000, 100_000])]
fn scattered(bencher: Bencher, count: usize) {
    let form = rational(&[4, 4]);
    let u = parameters(count);
    let v: Vec<f64> = u.iter().map(|u| u * u).collect();
    let mut out = vec![0.0; count * 3];
    bencher
        .counter(ItemsCount::new(count))
        .bench_local(|| form.scattered_into(&[&u, &v], divan::black_box(&mut out)));
}
