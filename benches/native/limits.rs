//! What the machine can do at most, with one thread and with two: JSON for `benches/machine.py`.
//!
//! Stores count the bytes a program writes: again into the same 24 MB (the size of a million points),
//! into memory beyond the caches, around the caches (non-temporal), and into memory just obtained from
//! the system, whose pages are only made at the first store. Arithmetic counts a fused multiplication
//! and addition as two operations; `multiply_add` is the same with two instructions, as pforms computes.
#![expect(unsafe_code, reason = "stores around the caches are no part of the language")]
#![expect(clippy::inline_always, reason = "only what is inlined is compiled for wider vectors")]

use std::hint::black_box;
use std::sync::Barrier;
use std::time::Instant;

use pulp::{Arch, Simd, WithSimd};

const MB: usize = 1 << 20;
const PASSES: usize = 24;

fn main() {
    let rates: Vec<String> =
        [1, 2].map(|threads| format!("\"{threads}\": {}", limits(threads))).into();
    println!("{{{}}}", rates.join(", "));
}

/// The rates of all threads together, as a JSON object.
fn limits(threads: usize) -> String {
    let kinds: [(&str, &(dyn Fn() -> Job + Sync)); 6] = [
        ("stores_again", &|| stores(24 * MB, store)),
        ("stores", &|| stores(256 * MB, store)),
        ("stores_around_caches", &|| stores(256 * MB, stream)),
        ("stores_fresh", &|| Box::new(fresh)),
        ("multiply_add", &arithmetic::<false>),
        ("fused_multiply_add", &arithmetic::<true>),
    ];
    let rates: Vec<String> =
        kinds.map(|(name, job)| format!("\"{name}\": {:.4e}", rate(threads, job))).into();
    format!("{{{}}}", rates.join(", "))
}

/// Work that says how much it did.
type Job = Box<dyn FnMut() -> usize>;

/// Sum of the best rates of threads that start every pass together. Other load only lowers a rate.
fn rate(threads: usize, prepare: &(dyn Fn() -> Job + Sync)) -> f64 {
    let barrier = Barrier::new(threads);
    let best = || {
        let mut job = prepare();
        let pass = |_| {
            barrier.wait();
            let started = Instant::now();
            let amount = job();
            amount as f64 / started.elapsed().as_secs_f64()
        };
        (0..PASSES).map(pass).fold(0.0, f64::max)
    };
    std::thread::scope(|scope| {
        let running: Vec<_> = (0..threads).map(|_| scope.spawn(best)).collect();
        running.into_iter().filter_map(|thread| thread.join().ok()).sum()
    })
}

/// Writes the same memory at every pass; the first pass makes its pages.
fn stores(bytes: usize, write: fn(&mut [f64])) -> Job {
    let mut memory = vec![1.0; bytes / 8];
    Box::new(move || {
        let repeats = (256 * MB / bytes).max(1);
        (0..repeats).for_each(|_| write(black_box(&mut memory)));
        repeats * bytes
    })
}

/// Writes memory that the system has just given, larger than what an allocator keeps for itself.
fn fresh() -> usize {
    let mut memory: Vec<f64> = Vec::with_capacity(64 * MB / 8);
    let room = memory.spare_capacity_mut();
    room.fill(std::mem::MaybeUninit::new(1.0));
    black_box(room);
    64 * MB
}

fn arithmetic<const FUSED: bool>() -> Job {
    Box::new(|| Arch::new().dispatch(Arithmetic::<FUSED> { rounds: 4_000_000 }))
}

/// Sums that do not wait for one another: as many as hide the time until a sum is ready.
const SUMS: usize = 16;

/// Multiplications and additions in registers, for so many rounds.
struct Arithmetic<const FUSED: bool> {
    rounds: usize,
}

impl<const FUSED: bool> WithSimd for Arithmetic<FUSED> {
    type Output = usize;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> usize {
        let factor = simd.splat_f64s(black_box(0.75));
        let term = simd.splat_f64s(black_box(0.125));
        let mut sums = [term; SUMS];
        for _ in 0..self.rounds {
            for sum in &mut sums {
                *sum = if FUSED {
                    simd.mul_add_f64s(*sum, factor, term)
                } else {
                    simd.add_f64s(simd.mul_f64s(*sum, factor), term)
                };
            }
        }
        black_box(sums);
        2 * SUMS * S::F64_LANES * self.rounds
    }
}

/// Ordinary stores of whole registers.
struct Store<'a>(&'a mut [f64]);

impl WithSimd for Store<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let ones = simd.splat_f64s(black_box(1.0));
        let (registers, _) = S::as_mut_simd_f64s(self.0);
        registers.fill(ones);
    }
}

fn store(memory: &mut [f64]) {
    Arch::new().dispatch(Store(memory));
}

/// Stores that pass by the caches.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "sse2")]
fn stream_pairs(memory: &mut [f64]) {
    use std::arch::x86_64::{_mm_set1_pd, _mm_sfence, _mm_stream_pd};

    let skipped = memory.as_ptr().align_offset(64);
    for pair in memory[skipped..].chunks_exact_mut(2) {
        // SAFETY: `pair` is writable, two numbers long, and aligned to 16 bytes, since it starts an even
        // number of numbers after an address aligned to 64.
        unsafe { _mm_stream_pd(pair.as_mut_ptr(), _mm_set1_pd(1.0)) };
    }
    _mm_sfence();
}

#[cfg(target_arch = "x86_64")]
fn stream(memory: &mut [f64]) {
    // SAFETY: SSE2 belongs to every x86-64.
    unsafe { stream_pairs(memory) };
}

#[cfg(not(target_arch = "x86_64"))]
fn stream(memory: &mut [f64]) {
    store(memory);
}
