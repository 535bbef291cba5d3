//! Contacts of high order that rounding of the poles has blurred.
//!
//! Where a contact of order `n` was moved by `ε`, the exact curves cross once or more within `ε^(1/n)`, or
//! not at all. But the equation of one along the other still has `n` roots close together there, complex ones
//! among them, and their mean is the place of the contact.

use pforms_kernel::Form;

use super::closest::{Near, closest, jet};
use crate::measuring::intersect::answer::{Contact, ContactKind, sort};
use crate::measuring::intersect::exact::{Around, Cluster, Meetings};
use crate::measuring::vector::norm;

/// A gap that is more than blur, in margins.
const LEVEL: f64 = 16.0;

/// Farther from a contact than this other terms count too.
const REACH: f64 = 0.25;

/// Contacts that are one up to the margin are told as one, with their order together.
pub(super) fn gather(
    a: &Form,
    b: &Form,
    equations: &Meetings,
    contacts: &mut Vec<Contact>,
    margin: f64,
) {
    let mut waiting: Vec<[f64; 2]> = Vec::new();
    for contact in contacts.iter().filter(|c| !(c.proved && c.order > 1)) {
        waiting.push([contact.first[0], contact.second[0]]);
    }
    let mut gathered: Vec<Contact> = Vec::new();
    for [s, t] in waiting {
        if gathered.iter().any(|whole| holds(whole, s, t)) {
            continue;
        }
        if let Some(mut whole) = gathered_at(a, b, equations, [s, t], margin) {
            let meets = |c: &Contact| c.proved && holds(&whole, c.first[0], c.second[0]);
            if contacts.iter().any(meets) {
                whole.gap = 0.0;
            }
            contacts.retain(|c| !holds(&whole, c.first[0], c.second[0]));
            gathered.push(whole);
        }
    }
    contacts.append(&mut gathered);
    sort(contacts);
}

fn holds(whole: &Contact, s: f64, t: f64) -> bool {
    let reach = whole.error + f64::EPSILON;
    (whole.first[0] - s).abs() <= reach && (whole.second[0] - t).abs() <= reach
}

/// The contact of an order above 1 around a place, if there is one up to the margin.
fn gathered_at(
    a: &Form,
    b: &Form,
    equations: &Meetings,
    [s, t]: [f64; 2],
    margin: f64,
) -> Option<Contact> {
    let on_a = |near: f64| move |s: f64| foot(a, b, s, near).gap;
    let on_b = |near: f64| move |t: f64| foot(b, a, t, near).gap;
    // In space curves have the contact that they have in every view.
    let mut least: Option<[Cluster; 2]> = None;
    for [of_s, of_t] in equations.around(s, t) {
        let faint = |p: &Cluster, q: &Cluster| {
            p.count == q.count
                && is_faint(&of_s, p, on_a(t), margin)
                && is_faint(&of_t, q, on_b(s), margin)
        };
        let pair = of_s.clusters().find_map(|p| {
            let other = of_t.clusters().find(|q| faint(&p, q));
            other.map(|q| [p, q])
        })?;
        if least.is_none_or(|known| pair[0].count < known[0].count) {
            least = Some(pair);
        }
    }
    let [p, q] = least?;
    let mut place = [p.centre, q.centre].map(|x| x.clamp(0.0, 1.0));
    let mut gap = distance(a, b, place);
    if gap > margin {
        let near = foot(a, b, place[0], place[1]);
        (place, gap) = ([near.s, near.t], near.gap);
    }
    (gap <= margin).then(|| Contact {
        first: vec![place[0]],
        second: vec![place[1]],
        point: jet(a, place[0]).0,
        kind: ContactKind::Tangent,
        order: p.count,
        gap,
        error: p.radius.max(q.radius).max(f64::EPSILON),
        proved: false,
    })
}

/// Does the other curve stay within the margin of this one among the roots of a cluster? How the equation
/// compares with distances is measured farther away, where these are more than rounding.
fn is_faint(equation: &Around, cluster: &Cluster, gap: impl Fn(f64) -> f64, margin: f64) -> bool {
    let mut reach = 4.0 * cluster.radius;
    while reach <= REACH {
        for place in [cluster.centre + reach, cluster.centre - reach] {
            let distance = if (0.0..=1.0).contains(&place) { gap(place) } else { 0.0 };
            if distance > LEVEL * margin {
                return cluster.level * distance <= margin * equation.value(place).abs();
            }
        }
        reach *= 2.0;
    }
    false
}

fn distance(a: &Form, b: &Form, [s, t]: [f64; 2]) -> f64 {
    let (p, q) = (jet(a, s).0, jet(b, t).0);
    norm(&p.iter().zip(&q).map(|(x, y)| x - y).collect::<Vec<_>>())
}

/// The nearest place of the second curve.
fn foot(a: &Form, b: &Form, s: f64, t: f64) -> Near {
    closest(a, b, [s, t], &[[s, s], [(t - REACH).max(0.0), (t + REACH).min(1.0)]])
}
