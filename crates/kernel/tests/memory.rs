//! How much memory evaluation takes beside its result: at most a megabyte.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::grids_into;
use pforms_testkit::memory::{Counting, taken};
use pforms_testkit::{Random, Weights};

#[global_allocator]
static ALLOCATOR: Counting = Counting;

const MEGABYTE: usize = 1 << 20;

/// One test for all: a second thread would be counted too.
#[test]
fn points_take_a_megabyte_beside_themselves() {
    for (orders, count) in [(vec![4, 4], 400), (vec![31], 200_000), (vec![8, 8, 8], 40)] {
        for weights in [Weights::One, Weights::Positive] {
            let form = Random::new(2).rough_form(&orders, 3, weights);
            let list: Vec<f64> = (0..count).map(|k| f64::from(k) / f64::from(count - 1)).collect();
            let lists = vec![&list[..]; orders.len()];
            let mut out = vec![0.0; 3 * list.len().pow(orders.len() as u32)];
            let (done, grid) = taken(|| form.grid_into(&lists, &mut out));
            done.unwrap();
            let (done, scattered) =
                taken(|| form.scattered_into(&lists, &mut out[..3 * list.len()]));
            done.unwrap();
            println!("{} ({weights:?}): {grid} and {scattered} bytes", form.kind());
            assert!(
                grid < MEGABYTE && scattered < MEGABYTE,
                "{}: {grid}, {scattered}",
                form.kind()
            );
        }
    }
    let forms: Vec<_> =
        (0..300).map(|k| Random::new(k).rough_form(&[4, 4], 3, Weights::Positive)).collect();
    let forms: Vec<_> = forms.iter().collect();
    let ticks: Vec<f64> = (0..17).map(|k| f64::from(k) / 16.0).collect();
    let mut out = vec![0.0; 300 * 17 * 17 * 3];
    let (done, bytes) = taken(|| grids_into(&forms, &[&ticks, &ticks], &mut out));
    done.unwrap();
    assert!(bytes < MEGABYTE, "300 patches: {bytes}");
}
