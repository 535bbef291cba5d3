//! Coons patches of euclidean points: the Boolean sum over a common denominator.

use pforms_kernel::{Error, Form, Result, Scalar, Scaled};

use super::faces::{Faces, Place};

/// The patch that blends the points of its faces: `Σ ± blend · face`, over all sub-faces.
pub(super) fn blended<S: Scalar>(faces: &Faces<S>) -> Result<Form<S>> {
    let whole = vec![[S::zero(), S::one()]; faces.axes()];
    let mut sum = Sum::of_forms();
    for place in places(faces.axes()) {
        let part = faces.part(faces.first_at(&place), &place)?;
        sum.add(&place, &part, part.is_rational(), &whole)?;
    }
    sum.form()
}

/// All sub-faces: the faces, where they meet, and so on down to the corners.
pub(super) fn places(axes: usize) -> Vec<Place> {
    let mut places = vec![Vec::new()];
    for _ in 0..axes {
        let longer = |place: Place| {
            [None, Some(0), Some(1)].map(|side| place.iter().copied().chain([side]).collect())
        };
        places = places.into_iter().flat_map(longer).collect();
    }
    places.retain(|place: &Place| place.iter().any(Option::is_some));
    places
}

/// A sum of rational functions of all axes, as fractions.
pub(super) struct Sum<S> {
    fractions: Vec<Fraction<S>>,
    /// Add up fractions of equal weights, up to a factor; else the weight of the sum is the product
    /// of all, and so continues from piece to piece.
    gathered: bool,
}

struct Fraction<S> {
    top: Scaled<S>,
    under: Scaled<S>,
}

impl<S: Scalar> Sum<S> {
    /// A sum of whole forms.
    fn of_forms() -> Self {
        Self { fractions: Vec::new(), gathered: true }
    }

    /// A sum of corresponding pieces of splines.
    pub(super) fn of_pieces() -> Self {
        Self { fractions: Vec::new(), gathered: false }
    }

    /// Adds the sub-face at a place, with its sign and its blend; `ends[k]` is what the parameter of
    /// axis `k` begins and ends with.
    pub(super) fn add(
        &mut self,
        place: &[Option<usize>],
        form: &Form<S>,
        rational: bool,
        ends: &[[S; 2]],
    ) -> Result<()> {
        let mut orders = form.orders().iter().copied();
        let spread = place.iter().map(|side| if side.is_some() { None } else { orders.next() });
        let spread: Vec<usize> = spread.map(|order| order.unwrap_or(1)).collect();
        let spread = form.reshape(&spread)?;
        let weight = if rational {
            Scaled::from_form(&spread).component(form.ambient())
        } else {
            weight(&spread)
        };
        let Some(first) = weight.coefficients().iter().find(|x| !x.is_zero()).cloned() else {
            return Err(at_infinity(form));
        };
        let unit = if self.gathered { first } else { S::one() };
        let sign = if place.iter().flatten().count() % 2 == 1 { S::one() } else { -S::one() };
        let blend = times(&blend(place, ends)?, &(sign / unit.clone()))?;
        let top = Scaled::from_form(&spread).truncated(form.ambient()).times(&blend)?;
        let under = times(&weight, &(S::one() / unit))?;
        self.push(Fraction { top, under })
    }

    fn push(&mut self, new: Fraction<S>) -> Result<()> {
        let mut known = self.fractions.iter_mut();
        match known.find(|known| self.gathered && known.under == new.under) {
            None => self.fractions.push(new),
            Some(known) => known.top = total(&known.top, &new.top)?,
        }
        Ok(())
    }

    /// The form that the sum is, over the product of all weights.
    pub(super) fn form(self) -> Result<Form<S>> {
        let mut fractions = self.fractions.into_iter();
        let Some(mut sum) = fractions.next() else {
            return Err(Error::shape("faces", "none", "at least two"));
        };
        for next in fractions {
            let top = total(&sum.top.times(&next.under)?, &next.top.times(&sum.under)?)?;
            sum = Fraction { top, under: sum.under.times(&next.under)? };
        }
        let constant = sum.under.coefficients().len() == 1;
        let unit = sum.under.coefficients()[0].clone();
        let degrees = common_degrees(&sum.top, &sum.under);
        let weight = sum.under.raised_to(&degrees)?;
        let form = sum.top.raised_to(&degrees)?.beside(&weight).into_form()?;
        Ok(if constant { form.with_uniform_weight(&unit) } else { form })
    }
}

fn common_degrees<S: Scalar>(a: &Scaled<S>, b: &Scaled<S>) -> Vec<usize> {
    a.degrees().iter().zip(b.degrees()).map(|(a, b)| *a.max(b)).collect()
}

/// The weight as a polynomial, of degree 0 when it is the same everywhere.
pub(super) fn weight<S: Scalar>(form: &Form<S>) -> Scaled<S> {
    match form.uniform_weight() {
        Some(weight) => Scaled::constant(form.axes(), std::slice::from_ref(weight)),
        None => Scaled::from_form(form).component(form.ambient()),
    }
}

/// `a + b`, of the larger degrees.
pub(super) fn total<S: Scalar>(a: &Scaled<S>, b: &Scaled<S>) -> Result<Scaled<S>> {
    let degrees = common_degrees(a, b);
    let mut sum = a.raised_to(&degrees)?;
    sum.add_multiple(&S::one(), &b.raised_to(&degrees)?);
    Ok(sum)
}

/// `Π t_k` over the axes at whose end a place is, times `Π (1 − t_k)` over those at whose start.
fn blend<S: Scalar>(place: &[Option<usize>], ends: &[[S; 2]]) -> Result<Scaled<S>> {
    let mut product = Scaled::constant(place.len(), &[S::one()]);
    for (axis, (side, ends)) in place.iter().zip(ends).enumerate() {
        let Some(side) = side else { continue };
        let mut orders = vec![1; place.len()];
        orders[axis] = 2;
        let value = |t: &S| if *side == 1 { t.clone() } else { S::one() - t.clone() };
        let poles = ends.iter().flat_map(|t| [value(t), S::one()]).collect();
        let linear = Form::from_homogeneous(&orders, 1, poles)?;
        product = product.times(&Scaled::from_form(&linear).component(0))?;
    }
    Ok(product)
}

/// A polynomial times a number.
pub(super) fn times<S: Scalar>(polynomial: &Scaled<S>, factor: &S) -> Result<Scaled<S>> {
    let axes = polynomial.degrees().len();
    polynomial.times(&Scaled::constant(axes, std::slice::from_ref(factor)))
}

fn at_infinity<S: Scalar>(form: &Form<S>) -> Error {
    let received = format!("a {} at infinity", form.kind());
    Error::domain("faces", received, "weights other than 0, where points are blended")
}
