//! A curve that is a single point.

use pforms_kernel::{Form, Result};

use crate::measuring::intersect::answer::{Intersections, Overlap};
use crate::project;

/// The answer when one of the curves is a point: all of it lies in the other, or none of it.
///
/// Errors: those of projection.
pub(super) fn settled(a: &Form, b: &Form, margin: f64) -> Result<Option<Intersections>> {
    if is_point(b) {
        return Ok(Some(on(b, a, margin)?.swapped()));
    }
    if is_point(a) { on(a, b, margin).map(Some) } else { Ok(None) }
}

fn is_point(form: &Form) -> bool {
    let (width, last) = (form.width(), form.ambient());
    let first = &form.homogeneous()[..width];
    let mut poles = form.homogeneous().chunks_exact(width);
    poles.all(|pole| (0..last).all(|k| pole[k] * first[last] == first[k] * pole[last]))
}

/// The point `a` on the curve `b`, at the nearest place.
fn on(a: &Form, b: &Form, margin: f64) -> Result<Intersections> {
    let foot = project(b, &a.at(&[0.5])?, 0.0)?;
    let mut answer = Intersections { complete: true, ..Intersections::default() };
    if foot.distances[0] <= margin {
        let place = vec![foot.parameters[0]];
        answer.overlaps.push(Overlap {
            first: [vec![0.0], vec![1.0]],
            second: [place.clone(), place],
            gap: foot.distances[0],
            proved: foot.distances[0] == 0.0,
        });
        // It may lie on other places of the curve too.
        answer.complete = foot.unique[0] && foot.distances[0] == 0.0;
    }
    Ok(answer)
}
