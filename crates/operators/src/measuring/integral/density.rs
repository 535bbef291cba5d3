//! What is integrated over a piece: an element of size or of flux, as polynomials made ready.

use pforms_kernel::{Error, Form, Rational, Result, Scalar, Scaled};

use super::local::{Local, exactly_seen, heaviest, infinite, least_weight, seen_from};
use crate::algebra::{Minors, flux_minor, tangent_minors};
use crate::measuring::guarded::Guarded;
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

/// Part of the accuracy that rounding may take before the polynomials are computed exactly.
const NOISE: f64 = 0.25;

/// Roundings that a coefficient may hold, in units of the size of what went into it.
const ROUNDINGS: f64 = 16.0;

impl Density {
    /// The density of a piece whose coordinates and weights are about 1.
    ///
    /// Where rounding would take too many digits, or if `exact`, the polynomials are computed once
    /// more in exact numbers.
    ///
    /// Errors: `Shape` when the element needs other axes; `Domain` where the weight vanishes; `Limit`.
    pub(super) fn new(
        local: &Local,
        place: usize,
        element: Element,
        accuracy: f64,
        exact: bool,
    ) -> Result<Self> {
        let piece = &local.pieces[place];
        let least = least_weight(piece)?;
        if least <= 0.0 {
            return Err(infinite());
        }
        let minors = match element {
            Element::Flux => flux_minor(&guarded(piece)?)?,
            Element::Size | Element::Signed => {
                tangent_minors(&guarded(&seen_from(piece, &heaviest(piece))?)?)?
            }
        };
        let power = minors.power;
        let mut numerators = with_noise(minors)?;
        let (noise, length) = (mean_noise(&numerators), mean_length(&numerators));
        // What is all rounding stays that: of poles on a line, say, that are off it by their last digit.
        if (exact || noise > NOISE * accuracy * length) && noise < length {
            let exact = exactly_seen(&local.given[place], &local.origin)?;
            let minors = match element {
                Element::Flux => flux_minor(&exact)?,
                Element::Size | Element::Signed => tangent_minors(&exact)?,
            };
            numerators = rounded(minors)?;
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

fn guarded(form: &Form) -> Result<Form<Guarded>> {
    form.map_scalar(|x| Guarded::from(*x))
}

/// The numerators, and as weights the error that rounding may have left in each.
fn with_noise(minors: Minors<Guarded>) -> Result<Form> {
    let form = minors.into_vectors()?;
    let width = form.width();
    let mut poles = Vec::with_capacity(form.homogeneous().len());
    for pole in form.homogeneous().chunks_exact(width) {
        let mut noise = 0.0;
        for x in &pole[..width - 1] {
            let unsure = ROUNDINGS * f64::EPSILON * x.size;
            let counts = x.value.abs() > unsure;
            poles.push(if counts { x.value } else { 0.0 });
            noise += unsure * unsure;
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
    let determinant = with_noise(tangent_minors(&guarded(&local.pieces[0])?)?)?;
    if determinant.homogeneous().as_chunks::<2>().0.iter().all(|[x, noise]| x.abs() > *noise) {
        return Ok(determinant);
    }
    rounded(tangent_minors(&exactly_seen(&local.given[0], &local.origin)?)?)
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
}
