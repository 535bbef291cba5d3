//! Integrals over forms with a proved bound of their error.
//!
//! The element of size of a form is `√(N·N)/W^e` with polynomials `N`, `W` ([`density`]). A box of
//! parameters is integrated by a product of Gauss rules where Bernstein's coefficients show that
//! `N·N` and `W` keep away from 0 for complex values of each parameter, the others real ([`bounds`]):
//! then the integrand is analytic in an ellipse and the error of each rule is bounded. Other boxes,
//! around singular points, contribute something between 0 and the mean of their coefficients. The box
//! with the largest error is halved, until the errors add up to no more than was asked for.

mod bounds;
mod cell;
mod density;
mod local;
mod rule;

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use pforms_kernel::{Error, Form, Result};

use self::cell::{Cell, Share, moment_count};
use self::density::Density;
pub(crate) use self::density::{Element, noisy_determinant};
pub(crate) use self::local::{Local, heaviest, infinite, least_weight, seen_from};
use self::rule::Rules;

/// Integrals over all pieces, in units of length `unit`, of coordinates seen from `origin`.
#[derive(Clone, Debug)]
pub(crate) struct Integral {
    /// Of the element; with moments, of it times each coordinate, then of it times each product of two.
    pub values: Vec<f64>,
    /// By how much each may differ from the true one, at most.
    pub error: f64,
    pub origin: Vec<f64>,
    pub unit: f64,
}

/// Boxes at most.
const CELLS: usize = 1 << 15;

/// Bytes of all boxes at most.
const BYTES: usize = 1 << 28;

/// Roundings of the result that are counted on top, and below which no accuracy can be asked.
const ROUNDINGS: f64 = 16.0;

/// Part of the accuracy that a rule may use up.
const SHARE: f64 = 0.25;

/// Integrates over pieces until the error is `accuracy` times the integral of the element.
///
/// Errors: `Domain` when `accuracy` is not between 0 and 1 or a piece goes to infinity; `Accuracy`
/// when the bound cannot be had; those of [`Density::new`].
pub(crate) fn integrate(
    pieces: &[Form],
    element: Element,
    moments: usize,
    accuracy: f64,
) -> Result<Integral> {
    require_accuracy(accuracy)?;
    let local = Local::new(pieces)?;
    match attempt(&local, element, moments, accuracy, false) {
        // Perhaps it is only the rounding of the polynomials.
        Err(Error::Accuracy(_)) => attempt(&local, element, moments, accuracy, true),
        result => result,
    }
}

fn attempt(
    local: &Local,
    element: Element,
    moments: usize,
    accuracy: f64,
    sharp: bool,
) -> Result<Integral> {
    let density = |place| Density::new(local, place, element, accuracy, sharp);
    let densities = (0..local.pieces.len()).map(density).collect::<Result<Vec<_>>>()?;
    let cells = densities.iter().zip(&local.pieces).enumerate();
    let cells: Vec<Cell> =
        cells.map(|(k, (density, host))| Cell::whole(k, density, host, moments > 0)).collect();
    let total = cells.iter().map(|cell| cell.estimate(&densities[cell.piece])).sum();
    let mut work = Work { densities, moments, accuracy, rules: Rules::default(), total };
    let (values, error) = work.refined(cells, moment_count(local.origin.len(), moments))?;
    Ok(Integral { values, error, origin: local.origin.clone(), unit: local.unit })
}

/// A box in the queue, the largest error first.
struct Waiting {
    cell: Cell,
    share: Share,
    number: usize,
}

impl Waiting {
    /// What halving may take away.
    fn excess(&self) -> f64 {
        self.share.error - self.share.noise
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.number == other.number
    }
}

impl Eq for Waiting {}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        self.excess().total_cmp(&other.excess()).then(other.number.cmp(&self.number))
    }
}

struct Work {
    densities: Vec<Density>,
    moments: usize,
    accuracy: f64,
    rules: Rules,
    /// About what the integral is.
    total: f64,
}

/// What all boxes add up to.
#[derive(Default)]
struct Sums {
    /// The integral of the element, each box without its sign.
    size: f64,
    error: f64,
    noise: f64,
}

impl Work {
    /// Halves boxes until the error is small enough; the integrals and their error.
    fn refined(&mut self, cells: Vec<Cell>, count: usize) -> Result<(Vec<f64>, f64)> {
        let omitted: f64 = self.densities.iter().map(|density| density.omitted).sum();
        let bytes = cells.iter().map(Cell::bytes).max().unwrap_or(1);
        let most = (BYTES / bytes).min(CELLS) + cells.len();
        let mut number = 0;
        let mut queue = BinaryHeap::with_capacity(cells.len());
        for cell in cells {
            queue.push(self.waiting(cell, &mut number)?);
        }
        loop {
            pforms_kernel::stopping::check()?;
            // Made anew each time: what is left of large errors taken off a sum is no small error.
            let sums = sums(&queue);
            let fixed = omitted + sums.noise + ROUNDINGS * f64::EPSILON * sums.size;
            let error = omitted + sums.error + ROUNDINGS * f64::EPSILON * sums.size;
            let wanted = self.accuracy * sums.size;
            // What is all rounding has no digits that could be asked for.
            if error <= wanted || error <= 2.0 * fixed && sums.size <= error {
                return Ok((totals(queue, count), error));
            }
            if fixed > 0.5 * wanted && sums.error.is_finite() && error <= 2.0 * fixed {
                return Err(not_reached(self.accuracy, error / sums.size));
            }
            let limit = 0.5 * (wanted - fixed).max(fixed) / queue.len() as f64;
            for _ in 0..queue.len() {
                if queue.peek().is_none_or(|worst| worst.excess() <= limit) {
                    break;
                }
                let Some(Waiting { cell, share, .. }) = queue.pop() else { break };
                let halves = if queue.len() < most { cell.halves(share.axis)? } else { None };
                let Some(halves) = halves else {
                    return Err(match share.error.is_finite() {
                        true => not_reached(self.accuracy, error / sums.size),
                        false => infinite(),
                    });
                };
                for half in halves {
                    queue.push(self.waiting(half, &mut number)?);
                }
            }
        }
    }

    fn waiting(&mut self, cell: Cell, number: &mut usize) -> Result<Waiting> {
        let density = &self.densities[cell.piece];
        let part = self.total * cell.volume() / self.densities.len() as f64;
        let target = SHARE * self.accuracy * cell.estimate(density).max(part);
        let share = cell.share(density, self.moments, target, &mut self.rules)?;
        *number += 1;
        Ok(Waiting { cell, share, number: *number })
    }
}

fn sums(queue: &BinaryHeap<Waiting>) -> Sums {
    queue.iter().fold(Sums::default(), |sums, waiting| Sums {
        size: sums.size + waiting.share.values[0].abs(),
        error: sums.error + waiting.share.error,
        noise: sums.noise + waiting.share.noise,
    })
}

/// The integrals, box after box in the order in which they were made.
fn totals(queue: BinaryHeap<Waiting>, count: usize) -> Vec<f64> {
    let mut all = queue.into_vec();
    all.sort_by_key(|waiting| waiting.number);
    let mut values = vec![0.0; count];
    for waiting in all {
        values.iter_mut().zip(&waiting.share.values).for_each(|(sum, x)| *sum += x);
    }
    values
}

/// Complains unless an accuracy can be had at all.
pub(crate) fn require_accuracy(accuracy: f64) -> Result<()> {
    if !(accuracy > 0.0 && accuracy < 1.0) {
        return Err(Error::domain("accuracy", accuracy, "a number between 0 and 1"));
    }
    if accuracy <= ROUNDINGS * f64::EPSILON {
        return Err(not_reached(accuracy, ROUNDINGS * f64::EPSILON));
    }
    Ok(())
}

fn not_reached(accuracy: f64, reached: f64) -> Error {
    let expected = format!("an accuracy that can be had: the bound got down to {reached:.1e}");
    Error::accuracy("accuracy", accuracy, expected)
}
