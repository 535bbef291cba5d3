//! Gordon surfaces: through a network of curves.
//!
//! With `L_j` and `M_i` the cardinal blends at the parameters `v_j` and `u_i`, and `X_ij` the crossings,
//! `S = Σ L_j·f_j + Σ M_i·g_i − Σ M_i·L_j·X_ij`: the surface through one family of curves, the one through
//! the other, less the one through the crossings (Gordon 1971; *The NURBS Book*, 10.5).

mod blends;
mod crossing;
mod crossings;
mod family;
mod follow;
mod network;
mod order;
mod pace;
mod path;
mod scale;

use std::slice::from_ref;

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use crate::algebra::Spline;
use blends::{knots_at, values_to_poles};

use scale::{extent, on_one_scale};

pub use network::{Network, gordon_network};

/// The surface through curves `us` along u, at the parameters `v`, and curves `vs` along v, at the
/// parameters `u`: exact, in every scalar.
///
/// All curves along u are brought to the window of the first, and so along v. Between curves the
/// blends are splines of degree 3, or less where a family has fewer than four curves: the
/// polynomials of Lagrange. So forms give one piece when each family has four curves at most.
/// A family may be empty: then the surface is the one through the other alone (a loft).
///
/// Where the curves of a crossing miss each other, by no more than `accuracy` times the largest
/// coordinate, the surface holds to `us`, and misses `vs` by about as much. Rational curves keep
/// their weights, which must agree at all crossings after a constant factor for each curve.
///
/// Errors: `Shape` without curves, for anything but curves of one space, and unless there is a
/// parameter for each; `Domain` unless parameters grow within the window, and where two curves do
/// not meet: the error names both and the gap; `Degenerate` for weights that do not agree; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Spline, gordon};
/// let curve = |points: &[f64]| -> pforms_kernel::Result<Spline> {
///     Ok(Form::from_points(&[points.len() / 3], 3, points, None)?.into())
/// };
/// let us = [curve(&[0., 0., 0., 2., 0., 0.])?, curve(&[0., 1., 2., 2., 1., 2.])?, curve(&[0., 2., 0., 2., 2., 0.])?];
/// let vs = [curve(&[0., 0., 0., 0., 1., 4., 0., 2., 0.])?, curve(&[2., 0., 0., 2., 1., 4., 2., 2., 0.])?];
/// let roof = gordon(&us, &vs, &[0.0, 1.0], &[0.0, 0.5, 1.0], &1e-9)?;
/// assert_eq!(roof.at(&[0.5, 0.5])?, [1.0, 1.0, 2.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn gordon<S: Scalar>(
    us: &[Spline<S>],
    vs: &[Spline<S>],
    u: &[S],
    v: &[S],
    accuracy: &S,
) -> Result<Spline<S>> {
    require_curves(us, vs)?;
    let [us, vs] = [on_one_window(us)?, on_one_window(vs)?];
    let windows = [window_for(&us, u)?, window_for(&vs, v)?];
    require_places("u", u, vs.len(), &windows[0])?;
    require_places("v", v, us.len(), &windows[1])?;
    let [us, vs] = on_one_scale(&us, &vs, [u, v], accuracy)?;
    let mut parts = Vec::with_capacity(3);
    if !us.is_empty() {
        parts.push(loft(&us, v, &windows[1])?.transpose(&[1, 0])?);
    }
    if !vs.is_empty() {
        parts.push(loft(&vs, u, &windows[0])?);
    }
    if parts.len() == 2 {
        parts.push(through_crossings(&vs, u, v, &windows)?);
    }
    total(&parts)
}

fn require_curves<S: Scalar>(us: &[Spline<S>], vs: &[Spline<S>]) -> Result<()> {
    let Some(first) = us.iter().chain(vs).next() else {
        return Err(Error::shape("us", "no curves", "at least one curve"));
    };
    for (name, curves) in [("us", us), ("vs", vs)] {
        for (index, curve) in curves.iter().enumerate() {
            if curve.axes() != 1 || curve.ambient() != first.ambient() {
                let received =
                    format!("{} axes in {}D as curve {index}", curve.axes(), curve.ambient());
                return Err(Error::shape(
                    name,
                    received,
                    format!("curves in {}D", first.ambient()),
                ));
            }
        }
    }
    Ok(())
}

/// The curves over one window, that of the first, with common degrees and knots.
fn on_one_window<S: Scalar>(curves: &[Spline<S>]) -> Result<Vec<Spline<S>>> {
    let Some(first) = curves.first() else { return Ok(Vec::new()) };
    let (from, to) = first.window(0)?;
    let moved = curves.iter().map(|curve| {
        let same = curve.window(0)? == (from.clone(), to.clone());
        if same { Ok(curve.clone()) } else { curve.on_window(0, &from, &to) }
    });
    Spline::on_common_knots(&moved.collect::<Result<Vec<_>>>()?)
}

/// The window along the curves; without curves, from the first place to the last.
fn window_for<S: Scalar>(curves: &[Spline<S>], places: &[S]) -> Result<(S, S)> {
    match (curves.first(), places) {
        (Some(curve), _) => curve.window(0),
        (None, [single]) => Ok((single.clone(), single.clone() + S::one())),
        (None, [from, .., to]) => Ok((from.clone(), to.clone())),
        (None, []) => Ok((S::zero(), S::one())),
    }
}

fn require_places<S: Scalar>(
    name: &str,
    places: &[S],
    count: usize,
    window: &(S, S),
) -> Result<()> {
    if places.len() != count {
        let received = format!("{} parameters", places.len());
        return Err(Error::shape(name, received, format!("{count}, one for each curve across")));
    }
    let within = |t: &S| t.is_finite() && *t >= window.0 && *t <= window.1;
    if let Some(t) = places.iter().find(|t| !within(t)) {
        let expected = format!("parameters from {:?} to {:?}", window.0, window.1);
        return Err(Error::domain(name, format!("{t:?}"), expected));
    }
    match places.windows(2).find(|pair| pair[1] <= pair[0]) {
        None => Ok(()),
        Some(pair) => {
            let received = format!("{:?}, then {:?}", pair[0], pair[1]);
            Err(Error::domain(name, received, "parameters that grow"))
        }
    }
}

/// The surface through curves along axis 1, at parameters `places` of axis 0.
fn loft<S: Scalar>(curves: &[Spline<S>], places: &[S], window: &(S, S)) -> Result<Spline<S>> {
    let (first, knots) = (&curves[0], knots_at(places, window)?);
    let orders = [curves.len(), first.net().orders()[0]];
    limit::check::<S>("the surface", &orders, first.net().width())?;
    let rows = curves.iter().flat_map(|curve| curve.net().homogeneous().to_vec()).collect();
    let net = Form::from_homogeneous(&orders, first.ambient(), rows)?;
    let poles = net.along_affine(0, &values_to_poles(&knots, places)?)?;
    Spline::on(poles, vec![knots, first.knots()[0].clone()])
}

/// The surface through the crossings, less: its poles are negative.
fn through_crossings<S: Scalar>(
    vs: &[Spline<S>],
    u: &[S],
    v: &[S],
    windows: &[(S, S); 2],
) -> Result<Spline<S>> {
    let knots = [knots_at(u, &windows[0])?, knots_at(v, &windows[1])?];
    let ambient = vs[0].ambient();
    let mut points = Vec::with_capacity(u.len() * v.len() * (ambient + 1));
    for curve in vs {
        for t in v {
            points.extend(curve.homogeneous_at(from_ref(t))?);
        }
    }
    let net = Form::from_homogeneous(&[u.len(), v.len()], ambient, points)?;
    let [a, b] = [values_to_poles(&knots[0], u)?, values_to_poles(&knots[1], v)?];
    Spline::on(net.along_all_affine(&[(0, &a), (1, &b)])?, knots.to_vec())
}

/// The sum of the parts, the third of which counts negative.
fn total<S: Scalar>(parts: &[Spline<S>]) -> Result<Spline<S>> {
    let common = Spline::on_common_knots(parts)?;
    let net = common[0].net();
    let weight = net.uniform_weight().cloned();
    let mut sum = net.homogeneous().to_vec();
    for (part, sign) in common.iter().skip(1).zip([S::one(), -S::one()]) {
        S::add_multiple(&mut sum, &sign, part.net().homogeneous());
    }
    let form = Form::from_homogeneous(net.orders(), net.ambient(), sum)?;
    let uniform = common.iter().all(|part| part.net().uniform_weight() == weight.as_ref());
    let form = match weight {
        Some(weight) if uniform => form.with_uniform_weight(&weight),
        _ => form,
    };
    Spline::on(form, common[0].knots().to_vec())
}

/// The degree of the blends over so many curves.
const fn blend_degree(curves: usize) -> usize {
    if curves > 4 { 3 } else { curves.saturating_sub(1) }
}
