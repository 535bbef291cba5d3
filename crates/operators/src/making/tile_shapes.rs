//! Microstructures in splines: a motif repeated over the window of a cage of many pieces.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use super::deform::{Rest, deform, windows};
use crate::{Poles, Shape, tile};

/// [`tile`] for forms and splines, in a form or a spline: the copies fill the window of the cage.
///
/// A copy is cut where it crosses a knot of the cage, so that it is exact; cells that end at the
/// knots are not cut. The copies come cell by cell, the last parameter fastest, and within a cell in
/// the given order.
///
/// Errors: `Shape` when a motif does not have one coordinate for each axis of the cage, or a count
/// is 0; `Limit`; those of [`immerse_spline`](crate::immerse_spline).
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Shape, subdivide, tile_shapes};
/// let line: Form = Form::from_points(&[2], 1, &[0., 8.], None)?;
/// let cage: Shape = subdivide(&line, &[1])?.into();
/// let motif: Shape = Form::from_points(&[2], 1, &[0., 1.], None)?.into();
/// assert_eq!(tile_shapes(&[motif], &cage, &[4])?.len(), 4);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn tile_shapes<S: Scalar>(
    cell: &[Shape<S>],
    cage: &Shape<S>,
    counts: &[usize],
) -> Result<Vec<Shape<S>>> {
    let forms: Option<Vec<Form<S>>> = cell.iter().map(as_form).collect();
    if let (Some(forms), Shape::Form(cage)) = (forms, cage) {
        return Ok(tile(&forms, cage, counts)?.into_iter().map(Shape::from).collect());
    }
    require_fit(cell, cage, counts)?;
    let windows = windows(cage);
    let mut copies = Vec::new();
    let mut index = vec![0; counts.len()];
    loop {
        for shape in cell {
            copies.push(deform(&placed(shape, &index, counts, &windows)?, cage, &Rest::Window)?);
        }
        let Some(axis) = (0..counts.len()).rfind(|k| index[*k] + 1 < counts[*k]) else {
            return Ok(copies);
        };
        index[axis] += 1;
        index[axis + 1..].fill(0);
    }
}

fn as_form<S: Scalar>(shape: &Shape<S>) -> Option<Form<S>> {
    match shape {
        Shape::Form(form) => Some(form.clone()),
        Shape::Spline(_) => None,
    }
}

fn require_fit<S: Scalar>(cell: &[Shape<S>], cage: &Shape<S>, counts: &[usize]) -> Result<()> {
    let net = cage.net();
    net.require_per_axis("counts", counts)?;
    if counts.contains(&0) {
        return Err(Error::shape("counts", format!("{counts:?}"), "at least 1"));
    }
    for shape in cell {
        let own = shape.net();
        if own.ambient() != net.axes() {
            return Err(Error::shape(
                "cell",
                format!("a {} in {}D", own.kind(), own.ambient()),
                format!("forms in {}D, the parameters of the cage", net.axes()),
            ));
        }
        // Each copy has at least the poles of its motif.
        limit::check::<S>("the tiling", &[counts, own.orders()].concat(), net.width())?;
    }
    Ok(())
}

/// The shape moved from the unit cube to box `index` of a grid of `counts` boxes over the windows.
fn placed<S: Scalar>(
    shape: &Shape<S>,
    index: &[usize],
    counts: &[usize],
    windows: &[(S, S)],
) -> Result<Shape<S>> {
    let net = shape.net();
    let mut poles = net.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(net.width()) {
        let weight = pole[net.ambient()].clone();
        for (k, x) in pole[..net.ambient()].iter_mut().enumerate() {
            let (from, to) = &windows[k];
            let shifted = x.clone() + S::from_integer(index[k] as i64) * weight.clone();
            let share = shifted / S::from_integer(counts[k] as i64);
            *x = from.clone() * weight.clone() + share * (to.clone() - from.clone());
        }
    }
    shape.with_net(Form::from_homogeneous(net.orders(), net.ambient(), poles)?)
}
