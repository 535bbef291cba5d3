//! The form of the same orders that passes through a net of points (book, section 221).

use pforms_kernel::{Error, Form, Matrix, Result, Scalar, blossom_row};

use super::Nodes;
use super::twofold::Twofold;
use super::vandermonde::{Vandermonde, Window};

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
    let points = Form::from_points(net.orders(), net.ambient(), &net.points()?, None)?;
    let curve = interpolate_homogeneous(&points, nodes)?;
    Ok(curve.with_uniform_weight(&S::one()))
}

/// The form whose homogeneous points at the nodes are the homogeneous poles of `net`.
///
/// All coordinates are interpolated, the weight too (the `pLinterpolante` of the listing), so the
/// result is rational when the net is. Accuracy and errors as [`interpolate`]; directions in the
/// net are welcome.
pub fn interpolate_homogeneous<S: Scalar>(net: &Form<S>, nodes: &Nodes<S>) -> Result<Form<S>> {
    if let Nodes::Given(lists) = nodes {
        net.require_per_axis("nodes", lists)?;
    }
    (0..net.axes()).try_fold(net.clone(), |form, axis| {
        let order = net.orders()[axis];
        let list = match nodes {
            Nodes::Uniform => Nodes::<Twofold<S>>::Uniform.on_axis(axis, order)?,
            nodes => nodes.on_axis(axis, order)?.into_iter().map(Twofold::from_plain).collect(),
        };
        through_axis(&form, axis, &list)
    })
}

/// Solves along one axis, for all lines at once.
fn through_axis<S: Scalar>(form: &Form<S>, axis: usize, nodes: &[Twofold<S>]) -> Result<Form<S>> {
    let sorting = sorting(axis, nodes)?;
    let window = window(sorting.iter().map(|&i| nodes[i].clone()).collect());
    let inner = form.orders()[axis + 1..].iter().product::<usize>() * form.width();
    let mut poles = permuted(form.homogeneous(), &sorting, inner);
    Vandermonde::new(&window).solve(&mut poles, inner);
    let solved = Form::from_homogeneous(form.orders(), form.ambient(), poles)?;
    if window.start.is_zero() && window.end == Twofold::one() {
        return Ok(solved);
    }
    solved.along(axis, &back_to_unit(&window))
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
