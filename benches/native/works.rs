//! Works that are done natively and in WebAssembly, and must give the same bits in both.

use pforms_kernel::{Form, threads};
use pforms_operators as operators;

use crate::{form, inside, parameters, scattered};

/// Something to do again and again; it returns the sum of what came out.
type Work = Box<dyn FnMut() -> f64>;

/// Orders of what is immersed, and of the host.
const IMMERSIONS: [(&[usize], &[usize]); 5] = [
    (&[4], &[4, 4]),
    (&[2, 2], &[4, 4]),
    (&[4, 4], &[2, 2, 2]),
    (&[2, 2, 2], &[3, 3, 3]),
    (&[4, 4, 4], &[4, 4, 4]),
];

/// The works by number, in pairs: polynomial, then rational. None beyond the last.
///
/// 0: a bicubic surface on a grid of 1000 × 1000. 2, 4: 100,000 scattered points of a bicubic surface, of a
/// tricubic volume. 6 to 15: the immersions.
#[must_use]
pub fn work(number: usize) -> Option<Work> {
    let rational = number % 2 == 1;
    Some(match number / 2 {
        0 => grid(1000, rational),
        1 => points(2, rational),
        2 => points(3, rational),
        which => {
            let (inner, host) = *IMMERSIONS.get(which - 3)?;
            immersion(inside(host.len(), inner, rational), form(host, rational))
        }
    })
}

fn grid(side: usize, rational: bool) -> Work {
    let (surface, at) = (form(&[4, 4], rational), parameters(side));
    let mut out = vec![0.0; side * side * 3];
    Box::new(move || {
        surface.grid_into(&[&at, &at], &mut out).unwrap();
        out.iter().step_by(97).sum()
    })
}

fn points(axes: usize, rational: bool) -> Work {
    let (host, lists) = (form(&vec![4; axes], rational), scattered(axes, 100_000));
    let mut out = vec![0.0; lists[0].len() * 3];
    Box::new(move || {
        let at: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
        host.scattered_into(&at, &mut out).unwrap();
        out.iter().step_by(97).sum()
    })
}

fn immersion(inner: Form, host: Form) -> Work {
    Box::new(move || operators::immerse(&inner, &host).unwrap().homogeneous().iter().sum())
}

/// Shortest time of a call, in the unit of the clock, over so many passes of a fiftieth of a second; and
/// what the work returned. One thread, as there is in WebAssembly.
pub fn measure(number: usize, passes: usize, clock: impl Fn() -> f64) -> Option<(f64, f64)> {
    threads::limit(1);
    let mut work = work(number)?;
    let mut timed = |calls: usize| {
        let started = clock();
        let sum = (0..calls).map(|_| work()).fold(0.0, |_, sum| sum);
        ((clock() - started) / calls as f64, sum)
    };
    let (first, sum) = timed(2);
    let calls = ((0.02 / first.max(1e-9)) as usize).clamp(1, 100_000);
    let best = (0..passes).map(|_| timed(calls).0).fold(f64::INFINITY, f64::min);
    Some((best, sum))
}
