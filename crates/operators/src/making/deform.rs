//! Free-form deformation: what lies in a cage follows the cage.

use pforms_kernel::{Error, Form, Matrix, Result, Scalar};

use crate::{Knots, Poles, Shape, Spline, immerse, immerse_spline, transform};

/// The cage before it is bent: which of its parameters a point has.
#[derive(Clone, Debug, PartialEq)]
pub enum Rest<S = f64> {
    /// Coordinates are parameters: the object lies in the window of the cage.
    Window,
    /// A box between two corners.
    Box(Vec<S>, Vec<S>),
    /// A cage that is an affine image of its window: a parallelepiped.
    Cage(Shape<S>),
}

/// A form or spline that follows a cage from rest: exact, since an affine map and an immersion are.
///
/// The cage has a parameter for each coordinate of the object, and any space. A cage bent at rest is
/// refused: its inverse is no polynomial, so through it only points can go, see
/// [`embed`](crate::embed()). Book 35; Sederberg and Parry, *Free-form deformation of solid geometric
/// models*, 1986.
///
/// Errors: `Shape` when coordinates and axes do not fit; `Degenerate` for a flat box or cage at rest;
/// `Domain` for a bent one; those of [`immerse`] and [`immerse_spline`].
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Poles, Rest, deform};
/// let segment: Form = Form::from_points(&[2], 2, &[0., 0., 4., 2.], None)?;
/// // The box from (0, 0) to (4, 2), sheared at its upper side.
/// let cage = Form::from_points(&[2, 2], 2, &[0., 0., 1., 2., 4., 0., 5., 2.], None)?;
/// let rest = Rest::Box(vec![0., 0.], vec![4., 2.]);
/// let bent = deform(&segment.into(), &cage.into(), &rest)?;
/// assert_eq!(bent.net().points()?, [0., 0., 2.5, 1., 5., 2.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn deform<S: Scalar>(object: &Shape<S>, cage: &Shape<S>, rest: &Rest<S>) -> Result<Shape<S>> {
    let inner = match rest.map(object.net().ambient(), cage)? {
        Some(matrix) => transform(object, &matrix)?,
        None => object.clone(),
    };
    match (&inner, cage) {
        (Shape::Form(inner), Shape::Form(cage)) => Ok(immerse(inner, cage)?.into()),
        _ => Ok(immerse_spline(&inner, cage)?.into()),
    }
}

impl<S: Scalar> Rest<S> {
    /// The rest as a cage with the window of another; `None` when it is bent or any will do.
    ///
    /// Errors: as [`deform`].
    pub fn cage(&self, cage: &Shape<S>) -> Result<Shape<S>> {
        let windows = windows(cage);
        let (lower, upper): (Vec<S>, Vec<S>) = match self {
            Self::Cage(rest) => return Ok(rest.clone()),
            Self::Window => windows.iter().cloned().unzip(),
            Self::Box(lower, upper) => {
                require_box(lower, upper, windows.len())?;
                (lower.clone(), upper.clone())
            }
        };
        box_over(&lower, &upper, &windows)
    }

    /// The affine map from points to parameters of the cage; `None` for the identity.
    fn map(&self, ambient: usize, cage: &Shape<S>) -> Result<Option<Matrix<S>>> {
        let windows = windows(cage);
        let axes = windows.len();
        if !matches!(self, Self::Window) && ambient != axes {
            let expected = format!("{axes}D, a coordinate for each parameter of the cage");
            return Err(Error::shape("object", format!("a form in {ambient}D"), expected));
        }
        match self {
            Self::Window => Ok(None),
            Self::Box(lower, upper) => {
                require_box(lower, upper, axes)?;
                let lengths: Vec<S> = (0..axes)
                    .map(|k| {
                        let window = windows[k].1.clone() - windows[k].0.clone();
                        window / (upper[k].clone() - lower[k].clone())
                    })
                    .collect();
                Ok(Some(affine(axes, |i, j| match () {
                    () if i == j => lengths[i].clone(),
                    () if j < axes => S::zero(),
                    () => windows[i].0.clone() - lower[i].clone() * lengths[i].clone(),
                })))
            }
            Self::Cage(rest) => inverse_of(rest, &windows).map(Some),
        }
    }
}

/// Where the parameters of a cage begin and end.
pub(super) fn windows<S: Scalar>(cage: &Shape<S>) -> Vec<(S, S)> {
    match cage {
        Shape::Form(form) => vec![(S::zero(), S::one()); form.axes()],
        Shape::Spline(spline) => {
            let window = |knots: &Knots<S>| {
                let (from, to) = knots.window();
                (from.clone(), to.clone())
            };
            spline.knots().iter().map(window).collect()
        }
    }
}

fn require_box<S: Scalar>(lower: &[S], upper: &[S], axes: usize) -> Result<()> {
    if lower.len() != axes || upper.len() != axes {
        let received = format!("corners in {}D and {}D", lower.len(), upper.len());
        let expected =
            format!("corners in {axes}D, as many coordinates as the cage has parameters");
        return Err(Error::shape("rest", received, expected));
    }
    match lower.iter().zip(upper).position(|(low, high)| low == high) {
        None => Ok(()),
        Some(k) => Err(Error::degenerate(
            "rest",
            format!("a box without extent along coordinate {k}"),
            "corners that differ in each coordinate",
        )),
    }
}

/// The box between two corners as a cage of degree 1 with given windows.
fn box_over<S: Scalar>(lower: &[S], upper: &[S], windows: &[(S, S)]) -> Result<Shape<S>> {
    let axes = lower.len();
    let mut points = Vec::with_capacity(axes << axes.min(16));
    for corner in 0..1_usize << axes.min(16) {
        for k in 0..axes {
            let is_upper = corner >> (axes - 1 - k) & 1 == 1;
            points.push(if is_upper { upper[k].clone() } else { lower[k].clone() });
        }
    }
    let form = Form::from_points(&vec![2; axes], axes, &points, None)?;
    if windows.iter().all(|(from, to)| from.is_zero() && *to == S::one()) {
        return Ok(form.into());
    }
    let knots =
        windows.iter().map(|(from, to)| vec![from.clone(), from.clone(), to.clone(), to.clone()]);
    Ok(Spline::new(form, &vec![1; axes], knots.collect())?.into())
}

/// The map from points of an affine cage to parameters in the windows.
fn inverse_of<S: Scalar>(rest: &Shape<S>, windows: &[(S, S)]) -> Result<Matrix<S>> {
    let (net, axes) = (rest.net(), windows.len());
    if net.axes() != axes || net.ambient() != axes {
        let received = format!("a {} in {}D", net.kind(), net.ambient());
        let expected = format!("{axes} parameters and coordinates, as the cage has parameters");
        return Err(Error::shape("rest", received, expected));
    }
    let (origin, edges) = frame_of(rest)?;
    let inverse = inverse(&edges)?;
    let own = self::windows(rest);
    let factor = |i: usize| {
        let (from, to) = &windows[i];
        (to.clone() - from.clone()) / (own[i].1.clone() - own[i].0.clone())
    };
    Ok(affine(axes, |i, j| {
        if j < axes {
            return factor(i) * inverse[i][j].clone();
        }
        let mut sum = -own[i].0.clone();
        for (entry, x) in inverse[i].iter().zip(&origin) {
            sum = sum - entry.clone() * x.clone();
        }
        windows[i].0.clone() + factor(i) * sum
    }))
}

/// Point at parameters 0 and the derivatives of an affine cage.
///
/// A cage is affine when its poles are the images of the nodes of its basis: of `i/n` for a form, of
/// the means of `n` knots for a spline.
fn frame_of<S: Scalar>(rest: &Shape<S>) -> Result<(Vec<S>, Vec<Vec<S>>)> {
    let (net, nodes) = (rest.net(), nodes_of(rest));
    if net.is_rational() {
        return Err(bent());
    }
    let (points, axes) = (net.points()?, net.axes());
    let pole = |index: &[usize]| {
        let flat = index.iter().zip(net.orders()).fold(0, |flat, (i, n)| flat * n + i);
        &points[flat * axes..(flat + 1) * axes]
    };
    let corner = pole(&vec![0; axes]);
    let mut edges = Vec::with_capacity(axes);
    let mut origin = corner.to_vec();
    for (axis, list) in nodes.iter().enumerate() {
        let (first, last) = (&list[0], &list[list.len() - 1]);
        if *first == *last {
            let received = format!("a cage of degree 0 along axis {axis}");
            return Err(Error::degenerate("rest", received, "one that varies along each axis"));
        }
        let mut index = vec![0; axes];
        index[axis] = list.len() - 1;
        let length = last.clone() - first.clone();
        let edge: Vec<S> = pole(&index)
            .iter()
            .zip(corner)
            .map(|(to, from)| (to.clone() - from.clone()) / length.clone())
            .collect();
        for (x, slope) in origin.iter_mut().zip(&edge) {
            *x = x.clone() - slope.clone() * first.clone();
        }
        edges.push(edge);
    }
    require_affine(&points, net.orders(), &nodes, &origin, &edges)?;
    Ok((origin, edges))
}

fn nodes_of<S: Scalar>(rest: &Shape<S>) -> Vec<Vec<S>> {
    match rest {
        Shape::Form(form) => {
            let ratio = |order: usize, i: usize| match order {
                1 => S::zero(),
                _ => S::ratio(i as i64, order as i64 - 1),
            };
            let list = |order: &usize| (0..*order).map(|i| ratio(*order, i)).collect();
            form.orders().iter().map(list).collect()
        }
        Shape::Spline(spline) => {
            let list = |knots: &Knots<S>| {
                let (degree, all) = (knots.degree(), knots.as_slice());
                let mean = |i: usize| {
                    let sum = all[i + 1..=i + degree].iter().cloned();
                    sum.fold(S::zero(), |a, b| a + b) / S::from_integer(degree.max(1) as i64)
                };
                (0..knots.order()).map(mean).collect()
            };
            spline.knots().iter().map(list).collect()
        }
    }
}

/// Roundings of a coordinate that do not bend a cage.
const ROUNDINGS: f64 = 16.0;

fn require_affine<S: Scalar>(
    points: &[S],
    orders: &[usize],
    nodes: &[Vec<S>],
    origin: &[S],
    edges: &[Vec<S>],
) -> Result<()> {
    let axes = origin.len();
    let largest = points.iter().fold(0.0_f64, |most, x| most.max(x.to_f64().abs()));
    let slack = if S::EXACT { 0.0 } else { ROUNDINGS * f64::EPSILON * largest };
    for (flat, point) in points.chunks_exact(axes).enumerate() {
        let mut rest = flat;
        let mut expected = origin.to_vec();
        for axis in (0..axes).rev() {
            let node = &nodes[axis][rest % orders[axis]];
            rest /= orders[axis];
            S::add_multiple(&mut expected, node, &edges[axis]);
        }
        for (x, y) in point.iter().zip(&expected) {
            let gap = x.clone() - y.clone();
            if !(gap.is_zero() || gap.to_f64().abs() <= slack) {
                return Err(bent());
            }
        }
    }
    Ok(())
}

fn bent() -> Error {
    Error::domain(
        "rest",
        "a bent cage",
        "a box or a parallelepiped: from a bent cage only points can follow exactly, no forms",
    )
}

/// The inverse of the matrix whose columns are the edges.
fn inverse<S: Scalar>(edges: &[Vec<S>]) -> Result<Vec<Vec<S>>> {
    let size = edges.len();
    let one_if = |condition| if condition { S::one() } else { S::zero() };
    let mut rows: Vec<Vec<S>> = (0..size)
        .map(|i| {
            let own = edges.iter().map(|edge| edge[i].clone());
            own.chain((0..size).map(|j| one_if(i == j))).collect()
        })
        .collect();
    for column in 0..size {
        let size_of = |row: &Vec<S>| row[column].to_f64().abs();
        let pivot = (column..size)
            .filter(|i| !rows[*i][column].is_zero())
            .max_by(|i, j| size_of(&rows[*i]).total_cmp(&size_of(&rows[*j])));
        let Some(pivot) = pivot else {
            return Err(Error::degenerate("rest", "a flat cage", "one with an inside"));
        };
        rows.swap(pivot, column);
        let head = rows[column][column].clone();
        rows[column].iter_mut().for_each(|x| *x = x.clone() / head.clone());
        let own = rows[column].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            if i != column && !row[column].is_zero() {
                let factor = -row[column].clone();
                S::add_multiple(row, &factor, &own);
            }
        }
    }
    Ok(rows.into_iter().map(|mut row| row.split_off(size)).collect())
}

/// The square matrix of an affine map: its entries, the shift in column `axes`.
fn affine<S: Scalar>(axes: usize, entry: impl Fn(usize, usize) -> S) -> Matrix<S> {
    Matrix::from_rule(axes + 1, axes + 1, |i, j| match (i, j) {
        (i, j) if i < axes => entry(i, j),
        (_, j) if j < axes => S::zero(),
        _ => S::one(),
    })
}
