//! Splines meet piece by piece; what lies at a joint is found from both sides and told once.

use pforms_kernel::{Form, Result};

use super::answer::{Contact, ContactKind, Intersections, Overlap, Undecided, sort};
use crate::Shape;
use crate::measuring::patches::{Patch, patches};

/// Parameters are the same if they differ by less than this share of a window.
const SAME: f64 = 1e-11;

/// Meets every piece of one with every piece of the other that comes nearer than `margin`.
///
/// Errors: those of the pieces, of `meet`.
pub(super) fn pairwise(
    first: &Shape,
    second: &Shape,
    margin: f64,
    meet: impl Fn(&Form, &Form) -> Result<Intersections>,
) -> Result<Intersections> {
    if let (Shape::Form(a), Shape::Form(b)) = (first, second) {
        return meet(a, b);
    }
    let (ours, theirs) = (patches(first)?, patches(second)?);
    let mut all = Intersections { complete: true, ..Intersections::default() };
    for a in &ours {
        for b in &theirs {
            if are_apart(a, b, margin) {
                continue;
            }
            let found = meet(&a.form, &b.form)?;
            all.complete &= found.complete;
            all.contacts.extend(found.contacts.into_iter().map(|c| placed(c, a, b)));
            all.overlaps.extend(found.overlaps.into_iter().map(|o| Overlap {
                first: o.first.map(|t| a.whole(&t)),
                second: o.second.map(|t| b.whole(&t)),
                ..o
            }));
            all.undecided.extend(found.undecided.into_iter().map(|u| Undecided {
                first: u.first.map(|t| a.whole(&t)),
                second: u.second.map(|t| b.whole(&t)),
            }));
        }
    }
    merge(&mut all);
    Ok(all)
}

/// Tells once what was found from several pieces.
pub(super) fn merge(all: &mut Intersections) {
    sort(&mut all.contacts);
    let mut told: Vec<Contact> = Vec::with_capacity(all.contacts.len());
    for contact in all.contacts.drain(..) {
        if all.overlaps.iter().any(|overlap| holds(overlap, &contact)) {
            continue;
        }
        match told.iter_mut().rev().find(|other| same(other, &contact)) {
            Some(other) if better(&contact, other) => *other = contact,
            Some(_) => {}
            None => told.push(contact),
        }
    }
    all.contacts = told;
    join(&mut all.overlaps);
}

fn better(a: &Contact, b: &Contact) -> bool {
    (a.proved, a.order) > (b.proved, b.order)
}

fn same(a: &Contact, b: &Contact) -> bool {
    let reach = a.error + b.error;
    let near = |x: &[f64], y: &[f64]| {
        x.iter().zip(y).all(|(s, t)| (s - t).abs() <= reach + SAME * s.abs().max(1.0))
    };
    near(&a.first, &b.first) && near(&a.second, &b.second)
}

/// Is a contact of curves a point of an overlap? Where a curve crosses itself its parameters lie in it, but
/// not side by side.
pub(super) fn holds(overlap: &Overlap, contact: &Contact) -> bool {
    let share = |[from, to]: &[Vec<f64>; 2], t: &[f64]| match (&from[..], &to[..], t) {
        ([from], [to], [t]) => {
            let slack = contact.error + 1e-9 * (to - from).abs();
            let inside = from.min(*to) - slack <= *t && *t <= from.max(*to) + slack;
            inside.then(|| if from == to { 0.0 } else { (t - from) / (to - from) })
        }
        _ => None,
    };
    let shares = [share(&overlap.first, &contact.first), share(&overlap.second, &contact.second)];
    let [Some(s), Some(t)] = shares else { return false };
    contact.kind != ContactKind::Crossing || (s - t).abs() < BESIDE
}

/// Shares of an overlap that belong to one place differ by less, unless its speed is very uneven.
const BESIDE: f64 = 0.25;

/// Joins overlaps that go on from one piece to the next.
fn join(overlaps: &mut Vec<Overlap>) {
    overlaps.sort_by(|a, b| {
        let start = |o: &Overlap| o.first[0].first().copied().unwrap_or(0.0);
        start(a).total_cmp(&start(b))
    });
    let near = |x: &[f64], y: &[f64]| {
        x.iter().zip(y).all(|(s, t)| (s - t).abs() <= 1e-9 * s.abs().max(1.0))
    };
    let mut joined: Vec<Overlap> = Vec::with_capacity(overlaps.len());
    for overlap in overlaps.drain(..) {
        let before = joined.iter_mut().find(|o| {
            near(&o.first[1], &overlap.first[0]) && near(&o.second[1], &overlap.second[0])
        });
        match before {
            Some(before) => {
                before.first[1].clone_from(&overlap.first[1]);
                before.second[1].clone_from(&overlap.second[1]);
                before.gap = before.gap.max(overlap.gap);
                before.proved &= overlap.proved;
            }
            None => joined.push(overlap),
        }
    }
    *overlaps = joined;
}

fn placed(contact: Contact, a: &Patch, b: &Patch) -> Contact {
    let widest =
        a.window.iter().chain(&b.window).fold(0.0_f64, |most, (from, to)| most.max(to - from));
    Contact {
        first: a.whole(&contact.first),
        second: b.whole(&contact.second),
        error: contact.error * widest,
        ..contact
    }
}

/// Are the boxes of two pieces clearly apart?
fn are_apart(a: &Patch, b: &Patch, margin: f64) -> bool {
    let mut sides = a.hull.iter().zip(&b.hull);
    let reach = a.hull.iter().chain(&b.hull);
    // Without bound where weights have not one sign.
    let reach = reach.fold(0.0_f64, |most, (x, y)| most.max(x.abs()).max(y.abs()));
    reach.is_finite() && sides.any(|(x, y)| (x.0 - y.1).max(y.0 - x.1) > margin + 1e-9 * reach)
}
