//! The form of the same orders that passes through a net of points (book, section 221).

use pforms_kernel::{Error, Form, Matrix, Result, Scalar, blossom_row};

use super::Nodes;
use super::known_nodes::known;
use super::vandermonde::{Vandermonde, Window};
use crate::measuring::twofold::Twofold;

/// The polynomial form through the euclidean poles of `net`, at the given nodes of each axis.
///
/// Any number of axes, one `O(order²)` solution per line and axis. Exact in rationals. In `f64`
/// each axis leaves an error below `10⁻¹⁵·|A⁻¹|·|q|` in each component (tested up to order 40), where
/// `A` is the matrix of the problem and `q` its data: as right as the problem's condition allows.
///
/// Errors: `Degenerate` when two nodes of an axis coincide, `Shape` when their number is not the
/// order, `Domain` when a node is not finite or a point of the net is at infinity.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Nodes, interpolate};
/// let through: Form = Form::from_points(&[3], 2, &[0., 0., 1., 1., 2., 0.], None)?;
/// let parabola = interpolate(&through, &Nodes::Uniform)?;
/// assert_eq!(parabola.points()?, [0., 0., 1., 2., 2., 0.]); // (−b₀ + 4b₁ − b₂)/2
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn interpolate<S: Scalar>(net: &Form<S>, nodes: &Nodes<S>) -> Result<Form<S>> {
    let poles = through(net, net.points()?, nodes)?;
    Form::from_points(net.orders(), net.ambient(), &poles, None)
}

/// The form whose homogeneous points at the nodes are the homogeneous poles of `net`.
///
/// All coordinates are interpolated, the weight too (the `pLinterpolante` of the listing), so the
/// result is rational when the net is. Accuracy and errors as [`interpolate`]; directions in the
/// net are welcome.
pub fn interpolate_homogeneous<S: Scalar>(net: &Form<S>, nodes: &Nodes<S>) -> Result<Form<S>> {
    let poles = through(net, net.homogeneous().to_vec(), nodes)?;
    Form::from_homogeneous(net.orders(), net.ambient(), poles)
}

/// The poles of the form through `points`, laid out like those of the net.
fn through<S: Scalar>(net: &Form<S>, mut points: Vec<S>, nodes: &Nodes<S>) -> Result<Vec<S>> {
    if let Nodes::Given(lists) = nodes {
        net.require_per_axis("nodes", lists)?;
    }
    let mut inner = points.len();
    for (axis, &order) in net.orders().iter().enumerate() {
        inner /= order;
        if let Some(factors) = known(nodes, order) {
            factors.solve(&mut points, inner);
            continue;
        }
        let list = match nodes {
            Nodes::Uniform => Nodes::<Twofold<S>>::Uniform.on_axis(axis, order)?,
            nodes => nodes.on_axis(axis, order)?.into_iter().map(Twofold::from_plain).collect(),
        };
        points = through_axis(&points, axis, &list, inner)?;
    }
    Ok(points)
}

/// Solves along one axis, for all lines at once.
fn through_axis<S: Scalar>(
    points: &[S],
    axis: usize,
    nodes: &[Twofold<S>],
    inner: usize,
) -> Result<Vec<S>> {
    let sorting = sorting(axis, nodes)?;
    let window = window(sorting.iter().map(|&i| nodes[i].clone()).collect());
    let mut poles = permuted(points, &sorting, inner);
    Vandermonde::new(&window).solve(&mut poles, inner);
    if window.start.is_zero() && window.end == Twofold::one() {
        return Ok(poles);
    }
    back_to_unit(&window).act(&poles, inner)
}

/// Indices that put the nodes in increasing order.
fn sorting<S: Scalar>(axis: usize, nodes: &[S]) -> Result<Vec<usize>> {
    if let Some(node) = nodes.iter().find(|node| !node.is_finite()) {
        return Err(Error::domain(
            "nodes",
            format!("{} on axis {axis}", node.to_f64()),
            "finite numbers",
        ));
    }
    let mut indices: Vec<usize> = (0..nodes.len()).collect();
    indices.sort_by(|&i, &j| nodes[i].partial_cmp(&nodes[j]).unwrap_or(std::cmp::Ordering::Equal));
    match indices.windows(2).find(|pair| nodes[pair[0]] == nodes[pair[1]]) {
        None => Ok(indices),
        Some(pair) => Err(Error::degenerate(
            "nodes",
            format!(
                "nodes {} and {} of axis {axis} both at {}",
                pair[0],
                pair[1],
                nodes[pair[0]].to_f64()
            ),
            "distinct nodes",
        )),
    }
}

/// The smallest window that holds `[0, 1]` and the nodes.
fn window<S: Scalar>(nodes: Vec<S>) -> Window<S> {
    let mut window = Window { nodes, start: S::zero(), end: S::one() };
    if let (Some(first), Some(last)) = (window.nodes.first(), window.nodes.last()) {
        if *first < window.start {
            window.start = first.clone();
        }
        if *last > window.end {
            window.end = last.clone();
        }
    }
    window
}

fn permuted<S: Scalar>(array: &[S], order: &[usize], inner: usize) -> Vec<S> {
    array
        .chunks_exact(order.len() * inner)
        .flat_map(|block| order.iter().flat_map(|&i| &block[i * inner..][..inner]))
        .cloned()
        .collect()
}

/// Poles on the window `[start, end]` become poles on `[0, 1]`, by blossoming.
fn back_to_unit<S: Scalar>(window: &Window<Twofold<S>>) -> Matrix<S> {
    let degree = window.nodes.len() - 1;
    let span = window.end.clone() - window.start.clone();
    let zero = -window.start.clone() / span.clone();
    let one = (Twofold::one() - window.start.clone()) / span;
    let rows: Vec<Vec<Twofold<S>>> = (0..=degree)
        .map(|i| {
            let mut arguments = vec![zero.clone(); degree - i];
            arguments.resize(degree, one.clone());
            blossom_row(&arguments)
        })
        .collect();
    Matrix::from_rule(degree + 1, degree + 1, |i, j| rows[i][j].to_plain())
}
