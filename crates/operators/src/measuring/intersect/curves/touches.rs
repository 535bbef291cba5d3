//! What comes nearer than the margin and does not meet: ends, and places inside.

use pforms_kernel::{Form, Result};

use super::closest::{at, closest};
use super::leftover::{Window, contact, gathered};
use super::overlap::ends;
use super::settle::{met, within};
use crate::measuring::intersect::answer::{Contact, ContactKind, Intersections};
use crate::measuring::intersect::exact::Meeting;
use crate::project;

/// Places beside a contact, which are that contact.
const BESIDE: f64 = 1e-6;

/// Around a place where the equation turns the nearest one is looked for so far.
const ROOM: f64 = 0.05;

/// Adds the places where the curves come nearer than the margin that are no part of a contact or an
/// overlap: those at ends, at `turns` of the equation, and in the windows that are `left`. What meets in a
/// `plane` is known, in space not quite.
///
/// Errors: those of projection on either curve.
pub(super) fn touches(
    a: &Form,
    b: &Form,
    left: &[Window],
    turns: &[f64],
    plane: bool,
    margin: f64,
    answer: &mut Intersections,
) -> Result<()> {
    let mut places = ends(a, b, margin)?;
    let points = turns.iter().map(|t| b.at(&[*t])).collect::<Result<Vec<_>>>()?.concat();
    for (s, t) in project(a, &points, 0.0)?.parameters.iter().zip(turns) {
        let room = [*s, *t].map(|x| [(x - ROOM).max(0.0), (x + ROOM).min(1.0)]);
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
        let near = at(a, b, s, t);
        let known = |c: &Contact| {
            let reach = c.error + BESIDE;
            (c.first[0] - s).abs() <= reach && (c.second[0] - t).abs() <= reach
                || stay_near(a, b, [c.first[0], c.second[0]], [s, t], margin)
        };
        let covered = |window: &Window| answer.overlaps.iter().any(|o| within(o, window));
        if near.gap > margin || answer.contacts.iter().any(known) || covered(&[[s, s], [t, t]]) {
            continue;
        }
        answer.contacts.push(match plane {
            true => Contact {
                kind: ContactKind::Touch,
                gap: near.gap,
                error: BESIDE,
                proved: false,
                ..met(a, &Meeting { s, t, order: 0 })
            },
            false => contact(a, &near, BESIDE),
        });
    }
    Ok(())
}

/// Between two places the curves are compared at so many.
const STEPS: usize = 16;

/// Do the curves stay within the margin from one place to another?
pub(super) fn stay_near(
    a: &Form,
    b: &Form,
    [s, t]: [f64; 2],
    [u, v]: [f64; 2],
    margin: f64,
) -> bool {
    // In an order that soon comes to a place where they do not.
    (1..STEPS).all(|i| {
        let share = (i * 7 % STEPS) as f64 / STEPS as f64;
        let (s, middle) = (s + share * (u - s), t + share * (v - t));
        let window = [[s, s], [t.min(v), t.max(v)]];
        closest(a, b, [s, middle], &window).gap <= margin
    })
}
