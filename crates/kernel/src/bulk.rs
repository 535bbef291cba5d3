//! Evaluate many points in `f64`, without an allocation per point.

use crate::basis::bernstein_row_into;
use crate::bulk_grid::Grids;
use crate::bulk_scattered::write_scattered;
use crate::jet::unreachable;
use crate::planar::doubt;
use crate::threads::fill_parts;
use crate::vectors::in_lanes;
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
    pub fn grid_into(&self, parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
        grids_into(&[self], parameters, out)
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
        self.require_batch(parameters, out, self.ambient())?;
        fill_parts(out, self.ambient(), self.cost(), |points, out| {
            let parameters: Vec<&[f64]> =
                parameters.iter().map(|list| &list[points.clone()]).collect();
            write_scattered(self, &parameters, out)
        })
    }

    /// About how many operations a point takes.
    fn cost(&self) -> usize {
        2 * self.homogeneous().len()
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

/// The points of many forms on one grid, a list of parameters for each axis.
///
/// `out` takes a grid for each form, in C order: `(forms, len₀, len₁, …, ambient)`. Forms of the
/// same orders in a row share their basis values.
///
/// Errors: as [`Form::grid`]; `Shape` when a form has another number of axes or another dimension
/// than the first.
///
/// ```
/// use pforms_kernel::{Form, grids_into};
/// let rising: Form = Form::from_points(&[2], 1, &[0., 1.], None)?;
/// let falling = Form::from_points(&[2], 1, &[1., 0.], None)?;
/// let mut out = [0.0; 6];
/// grids_into(&[&rising, &falling], &[&[0.0, 0.25, 1.0]], &mut out)?;
/// assert_eq!(out, [0.0, 0.25, 1.0, 1.0, 0.75, 0.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn grids_into(forms: &[&Form<f64>], parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
    let Some(first) = forms.first() else { return require_output(out, 0) };
    for form in forms {
        form.require_per_axis("parameters", parameters)?;
        require_dimension(form, first)?;
    }
    let ambient = first.ambient();
    let points: usize = parameters.iter().map(|list| list.len()).product();
    require_output(out, forms.len() * points * ambient)?;
    parameters.iter().try_for_each(|list| require_finite_list(list))?;
    if points == 0 {
        return Ok(());
    }
    if let Some(long) = parameters.iter().rposition(|list| list.len() > 1)
        && long + 1 < parameters.len()
    {
        let (parameters, ends) = parameters.split_at(long + 1);
        let sections: Vec<Form<f64>> =
            forms.iter().map(|form| section(form, ends)).collect::<Result<_>>()?;
        return grids_into(&sections.iter().collect::<Vec<_>>(), parameters, out);
    }
    if forms.len() > 1 {
        return fill_parts(out, points * ambient, points * first.cost(), |range, out| {
            in_lanes(Grids { forms: &forms[range], parameters, out })
        });
    }
    // The first axes of a single sample leave the parts of the next one side by side.
    let axis = parameters.iter().position(|list| list.len() > 1).unwrap_or(0);
    let Some(list) = parameters.get(axis) else {
        return in_lanes(Grids { forms, parameters, out });
    };
    let share = points / list.len();
    fill_parts(out, share * ambient, share * first.cost(), |range, out| {
        let mut parameters = parameters.to_vec();
        parameters[axis] = &list[range];
        in_lanes(Grids { forms, parameters: &parameters, out })
    })
}

/// The form at single samples of its last axes: those before run in lanes then.
fn section(form: &Form<f64>, ends: &[&[f64]]) -> Result<Form<f64>> {
    let mut section = form.clone();
    for list in ends.iter().rev() {
        let axis = section.axes() - 1;
        let row = bernstein_row(section.orders()[axis] - 1, &list[0]);
        section = section.contract(axis, &row).map_err(|_| unreachable(&1.0))?;
    }
    Ok(match form.uniform_weight() {
        Some(weight) => section.with_uniform_weight(weight),
        None => section,
    })
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

fn require_dimension(form: &Form<f64>, first: &Form<f64>) -> Result<()> {
    if form.ambient() == first.ambient() {
        return Ok(());
    }
    Err(Error::shape(
        "forms",
        format!("forms in dimensions {} and {}", first.ambient(), form.ambient()),
        "forms in one space",
    ))
}

fn require_output(out: &[f64], expected: usize) -> Result<()> {
    if out.len() == expected {
        return Ok(());
    }
    Err(Error::shape("out", format!("{} numbers", out.len()), format!("{expected}")))
}

fn require_finite_list(list: &[f64]) -> Result<()> {
    if list.iter().fold(0, |doubts, t| doubts | doubt(*t)) == 0 {
        return Ok(());
    }
    match list.iter().find(|t| !t.is_finite()) {
        None => Ok(()),
        Some(t) => Err(Error::domain("parameters", t, "finite numbers")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vectors::{MOST, WIDTH};

    fn wavy(orders: &[usize], ambient: usize, rational: bool) -> Form<f64> {
        let count: usize = orders.iter().product();
        let points: Vec<f64> = (0..count * ambient).map(|k| (k as f64 * 1.7).sin()).collect();
        let weights: Vec<f64> = (0..count).map(|k| 1.3 + (k as f64 * 2.3).cos()).collect();
        Form::from_points(orders, ambient, &points, rational.then_some(&weights)).unwrap()
    }

    fn bits(numbers: &[f64]) -> Vec<u64> {
        numbers.iter().map(|x| x.to_bits()).collect()
    }

    /// Fills so many numbers in plain numbers and in vectors of every width that there is.
    fn assert_same_bits(count: usize, fill: impl Fn(&mut [f64])) {
        let [plain, narrow, widest] = [1, 4, MOST].map(|width| {
            let mut out = vec![0.0; count];
            WIDTH.set(width);
            fill(&mut out);
            bits(&out)
        });
        WIDTH.set(MOST);
        assert!(plain == narrow && narrow == widest);
    }

    #[test]
    fn vectors_of_any_width_give_the_same_bits() {
        let shapes: [&[usize]; 10] = [
            &[1],
            &[4],
            &[9],
            &[4, 4],
            &[2, 3],
            &[3, 3],
            &[4, 4, 4],
            &[2, 2, 2],
            &[3, 2, 4],
            &[2, 1, 3, 2],
        ];
        for (orders, ambient) in
            shapes.into_iter().flat_map(|orders| [1, 2, 3, 5].map(|c| (orders, c)))
        {
            for rational in [false, true] {
                let form = wavy(orders, ambient, rational);
                let list: Vec<f64> = (0..19).map(|k| (f64::from(k) * 0.37).fract()).collect();
                let lists = vec![&list[..]; orders.len()];
                let few: Vec<&[f64]> = lists.iter().map(|list| &list[..5]).collect();
                assert_same_bits(19 * ambient, |out| form.scattered_into(&lists, out).unwrap());
                let count = 5_usize.pow(orders.len() as u32) * ambient;
                assert_same_bits(count, |out| form.grid_into(&few, out).unwrap());
            }
        }
    }

    #[test]
    fn single_samples_of_the_last_axes_are_taken_first() {
        for rational in [false, true] {
            let form = wavy(&[4, 3, 5], 3, rational);
            let long: Vec<f64> = (0..40).map(|k| f64::from(k) / 39.0).collect();
            let grid = form.grid(&[&long, &[0.3], &[0.7]]).unwrap();
            for (u, point) in long.iter().zip(grid.chunks(3)) {
                for (x, y) in form.at(&[*u, 0.3, 0.7]).unwrap().iter().zip(point) {
                    // Three sums of at most 5 terms, in another order of rounding.
                    assert!((x - y).abs() <= 32.0 * f64::EPSILON);
                }
            }
        }
        let huge = wavy(&[2, 4], 3, false).grid(&[&[0.0, 1.0], &[1e200]]);
        assert_eq!(huge.unwrap_err().family(), "Domain");
    }

    #[test]
    fn families_are_grids_one_after_another() {
        let forms = [wavy(&[4, 4], 3, true), wavy(&[4, 4], 3, false), wavy(&[3, 2], 3, true)];
        let lists = [vec![0.0, 0.3, 1.0], (0..700).map(|k| f64::from(k) / 699.0).collect()];
        let lists: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
        let single: Vec<f64> = forms.iter().flat_map(|form| form.grid(&lists).unwrap()).collect();
        let mut all = vec![0.0; single.len()];
        grids_into(&forms.each_ref(), &lists, &mut all).unwrap();
        assert_eq!(bits(&all), bits(&single));
        let flat = wavy(&[2, 2], 2, false);
        assert_eq!(
            grids_into(&[&forms[0], &flat], &lists, &mut all).unwrap_err().family(),
            "Shape"
        );
        assert_eq!(grids_into(&[], &lists, &mut all).unwrap_err().family(), "Shape");
    }

    #[test]
    fn parts_on_threads_leave_no_trace() {
        let form = wavy(&[6, 5], 3, true);
        let list: Vec<f64> = (0..1003).map(|k| f64::from(k) / 1002.0).collect();
        let grid = form.grid(&[&list, &list]).unwrap();
        let mut serial = vec![0.0; grid.len()];
        in_lanes(Grids { forms: &[&form], parameters: &[&list, &list], out: &mut serial }).unwrap();
        assert_eq!(bits(&grid), bits(&serial));
        let long: Vec<f64> = (0..300_000).map(|k| f64::from(k) / 3e5).collect();
        let batch = form.scattered(&[&long, &long]).unwrap();
        let mut serial = vec![0.0; batch.len()];
        write_scattered(&form, &[&long, &long], &mut serial).unwrap();
        assert_eq!(bits(&batch), bits(&serial));
    }

    #[test]
    fn a_long_curve_is_right_everywhere() {
        for order in [3, 12, 90] {
            let curve = wavy(&[order], 2, true);
            let list: Vec<f64> = (0..600).map(|k| f64::from(k) / 599.0).collect();
            let points = curve.grid(&[&list]).unwrap();
            for (t, point) in list.iter().zip(points.chunks(2)) {
                for (x, y) in curve.at(&[*t]).unwrap().iter().zip(point) {
                    // Two sums of `order` positive terms each, in another order of rounding.
                    assert!((x - y).abs() <= 8.0 * order as f64 * f64::EPSILON);
                }
            }
        }
    }
}
