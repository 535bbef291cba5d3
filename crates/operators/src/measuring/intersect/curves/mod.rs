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
mod point;
mod quick;
mod root;
mod seam;
mod searches;
mod settle;
mod shared;
mod touches;
mod weights;

use pforms_kernel::{Error, Form, Result};

use super::answer::{Contact, ContactKind, Intersections};
use super::pieces::{merge, pairwise};
use crate::measuring::scale::{in_units, unit};
use crate::{Poles, Shape};
use flat::{Flat, live, views};
use leftover::{Window, contact};
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
    seam::told_once(&first, &second, margin, &mut found)?;
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
    // In space what was found is proved after that.
    if !left.is_empty() || !(plane || answer.contacts.is_empty()) {
        settle::settle(a, b, &live, &left, margin, &mut answer)?;
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
