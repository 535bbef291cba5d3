//! Where two curves meet.
//!
//! A quick search in floating arithmetic proves most crossings and that there is nothing else; what
//! it leaves over is looked at with more care. Curves in space are seen in a plane, in which they
//! come as near as they do in space: what meets there is compared in space.

mod blurred;
mod clip;
mod closest;
mod flat;
mod leftover;
mod many;
mod overlap;
mod part;
mod plane;
mod point;
mod quick;
mod root;
mod searches;
mod weights;

use pforms_kernel::{Error, Form, Result};

use super::answer::{Contact, ContactKind, Intersections, Overlap, Undecided};
use super::pieces::{merge, pairwise};
use crate::measuring::scale::{in_units, unit};
use crate::{Poles, Shape, stretch};
use flat::{Flat, live, views};
use leftover::{Window, contact, contact_in, gathered};
pub use many::{Crossings, intersect_many};
use quick::Found;
use root::Root;
use searches::Searches;

/// Orders that are provided for.
const HIGHEST: usize = 64;

/// All contacts of two curves, forms or splines.
pub(super) fn intersect_curves(
    first: &Shape,
    second: &Shape,
    accuracy: f64,
) -> Result<Intersections> {
    let unit = unit([first.net(), second.net()]);
    let first = first.with_net(in_units(first.net(), unit)?)?;
    let second = second.with_net(in_units(second.net(), unit)?)?;
    let margin = margin(&[first.net(), second.net()], accuracy);
    let mut found = pairwise(&first, &second, margin, |a, b| meet(a, b, margin))?;
    for contact in &mut found.contacts {
        contact.gap *= unit;
        contact.point.iter_mut().for_each(|x| *x *= unit);
    }
    found.overlaps.iter_mut().for_each(|overlap| overlap.gap *= unit);
    Ok(found)
}

/// The distance below which curves touch: a share of the larger extent of their poles, but no
/// less than what the rounding of coordinates may be; nothing for an accuracy of 0.
pub(super) fn margin(nets: &[&Form; 2], accuracy: f64) -> f64 {
    if accuracy == 0.0 {
        return 0.0;
    }
    let (mut size, mut reach) = (0.0_f64, 0.0_f64);
    for net in nets {
        for k in 0..net.ambient() {
            let poles = net.homogeneous().chunks_exact(net.width());
            let finite = poles.filter(|pole| pole[net.ambient()] != 0.0);
            let values = finite.map(|pole| pole[k] / pole[net.ambient()]);
            let (low, high) =
                values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
            size = size.max(high - low);
            reach = reach.max(low.abs()).max(high.abs());
        }
    }
    (accuracy * size).max(4.0 * f64::EPSILON * reach)
}

/// All contacts of two forms in units of their own, whose weights are cut to one sign.
fn meet(a: &Form, b: &Form, margin: f64) -> Result<Intersections> {
    for (name, form) in [("first", a), ("second", b)] {
        if form.orders()[0] > HIGHEST {
            return Err(Error::shape(name, form.kind(), format!("an order of at most {HIGHEST}")));
        }
    }
    let (first, second) = (weights::positive("first", a)?, weights::positive("second", b)?);
    if let (Shape::Form(a), Shape::Form(b)) = (&first, &second) {
        return settled(a, b, margin);
    }
    pairwise(&first, &second, margin, |a, b| settled(a, b, margin))
}

/// All contacts of two forms with weights of one sign.
fn settled(a: &Form, b: &Form, margin: f64) -> Result<Intersections> {
    if let Some(answer) = point::settled(a, b, margin)? {
        return Ok(answer);
    }
    let live = live(a, b);
    let mut searches = Searches::new();
    let mut best: Option<Found> = None;
    let views = views(&live);
    for view in &views {
        let flat = Flat::new(a, b, view);
        let found = searches.run(&flat, margin * flat.scale, false);
        if best.as_ref().is_none_or(|best| found.left.len() < best.left.len()) {
            best = Some(found);
        }
        if best.as_ref().is_some_and(|best| best.left.is_empty()) {
            break;
        }
    }
    let Found { roots, left } = best.unwrap_or_default();
    let mut answer = Intersections::default();
    let plane = live.len() <= 2;
    answer.contacts.extend(roots.iter().filter_map(|root| match plane {
        true => Some(crossing(a, root)),
        false => in_space(a, b, root, margin),
    }));
    match left.is_empty() {
        true => {}
        false if plane => plane::settle(a, b, &views[0], &left, margin, &mut answer)?,
        false => settle_left(a, b, &left, margin, &mut answer)?,
    }
    answer.complete = answer.undecided.is_empty();
    merge(&mut answer);
    Ok(answer)
}

/// A crossing in a plane, proved.
fn crossing(a: &Form, root: &Root) -> Contact {
    Contact {
        first: vec![root.s],
        second: vec![root.t],
        point: closest::jet(a, root.s).0,
        kind: ContactKind::Crossing,
        order: 1,
        gap: 0.0,
        error: root.error,
        proved: true,
    }
}

/// What a crossing in a plane is in space: within a margin of it the curves cross there too.
fn in_space(a: &Form, b: &Form, root: &Root, margin: f64) -> Option<Contact> {
    let room: Window = [root.s, root.t].map(|x| [(x - 1e-3).max(0.0), (x + 1e-3).min(1.0)]);
    let near = closest::closest(a, b, [root.s, root.t], &room);
    (near.gap <= margin).then(|| contact(a, &near, root.error.max(margin)))
}

/// What the windows that were left over hold, of curves in space.
fn settle_left(
    a: &Form,
    b: &Form,
    left: &[Window],
    margin: f64,
    answer: &mut Intersections,
) -> Result<()> {
    answer.overlaps = overlap::overlaps(a, b, margin)?;
    if !answer.overlaps.is_empty() {
        return beside(a, b, margin, answer);
    }
    for window in gathered(left) {
        match contact_in(a, b, &window, margin) {
            Ok(found) => answer.contacts.extend(found),
            Err(window) => answer.undecided.push(window),
        }
    }
    Ok(())
}

/// What curves that share arcs have in common beside them: the rest of the first curve meets the second,
/// the arcs meet the rest of the second.
fn beside(a: &Form, b: &Form, margin: f64, answer: &mut Intersections) -> Result<()> {
    answer.contacts.clear();
    let arcs = |of: &dyn Fn(&Overlap) -> [f64; 2]| -> Vec<[f64; 2]> {
        let sorted = |[from, to]: [f64; 2]| [from.min(to), from.max(to)];
        answer.overlaps.iter().map(|overlap| sorted(of(overlap))).collect()
    };
    let first = arcs(&|o| [o.first[0][0], o.first[1][0]]);
    let second = arcs(&|o| [o.second[0][0], o.second[1][0]]);
    let mut pairs: Vec<Window> = rest(&first).into_iter().map(|s| [s, [0.0, 1.0]]).collect();
    let others = rest(&second);
    pairs.extend(first.iter().flat_map(|s| others.iter().map(move |t| [*s, *t])));
    for [s, t] in pairs {
        let (p, q) = (stretch(a, &s[..1], &s[1..])?, stretch(b, &t[..1], &t[1..])?);
        let found = settled(&p, &q, margin)?;
        let at = |[from, to]: [f64; 2], x: &[f64]| vec![from + x[0] * (to - from)];
        answer.contacts.extend(found.contacts.into_iter().map(|c| Contact {
            first: at(s, &c.first),
            second: at(t, &c.second),
            ..c
        }));
        answer.undecided.extend(found.undecided.into_iter().map(|u| Undecided {
            first: u.first.map(|x| at(s, &x)),
            second: u.second.map(|x| at(t, &x)),
        }));
    }
    Ok(())
}

/// What is left of the window from 0 to 1.
fn rest(arcs: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted = arcs.to_vec();
    sorted.sort_by(|x, y| x[0].total_cmp(&y[0]));
    let mut rest = Vec::new();
    let mut from = 0.0;
    for [start, end] in sorted {
        rest.push([from, start]);
        from = f64::max(from, end);
    }
    rest.push([from, 1.0]);
    rest.retain(|[from, to]| to - from > 1e-9);
    rest
}
