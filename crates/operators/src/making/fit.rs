//! The form of given orders nearest to data points, in the sense of least squares.

use nalgebra::DMatrix;
use pforms_kernel::{Error, Form, Result, bernstein_row, limit};

use super::fit_parameters::{Grid, Parameters, distance, require_lists};
use super::least_squares::solve;

/// What a fit is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct FitOptions {
    /// Order of the result along each axis.
    pub orders: Vec<usize>,
    /// Parameters of the data, or how to find them.
    pub parameters: Parameters,
    /// One weight for each data point, at least 0: its square distance counts so many times.
    pub weights: Option<Vec<f64>>,
    /// Pass exactly through the first and last point of every axis (for a grid, its corners).
    /// The parameters of each axis must then run from 0 to 1.
    pub ends: bool,
}

impl FitOptions {
    /// Orders alone: chord parameters, equal weights, free ends.
    pub fn new(orders: &[usize]) -> Self {
        Self {
            orders: orders.to_vec(),
            parameters: Parameters::default(),
            weights: None,
            ends: false,
        }
    }
}

/// A fitted form and how near it comes.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The polynomial form.
    pub form: Form,
    /// The parameters of the data: a list for each axis.
    pub parameters: Vec<Vec<f64>>,
    /// Largest distance between a data point and the form at its parameters.
    pub max_error: f64,
    /// Root of the mean square of these distances, weights not counted.
    pub rms_error: f64,
}

/// Fits a form to `points` of `shape` `(m₁, …, m_d, c)` on a grid, or `(m, c)` scattered.
///
/// Grids are solved axis by axis, which is the least-squares solution of the whole; a weighted
/// grid and scattered points (parameters given) in one system. Orthogonal triangles, no normal
/// equations: relative errors near `10⁻¹⁵` times the condition of the Bernstein matrix.
///
/// Errors: `Degenerate` with fewer data than poles or coincident parameters; `Domain` for numbers
/// that are not finite and for negative weights; `Shape` when lengths do not fit, or ends are asked
/// of scattered points or of weighted grids; `Limit`.
///
/// ```
/// use pforms_operators::{FitOptions, Parameters, fit};
/// let points = [0., 0., 1., 0.9, 2., 1.1, 3., 0.];
/// let options = FitOptions { parameters: Parameters::Uniform, ends: true, ..FitOptions::new(&[3]) };
/// let near = fit(&points, &[4, 2], &options)?;
/// assert_eq!(near.form.kind().to_string(), "pL3");
/// assert!(near.max_error < 0.11);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn fit(points: &[f64], shape: &[usize], options: &FitOptions) -> Result<Fit> {
    let (counts, ambient) = checked_shape(points, shape)?;
    let orders = &options.orders;
    check_orders(orders, counts)?;
    check_weights(options, counts)?;
    let grid = Grid { points, counts, ambient };
    let gridded = counts.len() == orders.len();
    if gridded {
        require_enough(orders, counts)?;
    }
    let parameters = match &options.parameters {
        parameters if gridded => parameters.of_grid(&grid)?,
        Parameters::Given(lists) => {
            require_lists(lists, &vec![counts[0]; orders.len()])?;
            lists.clone()
        }
        _ => return Err(scattered_needs_parameters(orders.len())),
    };
    let separable = gridded && (orders.len() == 1 || options.weights.is_none());
    let poles = if separable {
        fit_grid(&grid, &parameters, options)?
    } else if options.ends {
        return Err(ends_refused());
    } else {
        let lists = if gridded { expanded(&parameters, counts) } else { parameters.clone() };
        fit_scattered(&grid, &lists, options)?
    };
    let form = Form::from_points(orders, ambient, &poles, None)?;
    report(form, parameters, &grid, gridded)
}

fn report(form: Form, parameters: Vec<Vec<f64>>, grid: &Grid, gridded: bool) -> Result<Fit> {
    let lists: Vec<&[f64]> = parameters.iter().map(Vec::as_slice).collect();
    let reached = if gridded { form.grid(&lists)? } else { form.scattered(&lists)? };
    let (mut max_error, mut squares) = (0.0_f64, 0.0);
    let pairs = reached.chunks_exact(grid.ambient).zip(grid.points.chunks_exact(grid.ambient));
    let count = pairs.len() as f64;
    for (there, wanted) in pairs {
        let error = distance(there, wanted);
        max_error = max_error.max(error);
        squares += error * error;
    }
    Ok(Fit { form, parameters, max_error, rms_error: (squares / count).sqrt() })
}

/// Axis by axis: data of shape `(·, m, inner)` become poles `(·, n, inner)`.
fn fit_grid(grid: &Grid, parameters: &[Vec<f64>], options: &FitOptions) -> Result<Vec<f64>> {
    let mut array = grid.points.to_vec();
    let mut inner = grid.ambient;
    for (list, &order) in parameters.iter().zip(&options.orders).rev() {
        let rows = list.len();
        let columns = DMatrix::from_fn(rows, array.len() / rows, |i, k| {
            array[(k / inner * rows + i) * inner + k % inner]
        });
        let basis = basis(list, order);
        let poles = match &options.weights {
            _ if options.ends => fit_between_ends(list, &basis, columns, options)?,
            weights => weighted_solve(basis, columns, weights.as_deref())?,
        };
        array = (0..poles.len())
            .map(|flat| {
                let (outer, rest) = (flat / (order * inner), flat % (order * inner));
                poles[(rest / inner, outer * inner + rest % inner)]
            })
            .collect();
        inner *= order;
    }
    Ok(array)
}

fn basis(list: &[f64], order: usize) -> DMatrix<f64> {
    let rows: Vec<Vec<f64>> = list.iter().map(|t| bernstein_row(order - 1, t)).collect();
    DMatrix::from_fn(list.len(), order, |i, j| rows[i][j])
}

/// The first and last pole are data; the others solve what is left.
fn fit_between_ends(
    list: &[f64],
    basis: &DMatrix<f64>,
    columns: DMatrix<f64>,
    options: &FitOptions,
) -> Result<DMatrix<f64>> {
    let (rows, order) = basis.shape();
    if order < 2 || rows < order {
        return Err(Error::degenerate(
            "points",
            format!("{rows} points for {order} poles with fixed ends"),
            "at least two poles, and as many points as poles",
        ));
    }
    if list[0] != 0.0 || list[rows - 1] != 1.0 {
        return Err(Error::domain(
            "parameters",
            format!("parameters from {} to {} with fixed ends", list[0], list[rows - 1]),
            "parameters from 0 to 1",
        ));
    }
    let mut poles = DMatrix::zeros(order, columns.ncols());
    poles.set_row(0, &columns.row(0));
    poles.set_row(order - 1, &columns.row(rows - 1));
    if order > 2 {
        let rest = columns - basis * &poles;
        let inside = basis.columns(1, order - 2).into_owned();
        let solved = weighted_solve(inside, rest, options.weights.as_deref())?;
        poles.rows_mut(1, order - 2).copy_from(&solved);
    }
    Ok(poles)
}

fn weighted_solve(
    mut basis: DMatrix<f64>,
    mut columns: DMatrix<f64>,
    weights: Option<&[f64]>,
) -> Result<DMatrix<f64>> {
    for (i, weight) in weights.unwrap_or_default().iter().enumerate() {
        basis.row_mut(i).scale_mut(weight.sqrt());
        columns.row_mut(i).scale_mut(weight.sqrt());
    }
    solve(basis, columns)
}

/// One system for all points: a row for each, a column for each pole.
fn fit_scattered(grid: &Grid, lists: &[Vec<f64>], options: &FitOptions) -> Result<Vec<f64>> {
    let (ambient, orders) = (grid.ambient, &options.orders);
    let count = grid.points.len() / ambient;
    let poles: usize = orders.iter().product();
    limit::check::<f64>("the fit", &[count, poles], 1)?;
    let mut matrix = DMatrix::zeros(count, poles);
    for i in 0..count {
        let mut row = vec![1.0];
        for (list, order) in lists.iter().zip(orders) {
            let next = bernstein_row(order - 1, &list[i]);
            row = row.iter().flat_map(|a| next.iter().map(move |b| a * b)).collect();
        }
        row.iter().enumerate().for_each(|(j, value)| matrix[(i, j)] = *value);
    }
    let columns = DMatrix::from_row_slice(count, ambient, grid.points);
    let solution = weighted_solve(matrix, columns, options.weights.as_deref())?;
    Ok(solution.transpose().as_slice().to_vec())
}

/// Parameters of every point of a grid, one list for each axis.
fn expanded(lists: &[Vec<f64>], counts: &[usize]) -> Vec<Vec<f64>> {
    let total: usize = counts.iter().product();
    let mut stride = total;
    lists
        .iter()
        .map(|list| {
            stride /= list.len();
            (0..total).map(|i| list[i / stride % list.len()]).collect()
        })
        .collect()
}

fn checked_shape<'a>(points: &[f64], shape: &'a [usize]) -> Result<(&'a [usize], usize)> {
    let count = shape.iter().try_fold(1_usize, |product, &n| product.checked_mul(n));
    match shape.split_last() {
        Some((&ambient, counts)) if !counts.is_empty() && count == Some(points.len()) => {
            if points.is_empty() {
                return Err(Error::shape("points", "no points", "at least one point"));
            }
            match points.iter().find(|x| !x.is_finite()) {
                None => Ok((counts, ambient)),
                Some(x) => Err(Error::domain("points", x, "finite numbers")),
            }
        }
        _ => Err(Error::shape(
            "points",
            format!("{} numbers in shape {shape:?}", points.len()),
            "shape (m1, …, md, c) of a grid or (m, c) of scattered points",
        )),
    }
}

fn check_orders(orders: &[usize], counts: &[usize]) -> Result<()> {
    let fits = orders.len() == counts.len() || counts.len() == 1;
    if fits && !orders.is_empty() && !orders.contains(&0) {
        return Ok(());
    }
    Err(Error::shape(
        "orders",
        format!("{orders:?} for data of {} axes", counts.len()),
        "an order of at least 1 for each axis",
    ))
}

fn require_enough(orders: &[usize], counts: &[usize]) -> Result<()> {
    match orders.iter().zip(counts).position(|(order, count)| count < order) {
        None => Ok(()),
        Some(axis) => Err(Error::degenerate(
            "points",
            format!("{} points for {} poles along axis {axis}", counts[axis], orders[axis]),
            "at least as many points as poles",
        )),
    }
}

fn check_weights(options: &FitOptions, counts: &[usize]) -> Result<()> {
    let Some(weights) = &options.weights else {
        return Ok(());
    };
    let count: usize = counts.iter().product();
    if weights.len() != count {
        let received = format!("{} weights", weights.len());
        return Err(Error::shape("weights", received, format!("{count}, one for each point")));
    }
    match weights.iter().find(|weight| !(weight.is_finite() && **weight >= 0.0)) {
        None => Ok(()),
        Some(weight) => Err(Error::domain("weights", weight, "finite numbers, at least 0")),
    }
}

fn scattered_needs_parameters(axes: usize) -> Error {
    Error::shape(
        "parameters",
        format!("none for scattered points and {axes} axes"),
        format!("{axes} given lists: neighbours are unknown"),
    )
}

fn ends_refused() -> Error {
    Error::shape(
        "ends",
        "fixed ends for scattered points or a weighted grid",
        "fixed ends only for curves, and for grids without weights",
    )
}
