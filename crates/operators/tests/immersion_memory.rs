//! How much memory an immersion takes: at most three times its result, that included.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]
#![allow(unsafe_code, reason = "an allocator that counts is an allocator")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

use pforms_operators::immerse;
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

/// One test for all: a second thread would be counted too.
#[test]
fn an_immersion_takes_at_most_three_times_its_result() {
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
            let before = NOW.load(Ordering::Relaxed);
            MOST.store(before, Ordering::Relaxed);
            let result = immerse(&inner, &host).unwrap();
            let taken = MOST.load(Ordering::Relaxed) - before;
            let times = taken as f64 / result.bytes() as f64;
            println!("{} in {} ({weights:?}): {times:.2}", inner.kind(), host.kind());
            assert!(times <= 3.0, "{} in {}: {times} times", inner.kind(), host.kind());
        }
    }
}
