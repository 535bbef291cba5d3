//! Do the faces meet, and with which weights?

use pforms_kernel::{Error, Form, Result, Scalar, Scaled};

use super::faces::{Faces, Place};
use super::pointwise::{times as multiplied, total, weight};
use super::{larger, size};

/// Complains unless all faces of a corner have the same point there.
pub(super) fn require_corners<S: Scalar>(faces: &Faces<S>, accuracy: &S) -> Result<()> {
    let axes = faces.axes();
    let extent = extent(faces);
    for corner in 0..1_usize << axes {
        let place: Place = (0..axes).map(|axis| Some(corner >> axis & 1)).collect();
        let mut met = None;
        for index in faces_at(faces, &place) {
            let here = faces.part(index, &place)?;
            let Some((first, point)) = &met else {
                if here.homogeneous().iter().all(Scalar::is_zero) {
                    return Err(no_point(faces, index, &place));
                }
                met = Some((index, here));
                continue;
            };
            let gap = points_apart(point, &here);
            let allowed = if at_infinity(&here) {
                accuracy.clone()
            } else {
                accuracy.clone() * extent.clone()
            };
            if gap.as_ref().is_none_or(|gap| *gap > allowed) {
                return Err(apart(faces, [*first, index], &place, distance(point, &here)));
            }
        }
    }
    Ok(())
}

/// The faces that a corner or edge belongs to, in the order they were given.
fn faces_at<S: Scalar>(faces: &Faces<S>, place: &[Option<usize>]) -> Vec<usize> {
    let fixed = place.iter().enumerate().rev();
    fixed.filter_map(|(axis, side)| side.map(|side| faces.index(axis, side))).collect()
}

/// The largest coordinate of any finite pole.
fn extent<S: Scalar>(faces: &Faces<S>) -> S {
    let mut extent = S::zero();
    for form in faces.forms() {
        for pole in form.homogeneous().chunks_exact(form.width()) {
            let weight = &pole[form.ambient()];
            if !weight.is_zero() {
                for x in &pole[..form.ambient()] {
                    extent = larger(size(&(x.clone() / weight.clone())), extent);
                }
            }
        }
    }
    extent
}

fn at_infinity<S: Scalar>(point: &Form<S>) -> bool {
    point.homogeneous()[point.ambient()].is_zero()
}

/// The largest difference of a coordinate; of directions, once the largest is 1. `None` between a
/// point and a direction.
fn points_apart<S: Scalar>(a: &Form<S>, b: &Form<S>) -> Option<S> {
    if at_infinity(a) != at_infinity(b) {
        return None;
    }
    let unit = if at_infinity(a) { largest(a.homogeneous()) } else { a.ambient() };
    let [by, other] = [a, b].map(|point| point.homogeneous()[unit].clone());
    if other.is_zero() {
        return None;
    }
    let pairs = a.homogeneous().iter().zip(b.homogeneous());
    greatest(pairs.map(|(x, y)| x.clone() / by.clone() - y.clone() / other.clone()))
}

/// The largest size of numbers; `None` when one has overflowed.
fn greatest<S: Scalar>(numbers: impl IntoIterator<Item = S>) -> Option<S> {
    numbers.into_iter().try_fold(S::zero(), |most, x| x.is_finite().then(|| larger(size(&x), most)))
}

/// The place of the number that is largest in size.
fn largest<S: Scalar>(numbers: &[S]) -> usize {
    (1..numbers.len())
        .fold(0, |best, i| if size(&numbers[i]) > size(&numbers[best]) { i } else { best })
}

fn distance<S: Scalar>(a: &Form<S>, b: &Form<S>) -> f64 {
    if at_infinity(a) || at_infinity(b) {
        return f64::INFINITY;
    }
    let coordinates = |form: &Form<S>| {
        let weight = form.homogeneous()[form.ambient()].clone();
        let finite = form.homogeneous()[..form.ambient()].iter();
        finite.map(|x| (x.clone() / weight.clone()).to_f64()).collect::<Vec<_>>()
    };
    let (a, b) = (coordinates(a), coordinates(b));
    a.iter().zip(&b).fold(0.0, |sum: f64, (x, y)| sum.hypot(x - y))
}

/// The faces with constant factors that make them agree as homogeneous forms wherever they meet, if
/// there are such factors.
pub(super) fn on_one_scale<S: Scalar>(faces: &Faces<S>, accuracy: &S) -> Result<Option<Faces<S>>> {
    let Some(scaled) = scaled(faces)? else { return Ok(None) };
    let widths = scaled.forms()[0].width();
    let mut bounds = vec![S::zero(); widths];
    for pole in scaled.forms().iter().flat_map(|form| form.homogeneous().chunks_exact(widths)) {
        for (bound, x) in bounds.iter_mut().zip(pole) {
            *bound = larger(size(x), bound.clone());
        }
    }
    let coordinates = bounds[..widths - 1].iter().cloned().fold(S::zero(), larger);
    let weights = bounds[widths - 1].clone();
    let allowed = |k: usize| {
        accuracy.clone() * if k + 1 < widths { coordinates.clone() } else { weights.clone() }
    };
    for (pair, place) in edges(&scaled) {
        let [a, b] = [scaled.part(pair[0], &place)?, scaled.part(pair[1], &place)?];
        let numbers = a.homogeneous().iter().zip(b.homogeneous()).enumerate();
        for (i, (x, y)) in numbers {
            if size(&(x.clone() - y.clone())) > allowed(i % widths) {
                return Ok(None);
            }
        }
    }
    Ok(Some(scaled))
}

/// Each face multiplied so that it agrees with the first, or with a neighbour of both, at a corner.
/// `None` when that corner has no common scale.
fn scaled<S: Scalar>(faces: &Faces<S>) -> Result<Option<Faces<S>>> {
    let axes = faces.axes();
    let mut forms = faces.forms().to_vec();
    if axes < 2 {
        return Ok(Some(faces.clone()));
    }
    let opposite = 1;
    let order = (2..forms.len()).chain([opposite]);
    for index in order {
        let guide = if index == opposite { 2 } else { 0 };
        let place = common_corner(faces, index, guide);
        let known = faces.with(forms.clone()).part(guide, &place)?;
        let here = faces.part(index, &place)?;
        let unit = largest(here.homogeneous());
        let (wanted, own) = (&known.homogeneous()[unit], &here.homogeneous()[unit]);
        if own.is_zero() || wanted.is_zero() {
            return Ok(None);
        }
        if wanted != own {
            forms[index] = times(&forms[index], &(wanted.clone() / own.clone()))?;
        }
    }
    Ok(Some(faces.with(forms)))
}

/// The corner nearest to the origin that two faces share.
fn common_corner<S: Scalar>(faces: &Faces<S>, a: usize, b: usize) -> Place {
    let mut place = vec![Some(0); faces.axes()];
    for (axis, side) in [faces.place(a), faces.place(b)] {
        place[axis] = Some(side);
    }
    place
}

fn times<S: Scalar>(form: &Form<S>, factor: &S) -> Result<Form<S>> {
    let poles = form.homogeneous().iter().map(|x| x.clone() * factor.clone());
    Form::from_homogeneous(form.orders(), form.ambient(), poles.collect())
}

/// All pairs of faces that meet, and where.
fn edges<S: Scalar>(faces: &Faces<S>) -> Vec<([usize; 2], Place)> {
    let mut edges = Vec::new();
    for a in 0..faces.forms().len() {
        for b in a + 1..faces.forms().len() {
            let (first, second) = (faces.place(a), faces.place(b));
            if first.0 != second.0 {
                let mut place = vec![None; faces.axes()];
                place[first.0] = Some(first.1);
                place[second.0] = Some(second.1);
                edges.push(([a, b], place));
            }
        }
    }
    edges
}

/// Complains unless faces that meet have the same points there, at the same parameters, none of the
/// corners at infinity. What a net stands for are the forms that `pieces` makes of it.
pub(super) fn require_edges<S: Scalar>(
    faces: &Faces<S>,
    accuracy: &S,
    pieces: impl Fn(&Form<S>, &Place) -> Result<Vec<Form<S>>>,
) -> Result<()> {
    let allowed = accuracy.clone() * extent(faces);
    for (pair, place) in edges(faces) {
        let [a, b] = [faces.part(pair[0], &place)?, faces.part(pair[1], &place)?];
        for (a, b) in pieces(&a, &place)?.iter().zip(&pieces(&b, &place)?) {
            let gap = curves_apart(a, b)?;
            if gap.as_ref().is_none_or(|gap| *gap > allowed) {
                let gap = gap.map_or(f64::INFINITY, |gap| gap.to_f64());
                return Err(apart(faces, pair, &place, gap));
            }
        }
    }
    Ok(())
}

/// How far apart two forms are: the largest coordinate of a pole of their difference. `None` when it
/// has poles at infinity.
fn curves_apart<S: Scalar>(a: &Form<S>, b: &Form<S>) -> Result<Option<S>> {
    let ambient = a.ambient();
    let [left, right] = [a, b].map(|form| Scaled::from_form(form).truncated(ambient));
    let [over, under] = [weight(a), weight(b)];
    let difference = total(&left.times(&under)?, &right.times(&multiplied(&over, &-S::one())?)?)?;
    let weights = over.times(&under)?.raised_to(difference.degrees())?;
    if weights.coefficients().iter().any(Scalar::is_zero) {
        return Ok(None);
    }
    let poles = difference.coefficients().chunks_exact(ambient).zip(weights.coefficients());
    let gaps = poles.flat_map(|(pole, weight)| pole.iter().map(|x| x.clone() / weight.clone()));
    Ok(greatest(gaps))
}

fn apart<S: Scalar>(faces: &Faces<S>, pair: [usize; 2], place: &Place, gap: f64) -> Error {
    let [a, b] = pair.map(|index| faces.name(index));
    let place = Faces::<S>::place_name(place);
    let received = if gap.is_finite() {
        format!("{a} and {b} {gap} apart at {place}")
    } else {
        format!("{a} or {b} at infinity at {place}")
    };
    Error::domain("faces", received, "faces that meet")
}

fn no_point<S: Scalar>(faces: &Faces<S>, index: usize, place: &Place) -> Error {
    let received =
        format!("{} at 0 over 0 at {}", faces.name(index), Faces::<S>::place_name(place));
    Error::domain("faces", received, "a point at every corner")
}
