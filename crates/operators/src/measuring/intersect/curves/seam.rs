//! Where a closed curve begins and ends: one place with two parameters.

use pforms_kernel::Result;

use super::super::answer::Intersections;
use super::super::pieces::{holds, merge};
use crate::Shape;
use crate::measuring::vector::norm;

/// Parameters this near to the end of a window, in windows, are the end.
const NEAR: f64 = 1e-11;

/// Contacts at the end of a closed curve are those at its beginning, and are told there.
///
/// Errors: those of evaluation at the ends.
pub(super) fn told_once(
    first: &Shape,
    second: &Shape,
    margin: f64,
    found: &mut Intersections,
) -> Result<()> {
    let seams = [seam(first, margin)?, seam(second, margin)?];
    let mut moved = false;
    for contact in &mut found.contacts {
        for (t, seam) in [&mut contact.first, &mut contact.second].into_iter().zip(&seams) {
            if let (Some([from, to]), [t]) = (seam, &mut t[..])
                && (*t - to).abs() <= NEAR * (to - from)
            {
                *t = *from;
                moved = true;
            }
        }
    }
    if moved {
        merge(found);
    }
    let Intersections { contacts, overlaps, .. } = found;
    contacts.retain(|contact| {
        let mut same = vec![contact.clone()];
        for (k, [from, to]) in seams.iter().enumerate().filter_map(|(k, seam)| Some((k, (*seam)?)))
        {
            for mut twin in same.clone() {
                let t = if k == 0 { &mut twin.first } else { &mut twin.second };
                if t[0] == from {
                    t[0] = to;
                    same.push(twin);
                }
            }
        }
        !overlaps.iter().any(|overlap| same.iter().any(|contact| holds(overlap, contact)))
    });
    Ok(())
}

/// The window of a curve that ends where it begins.
fn seam(shape: &Shape, margin: f64) -> Result<Option<[f64; 2]>> {
    let (window, ends) = match shape {
        Shape::Form(form) => ([0.0, 1.0], [form.at(&[0.0])?, form.at(&[1.0])?]),
        Shape::Spline(spline) => {
            let breaks = spline.breaks().swap_remove(0);
            let (Some(from), Some(to)) = (breaks.first(), breaks.last()) else { return Ok(None) };
            ([*from, *to], [spline.at(&[*from])?, spline.at(&[*to])?])
        }
    };
    let offset: Vec<f64> = ends[0].iter().zip(&ends[1]).map(|(x, y)| x - y).collect();
    Ok((norm(&offset) <= margin).then_some(window))
}
