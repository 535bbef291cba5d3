//! Plane curves that the quick search does not settle: exact arithmetic tells where they meet, and how
//! often; what comes near without meeting is told after that.

use pforms_kernel::{Form, Result};

use super::blurred::sharpened;
use super::closest::{closest, jet};
use super::flat::{View, poles};
use super::leftover::{Window, contact_in, gathered, within};
use super::overlap::{ends, overlaps};
use crate::measuring::intersect::answer::{Contact, ContactKind, Intersections, sort};
use crate::measuring::intersect::exact::{Exact, Meeting, meetings};
use crate::project;

/// Arcs of one curve are the same if their computed ends are.
const ARC: f64 = 1e-12;

/// Settles what was left over; the contacts found before are found again.
///
/// Errors: those of projection on either curve.
pub(super) fn settle(
    a: &Form,
    b: &Form,
    view: &View,
    left: &[Window],
    margin: f64,
    answer: &mut Intersections,
) -> Result<()> {
    match meetings(&poles(a, view), &poles(b, view)) {
        Exact::Meetings(list, turns) => {
            answer.contacts = list.iter().map(|meeting| met(a, meeting)).collect();
            if margin > 0.0 {
                answer.overlaps = overlaps(a, b, margin)?;
                together(a, b, &mut answer.contacts, margin);
                touches(a, b, left, &turns, margin, answer)?;
                sharpen(a, b, &mut answer.contacts, margin);
            }
        }
        Exact::Shared => shared(a, b, margin.max(ARC), answer)?,
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

/// A meeting of the exact curves.
fn met(a: &Form, meeting: &Meeting) -> Contact {
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

/// Curves that are parts of one: the arcs they share, and ends that they have in common.
fn shared(a: &Form, b: &Form, margin: f64, answer: &mut Intersections) -> Result<()> {
    answer.overlaps = overlaps(a, b, margin)?;
    answer.overlaps.iter_mut().for_each(|overlap| {
        overlap.gap = 0.0;
        overlap.proved = true;
    });
    for [s, t] in ends(a, b, margin)? {
        let mut contact = met(a, &Meeting { s, t, order: 0 });
        contact.error = ARC;
        answer.contacts.push(contact);
    }
    Ok(())
}

/// Parameters farther apart than this are two contacts, however near the curves stay.
const CLUSTER: f64 = 0.05;

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

fn is_near(a: &Form, b: &Form, x: &Contact, y: &Contact, margin: f64) -> bool {
    let places = [x, y].map(|c| [c.first[0], c.second[0]]);
    x.order * y.order > 0 && stay_near(a, b, places[0], places[1], margin)
}

/// Do the curves stay within the margin from one place to another?
fn stay_near(a: &Form, b: &Form, [s, t]: [f64; 2], [u, v]: [f64; 2], margin: f64) -> bool {
    if (u - s).abs() > CLUSTER || (v - t).abs() > CLUSTER {
        return false;
    }
    [0.25, 0.5, 0.75].iter().all(|share| {
        let (s, middle) = (s + share * (u - s), t + share * (v - t));
        let window = [[s, s], [t.min(v), t.max(v)]];
        closest(a, b, [s, middle], &window).gap <= margin
    })
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

/// Contacts of a higher order up to the margin are told as such.
fn sharpen(a: &Form, b: &Form, contacts: &mut [Contact], margin: f64) {
    for contact in contacts {
        let exact = contact.proved && contact.order > 1;
        if let Some(sharp) = sharpened(a, b, contact, margin).filter(|_| !exact) {
            *contact = sharp;
        }
    }
}

/// Places beside a contact, which are that contact.
const BESIDE: f64 = 1e-6;

/// What comes nearer than the margin and does not meet: ends, and places inside.
fn touches(
    a: &Form,
    b: &Form,
    left: &[Window],
    turns: &[f64],
    margin: f64,
    answer: &mut Intersections,
) -> Result<()> {
    let mut places = ends(a, b, margin)?;
    let points = turns.iter().map(|t| b.at(&[*t])).collect::<Result<Vec<_>>>()?.concat();
    for (s, t) in project(a, &points, 0.0)?.parameters.iter().zip(turns) {
        let room = [*s, *t].map(|x| [(x - CLUSTER).max(0.0), (x + CLUSTER).min(1.0)]);
        let near = closest(a, b, [*s, *t], &room);
        places.push([near.s, near.t]);
    }
    for window in gathered(left) {
        let middle = window.map(|[from, to]| 0.5 * (from + to));
        let room = window.map(|[from, to]| [(from - BESIDE).max(0.0), (to + BESIDE).min(1.0)]);
        let near = closest(a, b, middle, &room);
        places.push([near.s, near.t]);
    }
    for [s, t] in places {
        let near = super::closest::at(a, b, s, t);
        let known = |c: &Contact| {
            let reach = c.error + BESIDE;
            (c.first[0] - s).abs() <= reach && (c.second[0] - t).abs() <= reach
                || stay_near(a, b, [c.first[0], c.second[0]], [s, t], margin)
        };
        let covered = |window: &Window| answer.overlaps.iter().any(|o| within(o, window));
        if near.gap > margin || answer.contacts.iter().any(known) || covered(&[[s, s], [t, t]]) {
            continue;
        }
        answer.contacts.push(Contact {
            kind: ContactKind::Touch,
            order: 0,
            gap: near.gap,
            error: BESIDE,
            proved: false,
            ..met(a, &Meeting { s, t, order: 0 })
        });
    }
    Ok(())
}
