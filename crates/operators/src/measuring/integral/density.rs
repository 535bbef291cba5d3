//! What is integrated over a piece: an element of size or of flux, as polynomials made ready.

use pforms_kernel::{Error, Form, Rational, Result, Scalar, Scaled};

use super::local::{Local, heaviest, infinite, least_weight, seen_from, sharply_seen};
use crate::algebra::{Minors, flux_minor, tangent_minors};
use crate::measuring::guarded::Guarded;
use crate::measuring::twofold::Twofold;
use crate::measuring::vector::{dot, norm};

/// Which element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Element {
    /// `|∂₁f ∧ … ∧ ∂_d f|`: length, area, volume, without sign.
    Size,
    /// The determinant of the derivatives, with its sign.
    Signed,
    /// `det(f, ∂₁f, …)`: as many times the enclosed volume as there are coordinates.
    Flux,
}

impl Element {
    fn minors<S: Scalar>(self, form: &Form<S>) -> Result<Minors<S>> {
        match self {
            Self::Flux => flux_minor(form),
            Self::Size | Self::Signed => tangent_minors(form),
        }
    }
}

/// `Π u_k^a·(1 − u_k)^b·|N|/W^e` or, with a sign, `N/W^e` over the window of a piece.
#[derive(Clone, Debug)]
pub(super) struct Density {
    /// The components of `N`; instead of weights, by how much they may be wrong through rounding.
    pub numerators: Form,
    /// `N·N`, where there are several components, beside weights 1.
    pub square: Option<Form>,
    /// `e`.
    pub power: usize,
    pub signed: bool,
    /// The exponents `a` and `b` along each axis.
    pub factors: Vec<[i32; 2]>,
    /// What was left out, at most.
    pub omitted: f64,
}

/// Part of the accuracy that may be left out.
const OMITTED: f64 = 1e-3;

/// Part of the accuracy that rounding may take before the polynomials are computed with more digits.
const NOISE: f64 = 0.25;

/// What sharp coefficients may be wrong by, in units of their mean: all were rounded once.
const ROUNDED: f64 = 2.0 * f64::EPSILON;

/// What roundings may have made of a coefficient, in units of the size of what went into it.
const LOST: f64 = 16.0 * f64::EPSILON;

/// The same of numbers of twice the digits, each of whose operations takes away up to a few units.
const LOST_TWOFOLD: f64 = 64.0 * f64::EPSILON * f64::EPSILON;

impl Density {
    /// The density of a piece whose coordinates and weights are about 1.
    ///
    /// Where rounding would take too many digits, or all that it can if `sharp`, the polynomials are
    /// computed once more in numbers of twice the digits, and in exact ones if need be.
    ///
    /// Errors: `Shape` when the element needs other axes; `Domain` where the weight vanishes; `Limit`.
    pub(super) fn new(
        local: &Local,
        place: usize,
        element: Element,
        accuracy: f64,
        sharp: bool,
    ) -> Result<Self> {
        let piece = &local.pieces[place];
        let least = least_weight(piece)?;
        if least <= 0.0 {
            return Err(infinite());
        }
        let near = match element {
            Element::Flux => piece.clone(),
            Element::Size | Element::Signed => seen_from(piece, &heaviest(piece))?,
        };
        let plain = element.minors(&near.map_scalar(|x| Guarded::from(*x))?)?;
        let power = plain.power;
        let mut numerators = with_noise(plain, LOST)?;
        let limit = if sharp { ROUNDED } else { NOISE * accuracy };
        // What is all rounding stays that: of poles on a line, say, that are off it by their last digit.
        let unsure = |numerators: &Form| {
            let (noise, length) = (mean_noise(numerators), mean_length(numerators));
            noise > limit * length && noise < length
        };
        let (given, origin) = (&local.given[place], &local.origin);
        if unsure(&numerators) {
            let twofold: Form<Guarded<Twofold>> = sharply_seen(given, origin)?;
            numerators = with_noise(element.minors(&twofold)?, LOST_TWOFOLD)?;
        }
        if unsure(&numerators) {
            numerators = rounded(element.minors(&sharply_seen(given, origin)?)?)?;
        }
        let mut density = Self {
            numerators,
            square: None,
            power,
            signed: element != Element::Size,
            factors: vec![[0, 0]; piece.axes()],
            omitted: 0.0,
        };
        if density.signed {
            return one_component(density);
        }
        let limit = OMITTED * accuracy * density.mean();
        let divisor = least.powi(power as i32);
        density.flatten(limit * divisor, divisor)?;
        if density.numerators.ambient() > 1 {
            density.deflate(limit * divisor, divisor)?;
            density.square = Some(square(&density.numerators)?);
        }
        Ok(density)
    }

    /// The mean length of the poles of `N`.
    pub(super) fn mean(&self) -> f64 {
        mean_length(&self.numerators)
    }

    /// A single component where all vectors have one direction, or all but what is below `limit`.
    fn flatten(&mut self, limit: f64, divisor: f64) -> Result<()> {
        let (width, count) = (self.numerators.width(), self.numerators.pole_count());
        let poles = self.numerators.homogeneous().chunks_exact(width);
        let longest = poles.clone().map(|pole| &pole[..width - 1]);
        let Some(longest) = longest.max_by(|a, b| dot(a, a).total_cmp(&dot(b, b))) else {
            return Ok(());
        };
        let length = norm(longest);
        let direction: Vec<f64> =
            longest.iter().map(|x| x / length.max(f64::MIN_POSITIVE)).collect();
        let mut across = 0.0;
        let mut flat = Vec::with_capacity(2 * count);
        for pole in poles {
            let along = dot(&pole[..width - 1], &direction);
            let rest: Vec<f64> = pole.iter().zip(&direction).map(|(x, d)| x - along * d).collect();
            across += norm(&rest) / count as f64;
            flat.extend([along, pole[width - 1]]);
        }
        if across <= limit || length == 0.0 {
            self.numerators = Form::from_homogeneous(self.numerators.orders(), 1, flat)?;
            self.omitted += across / divisor;
        }
        Ok(())
    }

    /// Takes out the factors `u` and `1 − u` that collapsed edges give.
    ///
    /// Of a polynomial whose first coefficients along an axis vanish, the others are those of its
    /// quotient by `u`, times `i/n`. Coefficients count as vanishing where leaving them out is far
    /// below the accuracy; it is accounted for.
    fn deflate(&mut self, limit: f64, divisor: f64) -> Result<()> {
        for axis in 0..self.factors.len() {
            for end in [0, 1] {
                while self.numerators.orders()[axis] > 1 {
                    let ([edge, noise], rest) = without_edge(&self.numerators, axis, end)?;
                    if edge > limit {
                        break;
                    }
                    self.omitted += (edge + noise) / divisor;
                    self.numerators = rest;
                    self.factors[axis][end] += 1;
                }
            }
        }
        Ok(())
    }
}

/// The numerators, and as weights the error that rounding may have left in each: the share `lost` of
/// what went into it, and its own last rounding.
fn with_noise<V: Scalar>(minors: Minors<Guarded<V>>, lost: f64) -> Result<Form> {
    let form = minors.into_vectors()?;
    let width = form.width();
    let mut poles = Vec::with_capacity(form.homogeneous().len());
    for pole in form.homogeneous().chunks_exact(width) {
        let mut noise = 0.0;
        for x in &pole[..width - 1] {
            let (value, unsure) = (x.to_f64(), lost * x.size + f64::MIN_POSITIVE);
            poles.push(if value.abs() > unsure { value } else { 0.0 });
            noise += (unsure + f64::EPSILON * value.abs()).powi(2);
        }
        poles.push(noise.sqrt());
    }
    Form::from_homogeneous(form.orders(), width - 1, poles)
}

/// The numerator of the Jacobian determinant of a form, up to a positive factor, and as weights by how
/// much rounding may have changed it. Where a sign is in doubt it is computed exactly.
///
/// Errors: `Shape` without as many axes as coordinates; `Domain` at infinity; `Limit`.
pub(crate) fn noisy_determinant(form: &Form) -> Result<Form> {
    let local = Local::new(std::slice::from_ref(form))?;
    if least_weight(&local.pieces[0])? <= 0.0 {
        return Err(infinite());
    }
    let (given, origin) = (&local.given[0], &local.origin);
    let sure = |determinant: &Form| {
        determinant.homogeneous().as_chunks::<2>().0.iter().all(|[x, noise]| x.abs() > *noise)
    };
    let plain: Form<Guarded> = local.pieces[0].map_scalar(|x| Guarded::from(*x))?;
    let plain = with_noise(tangent_minors(&plain)?, LOST)?;
    if sure(&plain) {
        return Ok(plain);
    }
    let twofold: Form<Guarded<Twofold>> = sharply_seen(given, origin)?;
    let twofold = with_noise(tangent_minors(&twofold)?, LOST_TWOFOLD)?;
    if sure(&twofold) {
        return Ok(twofold);
    }
    rounded(tangent_minors(&sharply_seen(given, origin)?)?)
}

/// Exact numerators, each rounded once.
fn rounded(minors: Minors<Rational>) -> Result<Form> {
    let form = minors.into_vectors()?;
    let width = form.width();
    let mut poles = Vec::with_capacity(form.homogeneous().len());
    for pole in form.homogeneous().chunks_exact(width) {
        poles.extend(pole[..width - 1].iter().map(Scalar::to_f64));
        let vector = &poles[poles.len() + 1 - width..];
        poles.push(f64::EPSILON * norm(vector));
    }
    Form::from_homogeneous(form.orders(), width - 1, poles)
}

fn one_component(density: Density) -> Result<Density> {
    match density.numerators.ambient() {
        1 => Ok(density),
        several => Err(Error::shape(
            "form",
            format!("{several} components of its volume element"),
            "as many axes as coordinates, for a signed volume",
        )),
    }
}

fn mean_noise(numerators: &Form) -> f64 {
    numerators.weights().iter().sum::<f64>() / numerators.pole_count() as f64
}

pub(super) fn mean_length(numerators: &Form) -> f64 {
    let width = numerators.width();
    let poles = numerators.homogeneous().chunks_exact(width);
    poles.map(|pole| norm(&pole[..width - 1])).sum::<f64>() / numerators.pole_count() as f64
}

/// What the poles of one end of an axis contribute at most, they and their noise, and the quotient of
/// the others by `u` or `1 − u`.
fn without_edge(form: &Form, axis: usize, end: usize) -> Result<([f64; 2], Form)> {
    let (order, width) = (form.orders()[axis], form.width());
    let inner = form.orders()[axis + 1..].iter().product::<usize>() * width;
    let degree = (order - 1) as f64;
    let share = 1.0 / form.pole_count() as f64;
    let (mut edge, mut rest) = ([0.0, 0.0], Vec::with_capacity(form.homogeneous().len()));
    for block in form.homogeneous().chunks_exact(order * inner) {
        for (i, line) in block.chunks_exact(inner).enumerate() {
            let far = if end == 0 { i } else { order - 1 - i };
            if far == 0 {
                for pole in line.chunks_exact(width) {
                    edge[0] += share * norm(&pole[..width - 1]);
                    edge[1] += share * pole[width - 1];
                }
            } else {
                rest.extend(line.iter().map(|x| x * degree / far as f64));
            }
        }
    }
    let mut orders = form.orders().to_vec();
    orders[axis] -= 1;
    let rest = Form::from_homogeneous(&orders, form.ambient(), rest)?;
    Ok((edge, rest))
}

/// The sum of the squares of all components, beside weights 1.
fn square(numerators: &Form) -> Result<Form> {
    let all = Scaled::from_form(numerators);
    let mut sum = all.component(0).times(&all.component(0))?;
    for k in 1..numerators.ambient() {
        let component = all.component(k);
        sum.add_product(&component, &component);
    }
    sum.beside(&Scaled::one(sum.degrees())?).into_form()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Part, sphere};

    #[test]
    fn quotients_by_edges() {
        // 2·u·(1 − u)² on degree 3: first without u, then without (1 − u)².
        let form: Form =
            Form::from_homogeneous(&[4], 1, vec![0., 0., 2. / 3., 0., 0., 0., 0., 0.]).unwrap();
        let (edge, rest) = without_edge(&form, 0, 0).unwrap();
        assert!(edge == [0.0, 0.0] && rest.homogeneous() == [2., 0., 0., 0., 0., 0.]);
        let (edge, rest) = without_edge(&rest, 0, 1).unwrap();
        assert!(edge == [0.0, 0.0] && rest.homogeneous() == [2., 0., 0., 0.]);
    }

    #[test]
    fn a_triangle_has_a_factor() {
        // A square with one edge at a point, tilted: the element of area is u times a constant.
        let tilted = [0., 0., 0., 0., 0., 0., 1., 0., 1., 1., 1., 2.];
        let form: Form = Form::from_points(&[2, 2], 3, &tilted, None).unwrap();
        let density = |form: Form| {
            Density::new(&Local::new(&[form]).unwrap(), 0, Element::Size, 1e-12, false).unwrap()
        };
        assert_eq!(density(form).numerators.ambient(), 1);
        // A quarter of a sphere's octant has two components and more.
        let density = density(sphere(&1.0, Part::Octant).unwrap().pieces().unwrap().remove(0));
        assert_eq!(density.factors.concat().iter().sum::<i32>(), 1);
    }

    /// A rational bicubic whose numbers fill all their digits, computed in three arithmetics.
    #[test]
    fn bounds_of_rounding_hold_between_arithmetics() {
        let number = |k: usize| libm::sin((k * k + 1) as f64);
        let poles = (0..64).map(|k| if k % 4 == 3 { 1.5 + 0.4 * number(k) } else { number(k) });
        let form: Form = Form::from_homogeneous(&[4, 4], 3, poles.collect()).unwrap();
        let plain: Form<Guarded> = form.map_scalar(|x| Guarded::from(*x)).unwrap();
        let plain = with_noise(Element::Size.minors(&plain).unwrap(), LOST).unwrap();
        let sharp: Form<Guarded<Twofold>> = sharply_seen(&form, &[0.0; 3]).unwrap();
        let sharp = with_noise(Element::Size.minors(&sharp).unwrap(), LOST_TWOFOLD).unwrap();
        let exact: Form<Rational> = sharply_seen(&form, &[0.0; 3]).unwrap();
        let exact = rounded(Element::Size.minors(&exact).unwrap()).unwrap();
        for found in [&plain, &sharp] {
            let poles =
                found.homogeneous().chunks_exact(4).zip(exact.homogeneous().chunks_exact(4));
            for (found, exact) in poles {
                let error: Vec<f64> = (0..3).map(|k| found[k] - exact[k]).collect();
                assert!(norm(&error) <= found[3] + exact[3], "{found:?} {exact:?}");
            }
        }
        assert!(mean_noise(&sharp) < ROUNDED * mean_length(&sharp));
        assert!(mean_noise(&plain) > 100.0 * mean_noise(&sharp));
    }
}
