//! Curves that the quick search does not settle: exact arithmetic tells where they meet, and how often;
//! what comes near without meeting is told after that.

use pforms_kernel::{Form, Result};

use super::blurred;
use super::closest::{Near, closest, jet};
use super::leftover::{Window, contact, contact_in, gathered};
use super::overlap::overlaps;
use super::shared::shared;
use super::touches::{stay_near, touches};
use crate::measuring::intersect::answer::{Contact, ContactKind, Intersections, Overlap, sort};
use crate::measuring::intersect::exact::{Exact, Meeting, Meetings, meetings};

/// Settles what was left over, and proves what was found before. The coordinates that are
/// not `live` are the same constant on both curves.
///
/// Errors: those of projection on either curve.
pub(super) fn settle(
    a: &Form,
    b: &Form,
    live: &[usize],
    left: &[Window],
    margin: f64,
    answer: &mut Intersections,
) -> Result<()> {
    match meetings(&poles(a, live), &poles(b, live)) {
        Exact::Meetings(all) => {
            answer.contacts = all.list.iter().map(|meeting| met(a, meeting)).collect();
            if margin > 0.0 {
                answer.overlaps = overlaps(a, b, margin)?;
                seen(a, b, &all, margin, &mut answer.contacts);
                let plane = live.len() <= 2;
                touches(a, b, left, &all.turns(), plane, margin, answer)?;
                blurred::gather(a, b, &all, &mut answer.contacts, margin);
                together(a, b, &mut answer.contacts, margin);
            }
        }
        Exact::Shared => shared(a, b, live, left, margin, answer)?,
        Exact::Unknown => {
            answer.overlaps = overlaps(a, b, margin)?;
            for window in gathered(left) {
                if answer.overlaps.iter().any(|overlap| within(overlap, &window)) {
                    continue;
                }
                match contact_in(a, b, &window, margin) {
                    Ok(found) => answer.contacts.extend(found),
                    Err(window) => answer.undecided.push(window),
                }
            }
        }
    }
    Ok(())
}

/// Homogeneous poles: the coordinates that differ, and the weight.
fn poles(form: &Form, live: &[usize]) -> Vec<Vec<f64>> {
    let poles = form.homogeneous().chunks_exact(form.width());
    let chosen = |pole: &[f64]| live.iter().chain([&form.ambient()]).map(|k| pole[*k]).collect();
    poles.map(chosen).collect()
}

/// A meeting of the exact curves.
pub(super) fn met(a: &Form, meeting: &Meeting) -> Contact {
    Contact {
        first: vec![meeting.s],
        second: vec![meeting.t],
        point: jet(a, meeting.s).0,
        kind: if meeting.order == 1 { ContactKind::Crossing } else { ContactKind::Tangent },
        order: meeting.order,
        gap: 0.0,
        error: f64::EPSILON,
        proved: true,
    }
}

/// Places where two contacts are one.
const SAME: f64 = 1e-9;

/// A distance that rounding makes of 0, in units of the curves.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// Adds what meets in a view of the space, and up to the margin in space.
fn seen(a: &Form, b: &Form, all: &Meetings, margin: f64, contacts: &mut Vec<Contact>) {
    let mut near: Vec<Near> = all
        .seen
        .iter()
        .map(|meeting| {
            let room = [meeting.s, meeting.t].map(|x| [(x - SAME).max(0.0), (x + SAME).min(1.0)]);
            closest(a, b, [meeting.s, meeting.t], &room)
        })
        .filter(|near| near.gap <= margin)
        .collect();
    near.sort_by(|x, y| x.gap.total_cmp(&y.gap));
    for near in near {
        let same = |c: &Contact| {
            let (s, t) = (c.first[0], c.second[0]);
            (s - near.s).abs() <= SAME && (t - near.t).abs() <= SAME
                // Beside curves that stay so near many a view sees a meeting.
                || near.gap > ROUNDING.max(4.0 * c.gap)
                    && stay_near(a, b, [s, t], [near.s, near.t], margin)
        };
        if !contacts.iter().any(same) {
            contacts.push(contact(a, &near, SAME));
        }
    }
}

/// Meetings between which the curves stay within the margin become one: a tangent up to that.
fn together(a: &Form, b: &Form, contacts: &mut Vec<Contact>, margin: f64) {
    sort(contacts);
    let mut told: Vec<Contact> = Vec::with_capacity(contacts.len());
    for contact in contacts.drain(..) {
        match told.last_mut().filter(|last| is_near(a, b, last, &contact, margin)) {
            Some(last) => join(a, last, &contact),
            None => told.push(contact),
        }
    }
    *contacts = told;
}

/// Parameters farther apart than this are two contacts, however near the curves stay.
const FAR: f64 = 1.0 / 50.0;

fn is_near(a: &Form, b: &Form, x: &Contact, y: &Contact, margin: f64) -> bool {
    let places = [x, y].map(|c| [c.first[0], c.second[0]]);
    let near = (0..2).all(|k| (places[0][k] - places[1][k]).abs() <= FAR);
    x.order * y.order > 0 && near && stay_near(a, b, places[0], places[1], margin)
}

fn join(a: &Form, last: &mut Contact, next: &Contact) {
    let (s, t) = (last.first[0], last.second[0]);
    let (u, v) = (next.first[0], next.second[0]);
    let reach = 0.5 * (u - s).abs().max((v - t).abs());
    last.first = vec![0.5 * (s + u)];
    last.second = vec![0.5 * (t + v)];
    last.point = jet(a, last.first[0]).0;
    last.kind = ContactKind::Tangent;
    last.order += next.order;
    last.error = reach + last.error.max(next.error);
    last.proved = false;
}

/// A window that sticks out by less is explained.
const SMALL: f64 = 1e-3;

/// Does an arc that is shared explain a window?
pub(super) fn within(overlap: &Overlap, window: &Window) -> bool {
    let inside = |[from, to]: &[Vec<f64>; 2], [low, high]: &[f64; 2]| {
        from[0].min(to[0]) <= low + SMALL && *high <= from[0].max(to[0]) + SMALL
    };
    inside(&overlap.first, &window[0]) && inside(&overlap.second, &window[1])
}
