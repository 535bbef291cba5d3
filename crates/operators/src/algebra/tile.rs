//! Microstructures: a motif repeated in the parameter space of a cage.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use super::immerse;
use super::spline::indices;

/// The forms of a cell, drawn in the unit cube of the cage's parameters, repeated `counts[k]` times
/// along each parameter `k` and immersed in the cage.
///
/// The result lists the copies cell by cell (the last parameter fastest) and within a cell in the
/// given order. Copies that meet at a face of the cube meet in the cage: both see the parameter
/// `(1 + i)/n = (0 + (i + 1))/n`, the same number.
///
/// Errors: `Shape` when a cell form does not have one coordinate for each axis of the cage, or a
/// count is 0; `Limit` when all together are too large.
pub fn tile<S: Scalar>(cell: &[Form<S>], cage: &Form<S>, counts: &[usize]) -> Result<Vec<Form<S>>> {
    cage.require_per_axis("counts", counts)?;
    if counts.contains(&0) {
        return Err(Error::shape("counts", format!("{counts:?}"), "at least 1"));
    }
    for form in cell {
        if form.ambient() != cage.axes() {
            return Err(Error::shape(
                "cell",
                format!("a {} in {}D", form.kind(), form.ambient()),
                format!("forms in {}D, the parameters of the cage", cage.axes()),
            ));
        }
        let one = super::forecast::<S>(form.orders(), cage.orders(), cage.ambient());
        let mut all = counts.to_vec();
        all.extend(one.orders);
        limit::check::<S>("the tiling", &all, cage.width())?;
    }
    let mut copies = Vec::new();
    for index in indices(counts) {
        for form in cell {
            copies.push(immerse(&placed(form, &index, counts)?, cage)?);
        }
    }
    Ok(copies)
}

/// The form moved from the unit cube to box `index` of a grid of `counts` boxes.
fn placed<S: Scalar>(form: &Form<S>, index: &[usize], counts: &[usize]) -> Result<Form<S>> {
    let mut poles = form.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(form.width()) {
        let weight = pole[form.ambient()].clone();
        for (x, (&i, &count)) in pole.iter_mut().zip(index.iter().zip(counts)) {
            let shifted = x.clone() + S::from_integer(i as i64) * weight.clone();
            *x = shifted / S::from_integer(count as i64);
        }
    }
    Form::from_homogeneous(form.orders(), form.ambient(), poles)
}
