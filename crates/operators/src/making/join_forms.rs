//! Two forms made to meet smoothly, by moving poles that may be moved.

use nalgebra::DMatrix;
use pforms_kernel::{Error, Form, Result};

use crate::algebra::{Poles, Shape, Spline};
use crate::measuring::FormEnd;

/// How smoothly forms are to meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Smoothness {
    /// `C^k`: the derivatives up to order `k` by the parameter agree.
    Parametric(usize),
    /// `G^k`, `k` at most 2: the tangents agree, and the curvatures.
    Geometric(usize),
}

/// Two forms that meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Joined {
    /// The first form.
    pub f: Shape,
    /// The second.
    pub g: Shape,
    /// The largest distance by which a pole was moved.
    pub moved: f64,
}

/// Makes `f` at one end go on smoothly into `g` at one of its own, by moving the last `moving[0]` rows
/// of poles of `f` and the first `moving[1]` of `g`, counted from the joint.
///
/// Of all ways the one is taken whose squares of moves sum up least. For `G^1` and `G^2` the speeds
/// keep their ratio, and the second derivative its part along the tangent: the conditions become
/// linear, and are met to rounding. Curves may be rational: points move, weights stay. Surfaces and
/// volumes must be polynomial, with the same degrees and knots along the edge, which both run the
/// same way; degrees of forms are raised.
///
/// Errors: `Shape` when the forms do not fit together or have fewer rows than are to move; `Domain`
/// for an order above 2 of geometric continuity, and for rational surfaces; `Degenerate` when the
/// poles that may move cannot do it, or where a geometric joint has no tangent.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{FormEnd, Poles, Smoothness, join_forms};
/// let f: Form = Form::from_points(&[3], 2, &[0., 0., 1., 1., 2., 1.], None)?;
/// let g: Form = Form::from_points(&[3], 2, &[2., 1., 3., 2., 4., 0.], None)?;
/// let at = [FormEnd::end(0), FormEnd::start(0)];
/// let joined = join_forms(&f.into(), &g.into(), at, Smoothness::Parametric(1), [0, 2])?;
/// let moved = joined.g.net().points()?;
/// assert_eq!(moved[2], 3.); // its second pole, now level with the end of f
/// assert!((moved[3] - 1.).abs() < 1e-15);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn join_forms(
    f: &Shape,
    g: &Shape,
    at: [FormEnd; 2],
    smoothness: Smoothness,
    moving: [usize; 2],
) -> Result<Joined> {
    let shapes = alike(f, g, at)?;
    let order = match smoothness {
        Smoothness::Geometric(order) if order > 2 => {
            return Err(Error::domain("order", order, "at most 2 for geometric continuity"));
        }
        Smoothness::Geometric(order) | Smoothness::Parametric(order) => order,
    };
    let sides =
        [Rows::new(&shapes[0], at[0], true, order)?, Rows::new(&shapes[1], at[1], false, order)?];
    for (side, &count) in sides.iter().zip(&moving) {
        if count > side.places.len() {
            let expected = format!("at most {}, as many as reach the joint", side.places.len());
            return Err(Error::shape("moving", format!("{count} rows"), expected));
        }
    }
    let conditions = conditions(&sides, smoothness, order)?;
    let moves = least_moves(&sides, &conditions, moving)?;
    let moved = moves.iter().flat_map(|side| side.chunks(f.net().ambient()));
    let moved = moved.fold(0.0_f64, |most, pole| most.max(norm(pole)));
    let [first, second] = &moves;
    Ok(Joined {
        f: sides[0].moved(&shapes[0], first)?,
        g: sides[1].moved(&shapes[1], second)?,
        moved,
    })
}

/// Both shapes, with equal degrees and knots along the joint.
fn alike(f: &Shape, g: &Shape, at: [FormEnd; 2]) -> Result<[Shape; 2]> {
    let mut shapes = [f.clone(), g.clone()];
    if (f.net().axes(), f.net().ambient()) != (g.net().axes(), g.net().ambient()) {
        return Err(Error::shape(
            "g",
            format!("a {} in {}D", g.net().kind(), g.net().ambient()),
            format!("{} axes in {}D, like f", f.net().axes(), f.net().ambient()),
        ));
    }
    for (shape, end) in shapes.iter().zip(at) {
        shape.net().require_axis(end.axis)?;
        if f.net().axes() > 1 && shape.net().is_rational() {
            return Err(Error::domain("f", "weights that differ", "polynomial forms, or curves"));
        }
    }
    let others = |axis: usize| (0..f.net().axes()).filter(move |k| *k != axis);
    if let [Shape::Form(f), Shape::Form(g)] = &shapes {
        let mut by = [vec![0; f.axes()], vec![0; g.axes()]];
        for (a, b) in others(at[0].axis).zip(others(at[1].axis)) {
            let (m, n) = (f.orders()[a], g.orders()[b]);
            (by[0][a], by[1][b]) = (m.max(n) - m, m.max(n) - n);
        }
        let raised = [crate::elevate(f, &by[0])?, crate::elevate(g, &by[1])?];
        shapes = raised.map(Shape::Form);
    }
    let [f, g] = shapes.clone().map(Shape::into_spline);
    for (a, b) in others(at[0].axis).zip(others(at[1].axis)) {
        if f.knots()[a] != g.knots()[b] {
            return Err(Error::shape(
                "g",
                "other degrees or knots along the edge",
                "the same as f has (see on_common_knots)",
            ));
        }
    }
    Ok(shapes)
}

/// The rows of poles that reach the joint, the nearest first, and how derivatives depend on them.
struct Rows {
    axis: usize,
    /// Indices along the axis.
    places: Vec<usize>,
    /// `factors[k][i]`: what row `i` contributes to the derivative of order `k` across the joint.
    factors: Vec<Vec<f64>>,
    /// The euclidean poles of each row, side by side.
    poles: Vec<Vec<f64>>,
}

impl Rows {
    fn new(shape: &Shape, at: FormEnd, before: bool, order: usize) -> Result<Self> {
        let spline = shape.clone().into_spline();
        let knots = spline.knots()[at.axis].clone();
        let (count, degree) = (knots.order(), knots.degree());
        let reach = degree + 1;
        let rows: Vec<usize> =
            if at.far { (count - reach..count).rev().collect() } else { (0..reach).collect() };
        let sign = if at.far == before { 1.0_f64 } else { -1.0 };
        let weights = if spline.axes() == 1 { spline.net().weights() } else { vec![1.0; count] };
        let breaks = knots.breaks();
        let piece = if at.far { breaks.len() - 2 } else { 0 };
        let step = sign / (breaks[piece + 1] - breaks[piece]);
        let mut factors = vec![Vec::with_capacity(reach); order + 1];
        for &row in &rows {
            let mut poles: Vec<f64> = weights.iter().flat_map(|w| [0.0, *w]).collect();
            poles[2 * row] = weights[row];
            let indicator = Form::from_homogeneous(&[count], 1, poles)?;
            let form = Spline::on(indicator, vec![knots.clone()])?.piece(&[piece])?;
            for (k, list) in factors.iter_mut().enumerate() {
                let slope = form.derivative_at(&[if at.far { 1.0 } else { 0.0 }], &[k])?[0];
                list.push(slope * step.powi(k as i32));
            }
        }
        let points = spline.net().points()?;
        let (inner, total) = spread(spline.net(), at.axis);
        let line = |row: &usize| -> Vec<f64> {
            let blocks = points.chunks_exact(total);
            blocks.flat_map(|block| block[row * inner..(row + 1) * inner].to_vec()).collect()
        };
        let poles = rows.iter().map(line).collect();
        Ok(Self { axis: at.axis, places: rows, factors, poles })
    }

    /// The derivative of order `k` across the joint, at every pole of the edge.
    fn derivative(&self, k: usize) -> Vec<f64> {
        let mut sum = vec![0.0; self.poles[0].len()];
        for (factor, row) in self.factors[k].iter().zip(&self.poles) {
            sum.iter_mut().zip(row).for_each(|(s, x)| *s += factor * x);
        }
        sum
    }

    /// The shape with its first rows moved.
    fn moved(&self, shape: &Shape, moves: &[f64]) -> Result<Shape> {
        let net = shape.net();
        let (inner, total) = spread(net, self.axis);
        let ambient = net.ambient();
        let mut poles = net.homogeneous().to_vec();
        let line = self.poles[0].len();
        for (row, shifts) in self.places.iter().zip(moves.chunks_exact(line)) {
            for (at, shift) in shifts.chunks_exact(ambient).enumerate() {
                let start = (at * ambient / inner * total + row * inner + at * ambient % inner)
                    / ambient
                    * net.width();
                let weight = poles[start + ambient];
                for (x, dx) in poles[start..].iter_mut().zip(shift) {
                    *x += dx * weight;
                }
            }
        }
        shape.with_net(Form::from_homogeneous(net.orders(), ambient, poles)?)
    }
}

/// Euclidean numbers of a line along the axes after `axis`, and of a whole block along it.
fn spread(net: &Form, axis: usize) -> (usize, usize) {
    let inner = net.orders()[axis + 1..].iter().product::<usize>() * net.ambient();
    (inner, inner * net.orders()[axis])
}

/// For each order, what the derivatives of `f` are to be in those of `g`.
fn conditions(sides: &[Rows; 2], smoothness: Smoothness, order: usize) -> Result<Vec<Vec<f64>>> {
    let unit = |k: usize| (0..=order).map(|i| if i == k { 1.0 } else { 0.0 }).collect();
    if let Smoothness::Parametric(_) = smoothness {
        return Ok((0..=order).map(unit).collect());
    }
    let mut conditions: Vec<Vec<f64>> = vec![unit(0)];
    if order > 0 {
        let (f, g) = (sides[0].derivative(1), sides[1].derivative(1));
        let (speed_f, speed_g) = (norm(&f), norm(&g));
        if speed_f == 0.0 || speed_g == 0.0 {
            return Err(Error::degenerate("f", "an end without a tangent", "two tangents"));
        }
        let ratio = speed_f / speed_g;
        let mut first = vec![0.0; order + 1];
        first[1] = ratio;
        conditions.push(first);
        if order > 1 {
            let (bend_f, bend_g) = (sides[0].derivative(2), sides[1].derivative(2));
            let rest = bend_f.iter().zip(&bend_g).map(|(x, y)| x - ratio * ratio * y);
            let along: f64 = rest.zip(&g).map(|(x, t)| x / speed_g * (t / speed_g)).sum();
            conditions.push(vec![0.0, along, ratio * ratio]);
        }
    }
    Ok(conditions)
}

/// The moves of the rows of both sides, together as small as may be.
fn least_moves(
    sides: &[Rows; 2],
    conditions: &[Vec<f64>],
    moving: [usize; 2],
) -> Result<[Vec<f64>; 2]> {
    /// What is left of a condition when it counts as met.
    const LEFT: f64 = 1e-9;
    let (orders, line) = (conditions.len(), sides[0].poles[0].len());
    let of_g = |k: usize, i: usize| -> f64 {
        conditions[k].iter().zip(&sides[1].factors).map(|(c, list)| c * list[i]).sum()
    };
    let mut matrix = DMatrix::zeros(orders, moving[0] + moving[1]);
    let mut right = DMatrix::zeros(orders, line);
    for k in 0..orders {
        (0..moving[0]).for_each(|i| matrix[(k, i)] = sides[0].factors[k][i]);
        (0..moving[1]).for_each(|i| matrix[(k, moving[0] + i)] = -of_g(k, i));
        for (i, row) in sides[0].poles.iter().enumerate() {
            (0..line).for_each(|at| right[(k, at)] -= sides[0].factors[k][i] * row[at]);
        }
        for (i, row) in sides[1].poles.iter().enumerate() {
            (0..line).for_each(|at| right[(k, at)] += of_g(k, i) * row[at]);
        }
        // Each condition in its own units.
        let all = sides[0].factors[k]
            .iter()
            .copied()
            .chain((0..sides[1].places.len()).map(|i| of_g(k, i)));
        let size = all.fold(0.0_f64, |most, x| most.max(x.abs()));
        if size > 0.0 {
            matrix.row_mut(k).unscale_mut(size);
            right.row_mut(k).unscale_mut(size);
        }
    }
    let cannot = || {
        Error::degenerate(
            "moving",
            format!("{} and {} rows of poles", moving[0], moving[1]),
            "enough rows that may move to meet so smoothly",
        )
    };
    let extent = sides.iter().flat_map(|side| side.poles.iter().flatten());
    let extent = extent.fold(0.0_f64, |most, x| most.max(x.abs()));
    if matrix.ncols() == 0 {
        return if right.amax() <= LEFT * extent {
            Ok([Vec::new(), Vec::new()])
        } else {
            Err(cannot())
        };
    }
    let solver = matrix.clone().svd(true, true);
    let smallest = solver.singular_values.max() * f64::EPSILON * 16.0;
    let moves = solver.solve(&right, smallest).map_err(|_| cannot())?;
    if (matrix * &moves - right).amax() > LEFT * extent {
        return Err(cannot());
    }
    let rows = |range: std::ops::Range<usize>| -> Vec<f64> {
        range.flat_map(|i| moves.row(i).iter().copied().collect::<Vec<_>>()).collect()
    };
    Ok([rows(0..moving[0]), rows(moving[0]..moving[0] + moving[1])])
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().fold(0.0_f64, |sum, x| libm::hypot(sum, *x))
}
