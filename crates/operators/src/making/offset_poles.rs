//! Poles moved along the normals: the parallel of book section 325.

use pforms_kernel::{Error, Form, Result};

use super::parallel::{Distance, Side};
use crate::{FrameKind, Spline, curve_frames, surface_frame};

/// The form whose poles are moved by a distance along the normals of the original.
///
/// Pole `i` of degree `p` belongs to the parameter `i/p`, in a spline to the mean of its `p` knots
/// (Greville): at it the normal is taken. Orders, knots and weights stay. It is the parallel where
/// the normal is the same everywhere, and near it otherwise (first order in the size of the pieces);
/// for a tolerance see [`parallel`](crate::parallel). Poles at infinity stay: a direction has no place.
///
/// Errors: as [`parallel`](crate::parallel) for forms, sides and distances; `Degenerate` where a
/// normal is missing.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Side, offset_poles};
/// let arch: Form = Form::from_points(&[3], 2, &[0., 0., 1., 1., 2., 0.], None)?;
/// let moved = offset_poles(arch, 0.5, &Side::Natural)?;
/// assert_eq!(moved.at(&[0.5])?[0], 1.0);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn offset_poles(
    form: impl Into<Spline>,
    distance: impl Into<Distance>,
    side: &Side,
) -> Result<Spline> {
    let (form, distance) = (form.into(), distance.into());
    distance.check(form.axes())?;
    let (net, width) = (form.net(), form.net().width());
    let parameters: Vec<Vec<f64>> = form.knots().iter().map(greville).collect();
    let mut poles = net.homogeneous().to_vec();
    for (flat, pole) in poles.chunks_exact_mut(width).enumerate() {
        if pole[width - 1] == 0.0 {
            continue;
        }
        let at = chosen(flat, net.orders(), &parameters);
        let step = distance.at(&shares(&form, &at)?)? * pole[width - 1];
        for (x, n) in pole.iter_mut().zip(normal(&form, &at, side)?) {
            *x += step * n;
        }
    }
    let net = Form::from_homogeneous(net.orders(), net.ambient(), poles)?;
    Spline::on(net, form.knots().to_vec())
}

/// The parameter of each pole: the mean of the knots it is mixed by.
fn greville(knots: &crate::Knots) -> Vec<f64> {
    let degree = knots.degree();
    let (from, to) = knots.window();
    let list = knots.as_slice();
    let mean = |i: usize| {
        if degree == 0 {
            return f64::midpoint(list[i], list[i + 1]);
        }
        // The mean of offsets: equal knots give themselves.
        let first = list[i + 1];
        first + list[i + 1..=i + degree].iter().map(|t| t - first).sum::<f64>() / degree as f64
    };
    (0..knots.order()).map(|i| mean(i).clamp(*from, *to)).collect()
}

fn chosen(flat: usize, orders: &[usize], parameters: &[Vec<f64>]) -> Vec<f64> {
    let mut rest = flat;
    let mut at: Vec<f64> = orders
        .iter()
        .zip(parameters)
        .rev()
        .map(|(order, list)| {
            let t = list[rest % order];
            rest /= order;
            t
        })
        .collect();
    at.reverse();
    at
}

/// The parameters with the window taken from 0 to 1.
fn shares(form: &Spline, at: &[f64]) -> Result<Vec<f64>> {
    let share = |(axis, t): (usize, &f64)| {
        let (from, to) = form.window(axis)?;
        Ok((t - from) / (to - from))
    };
    at.iter().enumerate().map(share).collect()
}

/// The unit normal at parameters of the window.
fn normal(form: &Spline, at: &[f64], side: &Side) -> Result<Vec<f64>> {
    let (piece, local) = located(form, at)?;
    match (side, form.axes(), form.ambient()) {
        (Side::Natural, 2, 3) => {
            let frame = surface_frame(&piece, local[0], local[1])?;
            frame.normal.ok_or_else(|| unfit(form))
        }
        (Side::Natural, 1, 2) => {
            let frame = curve_frames(&piece, &local, FrameKind::Tangent, 0.0)?.swap_remove(0);
            Ok(vec![-frame.tangent[1], frame.tangent[0]])
        }
        (Side::Principal, 1, 3) => {
            let frame = curve_frames(&piece, &local, FrameKind::Frenet, 0.0)?.swap_remove(0);
            frame.normal.ok_or_else(|| unfit(form))
        }
        (Side::Across(k), 1, 3) => {
            let frame = curve_frames(&piece, &local, FrameKind::Tangent, 0.0)?.swap_remove(0);
            let across = crate::measuring::vector::cross(k, &frame.tangent);
            let length = crate::measuring::vector::norm(&across);
            if length == 0.0 || !length.is_finite() {
                let received = format!("{k:?}, along the tangent at parameter {}", at[0]);
                return Err(Error::degenerate("side", received, "a vector that is not a tangent"));
            }
            Ok(across.iter().map(|x| x / length).collect())
        }
        _ => Err(unfit(form)),
    }
}

fn unfit(form: &Spline) -> Error {
    Error::shape(
        "form",
        format!("a form of {} axes in dimension {}", form.axes(), form.ambient()),
        "a surface in dimension 3, a curve in the plane, or one in space with its side",
    )
}

/// The piece that holds the parameters, and the parameters in it.
fn located(form: &Spline, at: &[f64]) -> Result<(Form, Vec<f64>)> {
    let (mut index, mut local) = (Vec::new(), Vec::new());
    for (breaks, t) in form.breaks().iter().zip(at) {
        let inner = &breaks[1..breaks.len() - 1];
        let i = inner.partition_point(|knot| knot <= t);
        index.push(i);
        local.push((t - breaks[i]) / (breaks[i + 1] - breaks[i]));
    }
    Ok((form.piece(&index)?, local))
}
