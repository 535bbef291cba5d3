//! Coons patches of splines.

use pforms_kernel::{Form, Result, Scalar};

use super::faces::{Faces, Place};
use super::pointwise::{Sum, places};
use super::{CoonsOptions, meeting, net, require_accuracy};
use crate::algebra::{Knots, Spline};

/// The spline of `d` axes spanned by its `2d` faces, splines of `d − 1` axes: [`coons`](super::coons)
/// where pieces are laid end to end.
///
/// Along each axis the faces are brought to one degree and one knot vector, and to the window of the
/// first of them. Then the poles are blended as those of forms are, at Greville's abscissae instead
/// of at equal steps, and the result is as smooth as the faces.
///
/// Errors: as [`coons`](super::coons).
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{CoonsOptions, Spline, coons_splines};
/// let polygon = |points: &[f64]| -> pforms_kernel::Result<Spline> {
///     let net = Form::from_points(&[points.len() / 2], 2, points, None)?;
///     let breaks = (0..points.len() / 2).map(|i| i as f64).collect();
///     Spline::joined(net, &[1], &[breaks])
/// };
/// let (roof, floor) = (polygon(&[0., 1., 1., 2., 2., 1.])?, polygon(&[0., 0., 1., 0., 2., 0.])?);
/// let (left, right) = (polygon(&[0., 0., 0., 1.])?, polygon(&[2., 0., 2., 1.])?);
/// let front = coons_splines(&[&floor, &roof, &left, &right], &CoonsOptions::default())?;
/// assert_eq!(front.at(&[1.0, 0.5])?, [1.0, 1.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn coons_splines<S: Scalar>(
    faces: &[&Spline<S>],
    options: &CoonsOptions<S>,
) -> Result<Spline<S>> {
    require_accuracy(&options.accuracy)?;
    Faces::new(&faces.iter().map(|face| face.net()).collect::<Vec<_>>())?;
    let (faces, knots) = on_common_knots(faces)?;
    meeting::require_corners(&faces, &options.accuracy)?;
    if !options.pointwise
        && let Some(scaled) = meeting::on_one_scale(&faces, &options.accuracy)?
    {
        let at: Vec<Vec<S>> = knots.iter().map(parameter).collect();
        return Spline::on(net::filled(&scaled, &at)?, knots);
    }
    let pieces = |part: &Form<S>, place: &Place| on_free_axes(part, place, &knots)?.pieces();
    meeting::require_edges(&faces, &options.accuracy, pieces)?;
    blended(&faces, &knots)
}

/// The nets of the faces over one knot vector for each axis.
fn on_common_knots<S: Scalar>(faces: &[&Spline<S>]) -> Result<(Faces<S>, Vec<Knots<S>>)> {
    let axes = faces.len() / 2;
    let windows = windows(faces)?;
    let mut whole = Vec::with_capacity(faces.len());
    for (index, face) in faces.iter().enumerate() {
        let across = axes - 1 - index / 2;
        let mut face = Spline::clone(face);
        for axis in 0..face.axes() {
            let (from, to) = &windows[axis + usize::from(axis >= across)];
            if face.window(axis)? != (from.clone(), to.clone()) {
                face = face.on_window(axis, from, to)?;
            }
        }
        whole.push(constant_across(&face, across, &windows[across])?);
    }
    let mut common = Spline::on_common_knots(&whole)?;
    let linear: Vec<usize> = common[0].degrees().iter().map(|&p| usize::from(p == 0)).collect();
    if linear.contains(&1) {
        common = common.iter().map(|spline| spline.elevate(&linear)).collect::<Result<_>>()?;
    }
    let nets: Vec<Form<S>> = common.iter().map(|spline| spline.net().clone()).collect();
    Ok((Faces::of_whole(&nets)?, common[0].knots().to_vec()))
}

/// The window of each axis: that of the first face that has it.
fn windows<S: Scalar>(faces: &[&Spline<S>]) -> Result<Vec<(S, S)>> {
    let axes = faces.len() / 2;
    let window = |axis: usize| match (axes, axis + 1 == axes) {
        (1, _) => Ok((S::zero(), S::one())),
        // The faces across the last axis have all others; that one is the last of the next.
        (_, true) => faces[2].window(axes - 2),
        _ => faces[0].window(axis),
    };
    (0..axes).map(window).collect()
}

/// The face with one axis more, along which it is the same everywhere.
fn constant_across<S: Scalar>(face: &Spline<S>, axis: usize, window: &(S, S)) -> Result<Spline<S>> {
    let mut orders = face.net().orders().to_vec();
    orders.insert(axis, 1);
    let mut knots = face.knots().to_vec();
    knots.insert(axis, Knots::new(0, vec![window.0.clone(), window.1.clone()])?);
    Spline::on(face.net().reshape(&orders)?, knots)
}

/// The poles of the parameter itself over these knots, its window taken as 0 to 1: Greville's
/// abscissae.
fn parameter<S: Scalar>(knots: &Knots<S>) -> Vec<S> {
    let ((from, to), degree, order) = (knots.window(), knots.degree(), knots.order());
    let share = S::ratio(1, degree as i64);
    let length = to.clone() - from.clone();
    let mean = |i: usize| {
        let own = &knots.as_slice()[i + 1..=i + degree];
        let sum = own.iter().fold(S::zero(), |sum, t| sum + (t.clone() - from.clone()));
        sum * share.clone() / length.clone()
    };
    (0..order)
        .map(|i| {
            if i == 0 {
                S::zero()
            } else if i + 1 == order {
                S::one()
            } else {
                mean(i)
            }
        })
        .collect()
}

/// A part of a face as a spline of the axes it runs along.
fn on_free_axes<S: Scalar>(
    part: &Form<S>,
    place: &[Option<usize>],
    knots: &[Knots<S>],
) -> Result<Spline<S>> {
    let free = place.iter().zip(knots).filter(|(side, _)| side.is_none());
    Spline::on(part.clone(), free.map(|(_, knots)| knots.clone()).collect())
}

/// The patch that blends points, piece by piece.
fn blended<S: Scalar>(faces: &Faces<S>, knots: &[Knots<S>]) -> Result<Spline<S>> {
    let mut parts = Vec::new();
    for place in places(faces.axes()) {
        let part = faces.part(faces.first_at(&place), &place)?;
        parts.push((on_free_axes(&part, &place, knots)?, place));
    }
    // Only its pieces are asked for, and its net is never read.
    let orders: Vec<usize> = knots.iter().map(Knots::order).collect();
    let poles = vec![S::one(); orders.iter().product::<usize>() * 2];
    let layout = Spline::on(Form::from_homogeneous(&orders, 1, poles)?, knots.to_vec())?;
    layout.map_pieces(|_, window| {
        let local = |(knots, (a, b)): (&Knots<S>, &(S, S))| {
            let (from, to) = knots.window();
            [a, b].map(|t| (t.clone() - from.clone()) / (to.clone() - from.clone()))
        };
        let ends: Vec<[S; 2]> = knots.iter().zip(window).map(local).collect();
        let mut sum = Sum::of_pieces();
        for (part, place) in &parts {
            let mut piece = part.clone();
            let along = window.iter().zip(place).filter(|(_, side)| side.is_none());
            for (axis, ((a, b), _)) in along.enumerate() {
                piece = piece.restrict(axis, a, b)?;
            }
            sum.add(place, piece.net(), part.net().is_rational(), &ends)?;
        }
        sum.form()
    })
}
