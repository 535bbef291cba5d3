//! Any form as points.

use pforms_kernel::{Form, Result};

use crate::Sampling;
use crate::space::{embed, project, quadruples, tensor, ticks};
use crate::vector::Vec3;

/// The points of a form on the grid of its samples, for any number of axes.
///
/// Points at infinity are left out.
///
/// Errors: those of [`Sampling::segments`].
pub fn points(form: &Form, sampling: &Sampling) -> Result<Vec<Vec3>> {
    let form = embed(form)?;
    let segments = sampling.segments(&form)?;
    let lists: Vec<Vec<f64>> = segments.iter().map(|&count| ticks(count)).collect();
    let lists: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
    let values = tensor(&form, &lists, None)?;
    let finite = quadruples(&values).iter().filter(|value| value[3] != 0.0).map(project);
    Ok(finite.filter(|point| point.iter().all(|x| x.is_finite())).collect())
}
