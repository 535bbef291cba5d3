//! Evaluate many points in `f64`, without an allocation per point.

use crate::basis::bernstein_row_into;
use crate::jet::unreachable;
use crate::lanes::{Blocks, LANES};
use crate::{Error, Form, Result, bernstein_row, limit};

impl Form<f64> {
    /// Euclidean points on the grid of the given parameters, one list for each axis.
    ///
    /// The result has shape `(len₀, len₁, …, ambient)`, C order.
    ///
    /// Errors: `Shape`; `Domain` where the weight vanishes, a coordinate overflows or a parameter is
    /// not finite; `Limit`.
    pub fn grid(&self, parameters: &[&[f64]]) -> Result<Vec<f64>> {
        self.require_per_axis("parameters", parameters)?;
        let counts: Vec<usize> = parameters.iter().map(|list| list.len()).collect();
        let mut out = vec![0.0; limit::check::<f64>("the grid", &counts, self.ambient())?];
        self.grid_into(parameters, &mut out)?;
        Ok(out)
    }

    /// [`Form::grid`] into an array of the caller's.
    ///
    /// The first axes are contracted once for each of their samples; only the last is summed
    /// for each point, together with the projection.
    pub fn grid_into(&self, parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
        self.require_per_axis("parameters", parameters)?;
        let counts: usize = parameters.iter().map(|list| list.len()).product();
        require_output(out, counts * self.ambient())?;
        for list in parameters {
            require_finite_list(list)?;
        }
        if counts == 0 {
            return Ok(());
        }
        let row = |(list, order): (&&[f64], &usize)| {
            list.iter().flat_map(|t| bernstein_row(order - 1, t)).collect()
        };
        let rows = parameters.iter().zip(self.orders()).map(row).collect();
        let grid = Grid { form: self, rows, uniform: self.uniform_weight().copied() };
        grid.descend(self.homogeneous(), 0, &mut Vec::new(), out)
    }

    /// Euclidean points at scattered parameters: `parameters[k][i]` is parameter `k` of point `i`.
    ///
    /// Errors: as [`Form::grid`]; `Shape` when the lists have different lengths.
    pub fn scattered(&self, parameters: &[&[f64]]) -> Result<Vec<f64>> {
        let count = parameters.first().map_or(1, |list| list.len());
        let mut out = vec![0.0; limit::check::<f64>("the batch", &[count], self.ambient())?];
        self.scattered_into(parameters, &mut out)?;
        Ok(out)
    }

    /// [`Form::scattered`] into an array of the caller's.
    pub fn scattered_into(&self, parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
        let count = self.require_batch(parameters, out, self.ambient())?;
        let whole = self.write_blocks(parameters, count, out)?;
        let rest: Vec<&[f64]> = parameters.iter().map(|list| &list[whole..]).collect();
        let mut batch = Batch::default();
        let ambient = self.ambient();
        self.each_scattered(&rest, &mut out[whole * ambient..], ambient, |form, at, part| {
            project(batch.homogeneous(form, at), part)
        })
    }

    /// Evaluates as many points as fill whole blocks of lanes; tells how many.
    fn write_blocks(&self, parameters: &[&[f64]], count: usize, out: &mut [f64]) -> Result<usize> {
        let Some(mut blocks) = Blocks::new(self) else { return Ok(0) };
        let whole = count / LANES * LANES;
        let parts = out.chunks_exact_mut(LANES * self.ambient());
        for (start, part) in (0..whole).step_by(LANES).zip(parts) {
            blocks.write(parameters, start, part)?;
        }
        Ok(whole)
    }

    /// Complains unless the lists have one length and fit `out`; gives that length.
    fn require_batch(&self, parameters: &[&[f64]], out: &[f64], width: usize) -> Result<usize> {
        self.require_per_axis("parameters", parameters)?;
        let count = parameters.first().map_or(1, |list| list.len());
        for list in parameters {
            if list.len() != count {
                return Err(Error::shape(
                    "parameters",
                    format!("lists of {count} and {}", list.len()),
                    "lists of one length",
                ));
            }
            require_finite_list(list)?;
        }
        require_output(out, count * width)?;
        Ok(count)
    }

    /// Calls `visit(form, parameters, numbers)` for each of the points.
    ///
    /// `width` numbers of `out` belong to each. Errors: `Shape`, and those of `visit`.
    pub fn each_scattered(
        &self,
        parameters: &[&[f64]],
        out: &mut [f64],
        width: usize,
        mut visit: impl FnMut(&Self, &[f64], &mut [f64]) -> Result<()>,
    ) -> Result<()> {
        self.require_batch(parameters, out, width)?;
        let mut at = vec![0.0; self.axes()];
        for (i, part) in out.chunks_exact_mut(width).enumerate() {
            for (t, list) in at.iter_mut().zip(parameters) {
                *t = list[i];
            }
            visit(self, &at, part)?;
        }
        Ok(())
    }
}

/// A form with the basis values of a grid, and the weight that all its poles have, if they have one.
struct Grid<'a> {
    form: &'a Form<f64>,
    rows: Vec<Vec<f64>>,
    uniform: Option<f64>,
}

impl Grid<'_> {
    /// Contracts axis `axis` with each of its rows and goes on with the rest of the axes.
    fn descend(
        &self,
        poles: &[f64],
        axis: usize,
        scratch: &mut Vec<Vec<f64>>,
        out: &mut [f64],
    ) -> Result<()> {
        let Some(&order) = self.form.orders().get(axis) else {
            return project(poles, out);
        };
        let rows = &self.rows[axis];
        let samples = rows.len() / order;
        let share = out.len() / samples;
        let inner = poles.len() / order;
        if axis + 1 == self.rows.len() {
            return sum_rows(poles, rows, order, self.uniform, out);
        }
        let mut line = scratch.pop().unwrap_or_default();
        for (row, part) in rows.chunks_exact(order).zip(out.chunks_exact_mut(share)) {
            combine(row, poles, inner, &mut line);
            self.descend(&line, axis + 1, scratch, part)?;
        }
        scratch.push(line);
        Ok(())
    }
}

/// Buffers for evaluating one point after another without allocating.
#[derive(Default)]
pub struct Batch {
    row: Vec<f64>,
    from: Vec<f64>,
    to: Vec<f64>,
}

impl Batch {
    /// The homogeneous point of `form` at `parameters`, which must be finite and one for each axis.
    pub fn homogeneous(&mut self, form: &Form<f64>, parameters: &[f64]) -> &[f64] {
        self.from.clear();
        self.from.extend_from_slice(form.homogeneous());
        for (t, order) in parameters.iter().zip(form.orders()) {
            bernstein_row_into(order - 1, t, &mut self.row);
            combine(&self.row, &self.from, self.from.len() / order, &mut self.to);
            std::mem::swap(&mut self.from, &mut self.to);
        }
        if let Some(weight) = form.uniform_weight() {
            self.from[form.ambient()] = *weight;
        }
        &self.from
    }
}

/// `line = Σ row[j] · poles[j]`, lines of `inner` numbers.
fn combine(row: &[f64], poles: &[f64], inner: usize, line: &mut Vec<f64>) {
    line.clear();
    line.resize(inner, 0.0);
    add_lines(row, poles, line);
}

/// `line += Σ row[j] · poles[j]`.
pub(crate) fn add_lines(row: &[f64], poles: &[f64], line: &mut [f64]) {
    for (coefficient, pole) in row.iter().zip(poles.chunks_exact(line.len())) {
        for (sum, x) in line.iter_mut().zip(pole) {
            *sum += coefficient * x;
        }
    }
}

/// Sums and projects the poles of a curve for every row of basis values; `uniform` is the weight
/// that all poles of the form have, if they have one.
fn sum_rows(
    poles: &[f64],
    rows: &[f64],
    order: usize,
    uniform: Option<f64>,
    out: &mut [f64],
) -> Result<()> {
    match poles.len() / order {
        3 => sum_rows_of::<3>(poles, rows, order, uniform, out),
        4 => sum_rows_of::<4>(poles, rows, order, uniform, out),
        width => {
            let mut point = Vec::new();
            for (row, part) in rows.chunks_exact(order).zip(out.chunks_exact_mut(width - 1)) {
                combine(row, poles, width, &mut point);
                point[width - 1] = uniform.unwrap_or(point[width - 1]);
                project(&point, part)?;
            }
            Ok(())
        }
    }
}

/// The same with the width known to the compiler, so that a point stays in registers.
fn sum_rows_of<const W: usize>(
    poles: &[f64],
    rows: &[f64],
    order: usize,
    uniform: Option<f64>,
    out: &mut [f64],
) -> Result<()> {
    let (poles, _) = poles.as_chunks::<W>();
    for (row, part) in rows.chunks_exact(order).zip(out.chunks_exact_mut(W - 1)) {
        let mut point = [0.0; W];
        for (coefficient, pole) in row.iter().zip(poles) {
            for k in 0..W {
                point[k] += coefficient * pole[k];
            }
        }
        point[W - 1] = uniform.unwrap_or(point[W - 1]);
        project(&point, part)?;
    }
    Ok(())
}

/// Divides by the weight. `0·x` is 0 unless `x` is infinite or NaN, so one sum sees them all: a
/// weight that vanishes too, which leaves nothing finite.
#[inline]
fn project(point: &[f64], out: &mut [f64]) -> Result<()> {
    let (coordinates, weight) = point.split_at(out.len());
    let mut guard = 0.0 * weight[0];
    for (x, coordinate) in out.iter_mut().zip(coordinates) {
        *x = coordinate / weight[0];
        guard += 0.0 * *x;
    }
    if guard == 0.0 { Ok(()) } else { Err(unreachable(&weight[0])) }
}

fn require_output(out: &[f64], expected: usize) -> Result<()> {
    if out.len() == expected {
        return Ok(());
    }
    Err(Error::shape("out", format!("{} numbers", out.len()), format!("{expected}")))
}

fn require_finite_list(list: &[f64]) -> Result<()> {
    match list.iter().find(|t| !t.is_finite()) {
        None => Ok(()),
        Some(t) => Err(Error::domain("parameters", t, "finite numbers")),
    }
}
