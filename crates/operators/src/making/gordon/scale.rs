//! One scale for rational curves that cross.

use std::slice::from_ref;

use pforms_kernel::{Error, Form, Result, Scalar};

use super::crossing;
use crate::algebra::Spline;

/// The curves with constant factors that make their weights agree at all crossings.
///
/// Errors: `Domain` for curves that do not meet, `Degenerate` when there are no such factors.
pub(super) fn on_one_scale<S: Scalar>(
    us: &[Spline<S>],
    vs: &[Spline<S>],
    [u, v]: [&[S]; 2],
    accuracy: &S,
) -> Result<[Vec<Spline<S>>; 2]> {
    if !(accuracy.is_finite() && *accuracy >= S::zero()) {
        let received = format!("{accuracy:?}");
        return Err(Error::domain("accuracy", received, "a finite number of at least 0"));
    }
    let mut scaled = [us.to_vec(), vs.to_vec()];
    let (Some(first), false) = (us.first(), vs.is_empty()) else { return Ok(scaled) };
    for (curve, (other, t)) in scaled[1].iter_mut().zip(vs.iter().zip(u)) {
        *curve =
            agreeing(other, &other.homogeneous_at(&v[..1])?, &first.homogeneous_at(from_ref(t))?)?;
    }
    let guide = scaled[1][0].clone();
    for (curve, t) in scaled[0].iter_mut().zip(v).skip(1) {
        *curve =
            agreeing(curve, &curve.homogeneous_at(&u[..1])?, &guide.homogeneous_at(from_ref(t))?)?;
    }
    let extent = extent(&scaled[0], &scaled[1]);
    for (j, (along, at_v)) in scaled[0].iter().zip(v).enumerate() {
        for (i, (across, at_u)) in scaled[1].iter().zip(u).enumerate() {
            let here = along.homogeneous_at(from_ref(at_u))?;
            let there = across.homogeneous_at(from_ref(at_v))?;
            crossing::require(
                &here,
                &there,
                [j, i],
                &(accuracy.clone() * extent.clone()),
                accuracy,
            )?;
        }
    }
    Ok(scaled)
}

/// The curve times the factor that gives its point `own` the weight of `wanted`.
fn agreeing<S: Scalar>(curve: &Spline<S>, own: &[S], wanted: &[S]) -> Result<Spline<S>> {
    let (Some(own), Some(wanted)) = (own.last(), wanted.last()) else { return Ok(curve.clone()) };
    if own == wanted || own.is_zero() || wanted.is_zero() {
        return Ok(curve.clone());
    }
    let (factor, net) = (wanted.clone() / own.clone(), curve.net());
    let poles = net.homogeneous().iter().map(|x| x.clone() * factor.clone()).collect();
    Spline::on(Form::from_homogeneous(net.orders(), net.ambient(), poles)?, curve.knots().to_vec())
}

/// The largest coordinate of any finite pole.
pub(super) fn extent<S: Scalar>(us: &[Spline<S>], vs: &[Spline<S>]) -> S {
    let mut extent = S::zero();
    for net in us.iter().chain(vs).map(Spline::net) {
        for pole in net.homogeneous().chunks_exact(net.width()) {
            let (coordinates, weight) = pole.split_at(net.ambient());
            for x in coordinates.iter().filter(|_| !weight[0].is_zero()) {
                let x = x.clone() / weight[0].clone();
                let size = if x < S::zero() { -x } else { x };
                extent = if size > extent { size } else { extent };
            }
        }
    }
    extent
}
