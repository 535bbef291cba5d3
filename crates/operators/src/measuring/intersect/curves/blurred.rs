//! Contacts of high order that rounding of the poles has blurred: how the curves part from each other
//! tells the order they had.
//!
//! Where a contact of order `n` was moved by `ε`, the exact curves cross once or more within `ε^(1/n)`, or
//! not at all. Farther away they part as `xⁿ`: distances doubled multiply the gap by `2ⁿ`.

use pforms_kernel::Form;

use super::closest::{Near, closest, jet};
use crate::measuring::intersect::answer::{Contact, ContactKind};

/// Gaps that are looked at, in margins: far above what blurs.
const LEVEL: f64 = 1024.0;

/// Farther from a contact than this other terms count too.
const REACH: f64 = 1.0 / 32.0;

/// The contact of the order that the curves show around it, if that is not a crossing: in its middle.
pub(super) fn sharpened(a: &Form, b: &Form, contact: &Contact, margin: f64) -> Option<Contact> {
    let (s, t) = (contact.first[0], contact.second[0]);
    let sides = [-1.0, 1.0].map(|side| parting(a, b, [s, t], side, LEVEL * margin));
    let order = match sides {
        [Some(left), Some(right)] if left.order == right.order => left.order,
        [Some(only), None] | [None, Some(only)] => only.order,
        _ => return None,
    };
    if order < 2 {
        return None;
    }
    // Both sides part by the same: their middle is the place, as far as the curves are even or odd there.
    let middle = match sides {
        [Some(left), Some(right)] => (s + 0.5 * (right.reach - left.reach)).clamp(0.0, 1.0),
        _ => s,
    };
    let near = foot(a, b, middle, t);
    (near.gap <= margin).then(|| Contact {
        first: vec![near.s],
        second: vec![near.t],
        point: jet(a, near.s).0,
        kind: ContactKind::Tangent,
        order,
        gap: near.gap,
        error: contact.error.max((middle - s).abs()).max(f64::EPSILON),
        proved: false,
    })
}

#[derive(Clone, Copy)]
struct Parting {
    order: usize,
    reach: f64,
}

/// Where, on one side, the curves are apart by `level`, and how they part there.
fn parting(a: &Form, b: &Form, [s, t]: [f64; 2], side: f64, level: f64) -> Option<Parting> {
    let gap = |reach: f64| foot(a, b, s + side * reach, t).gap;
    let inside = |reach: f64| (0.0..=1.0).contains(&(s + side * reach));
    let mut reach = 1e-9;
    while gap(reach) < level {
        reach *= 2.0;
        if reach > REACH || !inside(2.0 * reach) {
            return None;
        }
    }
    let (mut low, mut high) = (0.5 * reach, reach);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if gap(middle) < level { low = middle } else { high = middle }
    }
    let exponent = libm::log2(gap(2.0 * high) / gap(high));
    let order = exponent.round();
    ((exponent - order).abs() < 0.25).then_some(Parting { order: order as usize, reach: high })
}

/// The nearest place of the second curve.
fn foot(a: &Form, b: &Form, s: f64, t: f64) -> Near {
    closest(a, b, [s, t], &[[s, s], [(t - 0.25).max(0.0), (t + 0.25).min(1.0)]])
}
