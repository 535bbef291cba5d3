//! Forms from data.

use divan::{Bencher, black_box};
use pforms_benches::Kind;
use pforms_operators::{self as operators, Nodes};

fn main() {
    divan::main();
}

const SWEEP: [Kind; 12] = Kind::sweep([(1, 4), (1, 15), (1, 40), (2, 4), (2, 14), (2, 30)]);

#[divan::bench(args = SWEEP)]
fn interpolate(bencher: Bencher, kind: Kind) {
    let net = kind.form();
    bencher.bench(|| operators::interpolate(black_box(&net), &Nodes::Uniform));
}
