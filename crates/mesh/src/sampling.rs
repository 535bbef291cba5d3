//! How finely a form is sampled.

use pforms_kernel::{Error, Form, Result};

use crate::deviation::Deviation;
use crate::pieces::{finite_pieces, refined};
use crate::room::require_room;
use crate::space::embed;

/// The finest recursion level: 2²⁴ halves along one axis.
const MAX_FINENESS: u32 = 24;

/// Halvings along each axis before the bound is taken. The first saves up to half of the
/// triangles of the teapot, further ones next to none.
const REFINEMENT: u32 = 1;

/// How finely a form is sampled: by halving its window, or by how far facets may stray from it.
#[derive(Clone, Debug, PartialEq)]
pub enum Sampling {
    /// Recursion level `r`: `2^r + 1` samples; one for all axes, or one for each.
    Fineness(Vec<u32>),
    /// So many equal cells; one number for all axes, or one for each. Of a surface, every cell is
    /// two triangles, those without area too.
    Segments(Vec<usize>),
    /// The greatest distance between the form and its facets, in the units of the form.
    Tolerance(f64),
}

impl Default for Sampling {
    fn default() -> Self {
        Self::Fineness(vec![4])
    }
}

impl Sampling {
    /// Number of equal cells along each axis of `form`.
    ///
    /// With a tolerance, every point of the form lies within it of the facet over its cell, and
    /// the number never falls short; it may be a few times more than needed.
    ///
    /// Errors: `Shape` when the levels or counts are not one for each axis; `Domain` for a level above
    /// 24, a count of 0, a tolerance that is not positive, or a weight that vanishes in the window; `Limit`.
    pub fn segments(&self, form: &Form) -> Result<Vec<usize>> {
        let segments = match self {
            Self::Fineness(levels) => halvings(form, levels)?,
            Self::Segments(counts) => counted(form, counts)?,
            Self::Tolerance(tolerance) => within(form, *tolerance)?,
        };
        let counts: Vec<usize> = segments.iter().map(|count| count.saturating_add(1)).collect();
        require_room("the drawing", &counts)?;
        Ok(segments)
    }
}

fn halvings(form: &Form, levels: &[u32]) -> Result<Vec<usize>> {
    if let Some(level) = levels.iter().find(|&&level| level > MAX_FINENESS) {
        return Err(Error::domain("fineness", level, format!("0 to {MAX_FINENESS}")));
    }
    if let [one] = levels {
        return Ok(vec![1 << one; form.axes()]);
    }
    form.require_per_axis("fineness", levels)?;
    Ok(levels.iter().map(|level| 1 << level).collect())
}

fn counted(form: &Form, counts: &[usize]) -> Result<Vec<usize>> {
    if counts.contains(&0) {
        return Err(Error::domain("segments", 0, "1 or more"));
    }
    if let [one] = counts {
        return Ok(vec![*one; form.axes()]);
    }
    form.require_per_axis("segments", counts)?;
    Ok(counts.to_vec())
}

fn within(form: &Form, tolerance: f64) -> Result<Vec<usize>> {
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(Error::domain("tolerance", tolerance, "a positive length"));
    }
    let pieces = refined(finite_pieces(&embed(form)?)?, REFINEMENT)?;
    let counts = Deviation::of(&pieces, form.axes())?.segments(tolerance);
    // A count beyond the cap is refused by the caller; here it must only survive the cast.
    Ok(counts.iter().map(|count| count.min(1e15) as usize).collect())
}
