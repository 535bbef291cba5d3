//! Splines meet piece by piece; what lies at a joint is found from both sides and told once.

use pforms_kernel::{Form, Result};

use super::answer::{Contact, Intersections, Overlap, Undecided, sort};
use crate::Shape;

/// A piece and where its window lies.
struct Piece {
    form: Form,
    window: Vec<(f64, f64)>,
    hull: Option<Vec<(f64, f64)>>,
}

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
    let (ours, theirs) = (pieces(first)?, pieces(second)?);
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
                first: o.first.map(|t| at(a, &t)),
                second: o.second.map(|t| at(b, &t)),
                ..o
            }));
            all.undecided.extend(found.undecided.into_iter().map(|u| Undecided {
                first: u.first.map(|t| at(a, &t)),
                second: u.second.map(|t| at(b, &t)),
            }));
        }
    }
    merge(&mut all);
    Ok(all)
}

/// Tells once what was found from several pieces.
pub(super) fn merge(all: &mut Intersections) {
    sort(&mut all.contacts);
    join(&mut all.overlaps);
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

/// Is a contact of curves a point of an overlap?
fn holds(overlap: &Overlap, contact: &Contact) -> bool {
    let share = |[from, to]: &[Vec<f64>; 2], t: &[f64]| match (&from[..], &to[..], t) {
        ([from], [to], [t]) => {
            let slack = contact.error + 1e-9 * (to - from).abs();
            from.min(*to) - slack <= *t && *t <= from.max(*to) + slack
        }
        _ => false,
    };
    share(&overlap.first, &contact.first) && share(&overlap.second, &contact.second)
}

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

fn placed(contact: Contact, a: &Piece, b: &Piece) -> Contact {
    let widest =
        a.window.iter().chain(&b.window).fold(0.0_f64, |most, (from, to)| most.max(to - from));
    Contact {
        first: at(a, &contact.first),
        second: at(b, &contact.second),
        error: contact.error * widest,
        ..contact
    }
}

/// Exactly the break where two pieces meet, so that they agree on it.
fn at(piece: &Piece, local: &[f64]) -> Vec<f64> {
    let ends = local.iter().zip(&piece.window);
    ends.map(|(t, (from, to))| if *t == 1.0 { *to } else { from + t * (to - from) }).collect()
}

fn pieces(shape: &Shape) -> Result<Vec<Piece>> {
    let piece = |form: Form, window| Piece { hull: hull(&form), form, window };
    let spline = match shape {
        Shape::Form(form) => return Ok(vec![piece(form.clone(), vec![(0.0, 1.0); form.axes()])]),
        Shape::Spline(spline) => spline,
    };
    let (breaks, counts) = (spline.breaks(), spline.counts());
    let forms = spline.pieces()?.into_iter().enumerate();
    Ok(forms
        .map(|(mut rest, form)| {
            let sides = counts.iter().zip(&breaks).rev();
            let mut window: Vec<(f64, f64)> = sides
                .map(|(count, list)| {
                    let i = rest % count;
                    rest /= count;
                    (list[i], list[i + 1])
                })
                .collect();
            window.reverse();
            piece(form, window)
        })
        .collect())
}

/// The box of the poles; none if their weights have not one sign.
fn hull(form: &Form) -> Option<Vec<(f64, f64)>> {
    let (poles, last) = (form.homogeneous().chunks_exact(form.width()), form.ambient());
    let one_sign =
        poles.clone().all(|pole| pole[last] > 0.0) || poles.clone().all(|pole| pole[last] < 0.0);
    let ends = |k: usize| {
        let values = poles.clone().map(|pole| pole[k] / pole[last]);
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
    };
    one_sign.then(|| (0..last).map(ends).collect())
}

/// Are the boxes of two pieces clearly apart?
fn are_apart(a: &Piece, b: &Piece, margin: f64) -> bool {
    let (Some(p), Some(q)) = (&a.hull, &b.hull) else { return false };
    let reach = p.iter().chain(q).fold(0.0_f64, |most, (x, y)| most.max(x.abs()).max(y.abs()));
    p.iter().zip(q).any(|(x, y)| (x.0 - y.1).max(y.0 - x.1) > margin + 1e-9 * reach)
}
