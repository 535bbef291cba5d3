//! Does a parallel reach the centres of curvature?
//!
//! With `E F G` and `L M N` the fundamental forms, the parallel at distance `d` is regular as long
//! as `I − d·II` is positive definite. Times `s·W⁴` its entries are polynomials, and so is its
//! determinant: positive everywhere and definite at one point, it is definite everywhere.

use pforms_kernel::{Form, Result, Scaled};

use super::cell::{Cell, weight};
use super::distance::Quotient;
use super::field::{divided, layer};
use super::positive::refuted;
use crate::measuring::bending::{bending, difference, dot_product};
use crate::measuring::guarded::{Guarded, significant};
use crate::tangent_form;

type Polynomial = Scaled<Guarded>;

/// Parameters of the cell where the parallel is not regular. `unit`: the length that counts as 1 in
/// the local piece.
pub(super) fn fold(cell: &Cell, distance: &Quotient, unit: f64) -> Result<Option<Vec<f64>>> {
    let determinant = determinant(&matrix(cell, distance, unit)?)?;
    let poles = determinant.homogeneous();
    let noise = poles.chunks_exact(2).fold(0.0_f64, |most, pole| most.max(pole[0].size));
    let values = determinant.map_scalar(|x| x.value)?;
    if let Some(place) = refuted(&values, noise * NOISE, DEPTH)? {
        return Ok(Some(place));
    }
    // Definite, or negative definite everywhere.
    let middle = vec![0.5; cell.local.axes()];
    let corner = &matrix(cell, distance, unit)?[0];
    Ok((value(corner)?.at(&middle)?[0] <= 0.0).then_some(middle))
}

/// Halvings of a cell before doubt is an answer: a thousandth of a small cell.
const DEPTH: usize = 14;

/// Share of the numbers that went into a determinant below which it is taken for rounding.
const NOISE: f64 = 32.0 * f64::EPSILON;

/// `s·W⁴·(I − d·II)`: one entry for a curve, three for a surface.
fn matrix(cell: &Cell, distance: &Quotient, unit: f64) -> Result<Vec<Polynomial>> {
    let local = &cell.local;
    let normal = directions(&cell.normal)?;
    let above = guarded(&distance.above, 1.0 / unit)?;
    let below = guarded(&cell.length.times(&distance.below)?, 1.0)?;
    let tangents = (0..local.axes()).map(|axis| Ok(Scaled::from_form(&tangent_form(local, axis)?)));
    let tangents: Vec<Polynomial> = tangents.collect::<Result<_>>()?;
    let pairs: &[(usize, usize)] =
        if local.axes() == 1 { &[(0, 0)] } else { &[(0, 0), (0, 1), (1, 1)] };
    let entry = |&(k, l): &(usize, usize)| -> Result<Polynomial> {
        let first = dot_product(&tangents[k], &tangents[l])?.times(&below)?;
        let second = second(local, &normal, k, l)?.times(&above)?;
        difference(&first, &second)
    };
    pairs.iter().map(entry).collect()
}

/// The normals, each number as sure as the largest of its vector: they are rounded products, of which a
/// component that should be 0 is as much rounding as there is in the others.
fn directions(normal: &Form) -> Result<Form<Guarded>> {
    let poles = normal.homogeneous().chunks_exact(normal.width()).flat_map(|pole| {
        let size = pole[..normal.ambient()].iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let vector = pole[..normal.ambient()].iter().map(move |x| Guarded { value: *x, size });
        vector.chain([Guarded::from(pole[normal.ambient()])])
    });
    Form::from_homogeneous(normal.orders(), normal.ambient(), poles.collect())
}

/// `W⁴·N·f_kl`.
fn second(local: &Form<Guarded>, normal: &Form<Guarded>, k: usize, l: usize) -> Result<Polynomial> {
    let weight = weight(local);
    bending(local, normal, k, l)?.times(&weight)?.times(&weight)
}

/// The determinant, divided by what makes it vanish on a whole side: a collapsed edge.
fn determinant(entries: &[Polynomial]) -> Result<Form<Guarded>> {
    let determinant = match entries {
        [e, f, g] => difference(&e.times(g)?, &f.times(f)?)?,
        _ => entries[0].clone(),
    };
    let mut form = value_of(&determinant)?;
    for axis in 0..form.axes() {
        for far in [false, true] {
            while form.orders()[axis] > 1 && !significant(&layer(&form, axis, far)) {
                form = divided(&form, axis, far)?;
            }
        }
    }
    Ok(form)
}

fn value_of(polynomial: &Polynomial) -> Result<Form<Guarded>> {
    polynomial.beside(&Scaled::one(polynomial.degrees())?).into_form()
}

fn value(polynomial: &Polynomial) -> Result<Form> {
    value_of(polynomial)?.map_scalar(|x| x.value)
}

/// A polynomial times a factor, in numbers that know their rounding.
fn guarded(polynomial: &Scaled, factor: f64) -> Result<Polynomial> {
    let form = polynomial.beside(&Scaled::one(polynomial.degrees())?).into_form()?;
    let poles = form.homogeneous().chunks_exact(2);
    let poles = poles.flat_map(|pole| [Guarded::from(pole[0] * factor), Guarded::from(1.0)]);
    let form = Form::from_homogeneous(form.orders(), 1, poles.collect())?;
    Ok(Scaled::from_form(&form).component(0))
}
