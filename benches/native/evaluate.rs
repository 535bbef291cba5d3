//! Points of forms on one thread: on grids, scattered, with normals, and of many patches at once.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use pforms_benches::{Kind, form, parameters, scattered as scattered_parameters};
use pforms_kernel::{Form, grids_into, threads};
use pforms_operators as operators;

fn main() {
    threads::limit(1);
    divan::main();
}

/// Axes and orders, each polynomial and rational.
const SWEEP: [Kind; 16] =
    Kind::sweep([(1, 4), (1, 14), (2, 2), (2, 4), (2, 8), (2, 14), (3, 2), (3, 4)]);
const SURFACES: [Kind; 6] = Kind::sweep([(2, 2), (2, 4), (2, 8)]);

/// About 10,000 points, whose results stay in the cache.
#[divan::bench(args = SWEEP)]
fn grid(bencher: Bencher, kind: Kind) {
    let form = kind.form();
    let side = [10_000, 100, 22][kind.axes - 1];
    let at = parameters(side);
    let lists = vec![&at[..]; kind.axes];
    let count = side.pow(kind.axes as u32);
    let mut out = vec![0.0; count * 3];
    bencher
        .counter(ItemsCount::new(count))
        .bench_local(|| form.grid_into(&lists, black_box(&mut out)));
}

/// A million points: the results are as large as caches are.
#[divan::bench(args = [false, true])]
fn large_grid(bencher: Bencher, rational: bool) {
    let form = form(&[4, 4], rational);
    let at = parameters(1000);
    let mut out = vec![0.0; 3_000_000];
    bencher
        .counter(ItemsCount::new(1_000_000_usize))
        .bench_local(|| form.grid_into(&[&at, &at], black_box(&mut out)));
}

#[divan::bench(args = SWEEP)]
fn scattered(bencher: Bencher, kind: Kind) {
    let form = kind.form();
    let lists = scattered_parameters(kind.axes, 10_000);
    let at: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
    let mut out = vec![0.0; 30_000];
    bencher
        .counter(ItemsCount::new(10_000_usize))
        .bench_local(|| form.scattered_into(&at, black_box(&mut out)));
}

#[divan::bench(args = SURFACES)]
fn normals(bencher: Bencher, kind: Kind) {
    let form = kind.form();
    let at = parameters(100);
    let mut out = vec![0.0; 30_000];
    bencher
        .counter(ItemsCount::new(10_000_usize))
        .bench_local(|| operators::normal_grid_into(&form, &[&at, &at], black_box(&mut out)));
}

/// Patches on 17 × 17 points each.
#[divan::bench(args = SURFACES)]
fn patches(bencher: Bencher, kind: Kind) {
    let forms: Vec<Form> = (0..100).map(|_| kind.form()).collect();
    let family: Vec<&Form> = forms.iter().collect();
    let at = parameters(17);
    let count = forms.len() * at.len() * at.len();
    let mut out = vec![0.0; count * 3];
    bencher
        .counter(ItemsCount::new(count))
        .bench_local(|| grids_into(&family, &[&at, &at], black_box(&mut out)));
}
