//! How far a polynomial patch of revolution leaves the surface that it stands for.

/// Samples before the largest one is refined: the functions asked about have a handful of extremes.
const SAMPLES: usize = 512;

/// Steps of the golden section: 0.618⁴⁰ of a sample's width, past the last bit of a flat top.
const STEPS: usize = 40;

/// The largest value of a smooth function on [0, 1], to rounding.
pub(super) fn largest(f: impl Fn(f64) -> f64) -> f64 {
    let at = |i: usize| f(i as f64 / SAMPLES as f64);
    let (mut best, mut highest) = (0, at(0));
    for i in 1..=SAMPLES {
        let value = at(i);
        if value > highest {
            (best, highest) = (i, value);
        }
    }
    let (low, high) = (best.saturating_sub(1), (best + 1).min(SAMPLES));
    let refined = golden(&f, low as f64 / SAMPLES as f64, high as f64 / SAMPLES as f64);
    highest.max(refined)
}

/// The top of a function with one top between `low` and `high`.
fn golden(f: &impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    const RATIO: f64 = 0.618_033_988_749_894_8;
    for _ in 0..STEPS {
        let (left, right) = (high - RATIO * (high - low), low + RATIO * (high - low));
        if f(left) < f(right) {
            low = left;
        } else {
            high = right;
        }
    }
    f(f64::midpoint(low, high))
}
