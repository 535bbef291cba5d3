//! How much memory operators take: at most three times their result, that included.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]
#![allow(unsafe_code, reason = "an allocator that counts is an allocator")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

use pforms_operators::{immerse, split, subdivide};
use pforms_testkit::{Random, Weights};

/// The system's allocator, counting bytes in use and the most there have been.
struct Counting;

static NOW: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is passed on unchanged to the system's allocator, which keeps the contract.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let now = NOW.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        MOST.fetch_max(now, Ordering::Relaxed);
        // SAFETY: the caller's promises about `layout` are those that `System` asks for.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        NOW.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: `pointer` came from `System.alloc` with this `layout`, as the caller promises.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// The most bytes that were in use at a time while the work was done, beside those before.
fn most<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let before = NOW.load(Ordering::Relaxed);
    MOST.store(before, Ordering::Relaxed);
    let result = work();
    (result, (MOST.load(Ordering::Relaxed) - before) as f64)
}

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
            let (result, taken) = most(|| immerse(&inner, &host).unwrap());
            let times = taken / result.bytes() as f64;
            assert!(times <= 3.0, "{} in {}: {times} times", inner.kind(), host.kind());
        }
    }
    let long = Random::new(2).rough_form(&[300], 3, Weights::Positive);
    let (halves, taken) = most(|| split(&long, 0, &0.3).unwrap());
    assert!(taken <= 3.0 * (halves.0.bytes() + halves.1.bytes()) as f64);
    let (refined, taken) = most(|| subdivide(&long, &[2]).unwrap());
    assert!(taken <= 3.0 * refined.net().bytes() as f64);
}
