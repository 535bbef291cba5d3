//! Projection: the nearest points of a form, with the proof that they are.
//!
//! Newton's steps find a foot. Then every part of the window is shown to be farther, or to be a
//! region over which the square distance is convex, so that it holds no foot but this one. Both
//! are read off Bernstein coefficients: those of `|X − x·W|² − t²·W²`, positive where the form
//! `X/W` is farther than `t` from the point `x`. What cannot be shown is said: the gap.

mod cells;
mod convex;
mod descent;
mod products;
mod quick;
mod region;
mod rows;
mod search;
mod spline;
pub(super) mod target;
pub(super) mod weight;

use pforms_kernel::vectors::in_lanes;
use pforms_kernel::{Error, Form, Result, limit, threads};

use descent::Foot;
use quick::{Quick, Task};
use rows::Rows;
use search::Search;
pub use spline::SplineProjector;
use target::Target;
pub(super) use weight::{Weights, positive_weights};

/// The nearest points of a form to some points, and how sure that is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Projection {
    /// Parameters of the feet, one after another: one for each axis.
    pub parameters: Vec<f64>,
    /// The feet.
    pub points: Vec<f64>,
    /// Their distances from the points.
    pub distances: Vec<f64>,
    /// By how much any other point of the form may be nearer, at most: proved, rounding included.
    pub gaps: Vec<f64>,
    /// Is it proved that only these parameters give the nearest point?
    pub unique: Vec<bool>,
}

impl Projection {
    /// Appends the answers for more points.
    pub fn extend(&mut self, more: Self) {
        self.parameters.extend(more.parameters);
        self.points.extend(more.points);
        self.distances.extend(more.distances);
        self.gaps.extend(more.gaps);
        self.unique.extend(more.unique);
    }
}

/// The nearest points of `form` over its window, `0` to `1` on every axis, to `points`, `ambient`
/// numbers each.
///
/// Any form with a weight that does not vanish in the window. Every answer is proved: no point of
/// the form is nearer by more than the gap, which is a few roundings of the size of the form and
/// the distance; where the feet fill a curve or more (the centre of a sphere), or the form is
/// singular at the foot, the gap grows to `accuracy` times the size of the form, rarely above.
/// Feet whose distances differ by less than that are at the same distance: the first in the order of
/// the parameters is taken and is not called unique.
///
/// Errors: `Shape` when the count of `points` does not fit; `Domain` for points that are not
/// finite or beyond 10¹²⁰ sizes of the form, for a weight that vanishes or changes sign in the
/// window, for an accuracy not between 0 and 1; `Limit` and `Accuracy` for degrees whose squares
/// do not fit.
///
/// ```
/// use pforms_kernel::Form;
/// let parabola: Form = Form::from_points(&[3], 2, &[-1., 1., 0., -1., 1., 1.], None)?;
/// let foot = pforms_operators::project(&parabola, &[0., -1., 0., 3.], 1e-12)?;
/// assert_eq!(foot.parameters[0], 0.5);
/// assert_eq!(foot.points[..2], [0.0, 0.0]);
/// assert!(foot.gaps.iter().all(|gap| *gap < 1e-13));
/// assert_eq!(foot.unique, [true, false]); // (0, 3) is as near to both branches
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn project(form: &Form, points: &[f64], accuracy: f64) -> Result<Projection> {
    Projector::new(form, accuracy)?.project(points)
}

/// Where descent from some parameters ends: the distance from a point there, and the parameters.
pub(super) fn descend(form: &Form, point: &[f64], from: &[f64]) -> (f64, Vec<f64>) {
    let (lower, upper) = (vec![0.0; from.len()], vec![1.0; from.len()]);
    let foot = Foot::at(form, point, from.to_vec()).descended(form, point, &lower, &upper);
    (foot.distance, foot.parameters)
}

/// A form made ready for projection: its window in cells, and how its poles multiply.
pub struct Projector {
    form: Form,
    search: Search,
    quick: Option<Quick>,
    rows: Rows,
}

impl Projector {
    /// Makes a form ready. The `accuracy` is that of [`project`].
    ///
    /// Errors: those of [`project`] that are not of its points.
    pub fn new(form: &Form, accuracy: f64) -> Result<Self> {
        if !(0.0..=1.0).contains(&accuracy) {
            return Err(Error::domain("accuracy", accuracy, "a number from 0 to 1"));
        }
        let rows = Rows { axes: form.axes() };
        let search = Search::new(Target::new(form)?, accuracy)?;
        let quick = Quick::new(&search);
        Ok(Self { form: form.clone(), search, quick, rows })
    }

    /// [`project`] on this form.
    ///
    /// Errors: those of [`project`] that are of its points.
    pub fn project(&self, points: &[f64]) -> Result<Projection> {
        let Self { form, search, quick, rows } = self;
        let (rows, ambient) = (*rows, form.ambient());
        if !points.len().is_multiple_of(ambient) {
            let expected = format!("{ambient} for each point");
            return Err(Error::shape("points", format!("{} numbers", points.len()), expected));
        }
        let count = limit::check::<f64>("the projection", &[points.len() / ambient], rows.width())?;
        let mut numbers = vec![0.0; count];
        threads::fill_parts(&mut numbers, rows.width(), COST, |range, out| {
            let points = &points[range.start * ambient..range.end * ambient];
            match quick {
                Some(quick) => in_lanes(Task { search, quick, points, out, rows }),
                None => one_by_one(search, points, out, rows),
            }
        })?;
        rows.columns(form, &numbers)
    }
}

/// Arithmetic for one point, about.
const COST: usize = 1 << 12;

fn one_by_one(search: &Search, points: &[f64], out: &mut [f64], rows: Rows) -> Result<()> {
    let ambient = search.target.form.ambient();
    let mut placed = vec![0.0; ambient];
    for (point, row) in points.chunks_exact(ambient).zip(out.chunks_exact_mut(rows.width())) {
        search.target.place(point, &mut placed)?;
        rows.search(search, row, &placed, &search.cells.nearest(&placed));
    }
    Ok(())
}
