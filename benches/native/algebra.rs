//! Exact operators: how long one call takes.

use divan::{Bencher, black_box};
use pforms_benches::{Kind, form, inside};
use pforms_kernel::threads;
use pforms_operators as operators;

fn main() {
    threads::limit(1);
    divan::main();
}

const SWEEP: [Kind; 12] = Kind::sweep([(1, 4), (1, 14), (2, 4), (2, 13), (2, 31), (3, 4)]);
const SURFACES: [Kind; 6] = Kind::sweep([(2, 4), (2, 14), (2, 31)]);

#[divan::bench(args = SWEEP)]
fn elevate(bencher: Bencher, kind: Kind) {
    let (form, by) = (kind.form(), vec![4; kind.axes]);
    bencher.bench(|| operators::elevate(black_box(&form), &by));
}

/// Halved once along each axis: four quarters of a surface.
#[divan::bench(args = SWEEP)]
fn subdivide(bencher: Bencher, kind: Kind) {
    let (form, levels) = (kind.form(), vec![1; kind.axes]);
    bencher.bench(|| operators::subdivide(black_box(&form), &levels));
}

#[divan::bench(args = SWEEP)]
fn split(bencher: Bencher, kind: Kind) {
    let form = kind.form();
    bencher.bench(|| operators::split(black_box(&form), 0, &0.5));
}

#[divan::bench(args = SWEEP)]
fn stretch(bencher: Bencher, kind: Kind) {
    let (form, from, to) = (kind.form(), vec![0.25; kind.axes], vec![0.875; kind.axes]);
    bencher.bench(|| operators::stretch(black_box(&form), &from, &to));
}

#[divan::bench(args = SURFACES)]
fn diagonal(bencher: Bencher, kind: Kind) {
    let form = kind.form();
    bencher.bench(|| operators::diagonal(black_box(&form), 0, 1));
}

const INNERS: [Kind; 10] = Kind::sweep([(1, 4), (2, 2), (2, 4), (3, 2), (3, 4)]);

/// In a bicubic surface.
#[divan::bench(args = &INNERS[..4])]
fn immerse_in_surface(bencher: Bencher, kind: &Kind) {
    immerse(bencher, *kind, &[4, 4]);
}

/// In a trilinear volume.
#[divan::bench(args = &INNERS[4..6])]
fn immerse_in_facet(bencher: Bencher, kind: &Kind) {
    immerse(bencher, *kind, &[2, 2, 2]);
}

/// In a triquadratic volume.
#[divan::bench(args = &INNERS[6..8])]
fn immerse_in_cage(bencher: Bencher, kind: &Kind) {
    immerse(bencher, *kind, &[3, 3, 3]);
}

/// In a tricubic volume: of degree 27 along each axis.
#[divan::bench(args = &INNERS[8..])]
fn immerse_in_volume(bencher: Bencher, kind: &Kind) {
    immerse(bencher, *kind, &[4, 4, 4]);
}

fn immerse(bencher: Bencher, kind: Kind, host_orders: &[usize]) {
    let inner = inside(host_orders.len(), &vec![kind.order; kind.axes], kind.rational);
    let host = form(host_orders, kind.rational);
    bencher.bench(|| operators::immerse(black_box(&inner), &host));
}
