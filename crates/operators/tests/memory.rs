//! How much memory operators take: at most three times their result, that included.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_operators::{immerse, split, subdivide};
use pforms_testkit::memory::{Counting, taken};
use pforms_testkit::{Random, Weights};

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// One test for all: a second thread would be counted too.
#[test]
fn an_operator_takes_at_most_three_times_its_result() {
    let cases: [(&[usize], &[usize]); 7] = [
        (&[3, 3, 3], &[4, 4, 4]),
        (&[2, 2, 2], &[7, 7, 7]),
        (&[4, 4], &[6, 6]),
        (&[4, 4], &[12]),
        (&[3, 3, 3], &[2, 8]),
        (&[4, 4], &[4, 4, 4]),
        (&[4, 4], &[4, 5, 4]),
    ];
    for (inner, host) in cases {
        for weights in [Weights::One, Weights::Positive] {
            let mut random = Random::new(1);
            let inner = random.rough_form(inner, host.len(), weights);
            let host = random.rough_form(host, 3, weights);
            let (result, bytes) = taken(|| immerse(&inner, &host).unwrap());
            let times = bytes as f64 / result.bytes() as f64;
            assert!(times <= 3.0, "{} in {}: {times} times", inner.kind(), host.kind());
        }
    }
    let long = Random::new(2).rough_form(&[300], 3, Weights::Positive);
    let (halves, bytes) = taken(|| split(&long, 0, &0.3).unwrap());
    assert!(bytes <= 3 * (halves.0.bytes() + halves.1.bytes()));
    let (refined, bytes) = taken(|| subdivide(&long, &[2]).unwrap());
    assert!(bytes <= 3 * refined.net().bytes());
}
