//! What the quick search leaves over: windows that hold a tangent, a touch, or more.

use pforms_kernel::Form;

use super::closest::{Near, closest, jet};
use crate::measuring::intersect::answer::{Contact, ContactKind, Undecided};

/// Two windows of parameters.
pub(super) type Window = [[f64; 2]; 2];

/// Windows that touch or overlap as one.
pub(super) fn gathered(left: &[Window]) -> Vec<Window> {
    let mut all: Vec<Window> = Vec::new();
    for window in left {
        let mut whole = *window;
        // What it touches may touch others now: until nothing is taken in.
        while let Some(place) = all.iter().position(|other| touch(other, &whole)) {
            let other = all.swap_remove(place);
            for (ends, more) in whole.iter_mut().zip(&other) {
                *ends = [ends[0].min(more[0]), ends[1].max(more[1])];
            }
        }
        all.push(whole);
    }
    all
}

/// Room between windows that counts as none.
const BETWEEN: f64 = 1e-9;

fn touch(a: &Window, b: &Window) -> bool {
    a.iter().zip(b).all(|(x, y)| x[0] <= y[1] + BETWEEN && y[0] <= x[1] + BETWEEN)
}

/// A window below this holds one contact.
const SMALL: f64 = 1e-3;

/// A distance that may be rounding, in units of the curves.
const DOUBT: f64 = 1e-13;

/// Sines below this are those of a tangent.
const TANGENT: f64 = 1e-6;

/// The contact in a window, nothing if the curves are farther apart there than `margin`, or the
/// window, undecided.
pub(super) fn contact_in(
    a: &Form,
    b: &Form,
    window: &Window,
    margin: f64,
) -> Result<Option<Contact>, Undecided> {
    let size = window.iter().fold(0.0_f64, |most, [from, to]| most.max(to - from));
    let middle = window.map(|[from, to]| 0.5 * (from + to));
    let room = window.map(|[from, to]| {
        let more = (to - from).max(1e-9);
        [(from - more).max(0.0), (to + more).min(1.0)]
    });
    let near = closest(a, b, middle, &room);
    // Nearer than what rounding may do, and yet not within the margin: who knows?
    let doubtful = near.gap > margin && near.gap < DOUBT;
    if size > SMALL || doubtful {
        return Err(undecided(window));
    }
    Ok((near.gap <= margin).then(|| contact(a, &near, size)))
}

/// A contact where curves come near, not proved. In a plane what goes through has been found by other
/// means; in space lines that cross up to rounding are a crossing.
pub(super) fn contact(a: &Form, near: &Near, error: f64) -> Contact {
    let kind = match near {
        near if near.sine < TANGENT => ContactKind::Tangent,
        near if near.gap == 0.0 || a.ambient() > 2 => ContactKind::Crossing,
        _ => ContactKind::Touch,
    };
    Contact {
        first: vec![near.s],
        second: vec![near.t],
        point: jet(a, near.s).0,
        kind,
        order: usize::from(kind == ContactKind::Crossing),
        gap: near.gap,
        error,
        proved: false,
    }
}

/// A window as corners of a box.
pub(super) fn undecided(window: &Window) -> Undecided {
    let corners = |[from, to]: [f64; 2]| [vec![from], vec![to]];
    Undecided { first: corners(window[0]), second: corners(window[1]) }
}
