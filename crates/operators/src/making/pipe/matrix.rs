//! The spline of matrices that carries a section along.

use pforms_kernel::{Form, Result, limit};

use super::poly::Poly;
use super::shaped::Shaped;
use super::vector::Vector;
use crate::Spline;

/// Matrices with the columns and, last, the path; `closed` makes the last equal to the first.
pub(super) fn matrices(shaped: &[Shaped], rational: bool, closed: bool) -> Result<Spline> {
    let degree = degree(shaped, rational);
    let columns = shaped.first().map_or(0, |part| part.columns.len());
    let width = 4 * (columns + 1);
    let count = shaped.len() * degree + 1;
    limit::check::<f64>("the tube", &[count], width)?;
    let mut poles: Vec<f64> = Vec::with_capacity(count * width);
    let mut breaks = Vec::with_capacity(shaped.len() + 1);
    let mut factor = 1.0;
    for part in shaped {
        // Neighbours share a pole: the weights of the next are scaled to agree.
        if let Some(weight) = poles.last() {
            factor = weight / part.part.path[3].first();
            poles.truncate(poles.len() - width);
        }
        breaks.push(part.part.from);
        let entries = entries(part, degree, factor);
        for i in 0..=degree {
            poles.extend(entries.iter().map(|entry| entry.0[i]));
        }
    }
    breaks.extend(shaped.last().map(|part| part.part.to));
    if closed {
        let factor = poles[poles.len() - 1] / poles[width - 1];
        let last = poles.len() - width;
        for k in 0..width {
            poles[last + k] = factor * poles[k];
        }
    }
    let net = Form::from_homogeneous(&[count], width - 1, poles)?;
    Spline::joined(net, &[degree], &[breaks])
}

/// The degree that holds every entry.
fn degree(shaped: &[Shaped], rational: bool) -> usize {
    let path = shaped.iter().map(|part| part.part.path[0].degree()).max().unwrap_or(0);
    let columns = shaped.iter().flat_map(|part| &part.columns);
    let columns = columns.map(Vector::degree).max().unwrap_or(0);
    if rational { path + columns } else { path.max(columns).max(1) }
}

/// The entries row by row: columns times the weight beside the path, then zeros and the weight.
fn entries(part: &Shaped, degree: usize, factor: f64) -> Vec<Poly> {
    let [.., weight] = &part.part.path;
    let constant = weight.0.iter().all(|w| *w == weight.0[0]);
    let weight = if constant { Poly::constant(weight.0[0]) } else { weight.clone() };
    let weight = weight.scaled(factor);
    let mut entries = Vec::new();
    for k in 0..3 {
        for column in &part.columns {
            entries.push(column.0[k].times(&weight).raised(degree));
        }
        entries.push(part.part.path[k].scaled(factor).raised(degree));
    }
    entries.extend(part.columns.iter().map(|_| Poly::constant(0.0).raised(degree)));
    entries.push(weight.raised(degree));
    entries
}
