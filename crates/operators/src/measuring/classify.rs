//! Which conic three poles are (book 311).

use std::fmt;

use pforms_kernel::{Error, Form, Result, Scalar};

/// What a pL3 can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Conic {
    /// All its points are one.
    Point,
    /// It lies on a straight line.
    Segment,
    /// One point at infinity.
    Parabola,
    /// Two points at infinity.
    Hyperbola,
    /// None, and not a circle.
    Ellipse,
    /// An ellipse with equal axes.
    Circle,
}

impl Conic {
    /// The name: `"circle"`, `"parabola"`, …
    pub fn name(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Segment => "segment",
            Self::Parabola => "parabola",
            Self::Hyperbola => "hyperbola",
            Self::Ellipse => "ellipse",
            Self::Circle => "circle",
        }
    }
}

impl fmt::Display for Conic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Which conic a curve of three poles lies on.
///
/// Straight or not is the rank of its homogeneous poles. Of a true conic the weights tell the kind,
/// by how many parameters go to infinity: `w₁² − w₀·w₂` is negative for an ellipse, 0 for a parabola,
/// positive for a hyperbola. An ellipse is a circle when its points at infinity, which are complex,
/// have the square 0. `accuracy` is relative to the sizes of the coordinates and of the weights; 0 in
/// exact arithmetic decides exactly.
///
/// Errors: `Shape` unless the form is a pL3; `Domain` when the accuracy is negative.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Conic, classify};
/// let arc = Form::from_points(&[3], 2, &[1., 0., 1., 1., 0., 1.], Some(&[1., 1., 2.]))?;
/// assert_eq!(classify(&arc, &1e-12)?, Conic::Circle);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn classify<S: Scalar>(form: &Form<S>, accuracy: &S) -> Result<Conic> {
    if form.orders() != [3] {
        return Err(Error::shape("form", format!("a {}", form.kind()), "a pL3"));
    }
    if !(accuracy.is_finite() && *accuracy >= S::zero()) {
        return Err(Error::domain("accuracy", format!("{accuracy:?}"), "a number at least 0"));
    }
    let poles = balanced(form);
    match rank(&poles, accuracy) {
        0 | 1 => return Ok(Conic::Point),
        2 => return Ok(Conic::Segment),
        _ => {}
    }
    let [w0, w1, w2] = [0, 1, 2].map(|i| poles[i][form.ambient()].clone());
    let discriminant = w1.clone() * w1 - w0 * w2;
    Ok(if size(&discriminant) <= *accuracy {
        Conic::Parabola
    } else if discriminant > S::zero() {
        Conic::Hyperbola
    } else if is_round(&poles, accuracy) {
        Conic::Circle
    } else {
        Conic::Ellipse
    })
}

/// The poles with coordinates and weights each scaled to at most 1.
fn balanced<S: Scalar>(form: &Form<S>) -> [Vec<S>; 3] {
    let width = form.width();
    let rows = || form.homogeneous().chunks_exact(width);
    let most = |numbers: &mut dyn Iterator<Item = &S>| {
        let largest =
            numbers.fold(S::zero(), |most, x| if size(x) > most { size(x) } else { most });
        if largest.is_zero() { S::one() } else { largest }
    };
    let along = most(&mut rows().flat_map(|pole| &pole[..width - 1]));
    let weight = most(&mut rows().map(|pole| &pole[width - 1]));
    [0, 1, 2].map(|i| {
        let pole = form.homogeneous()[i * width..][..width].iter().enumerate();
        let unit = |k: usize| if k + 1 == width { weight.clone() } else { along.clone() };
        pole.map(|(k, x)| x.clone() / unit(k)).collect()
    })
}

/// The rank of three rows, by elimination with the largest pivots first.
fn rank<S: Scalar>(poles: &[Vec<S>; 3], accuracy: &S) -> usize {
    let mut rows = poles.clone();
    for done in 0..3 {
        let places = (done..3).flat_map(|i| (0..rows[i].len()).map(move |k| (i, k)));
        let largest = places.fold((done, 0), |best, place| {
            let at = |(i, k): (usize, usize)| size(&rows[i][k]);
            if at(place) > at(best) { place } else { best }
        });
        let (i, k) = largest;
        if size(&rows[i][k]) <= *accuracy {
            return done;
        }
        rows.swap(done, i);
        let pivot = rows[done].clone();
        for row in &mut rows[done + 1..] {
            let factor = row[k].clone() / pivot[k].clone();
            for (x, p) in row.iter_mut().zip(&pivot) {
                *x = x.clone() - factor.clone() * p.clone();
            }
        }
    }
    3
}

/// Is `X(t)·X(t)` divisible by the weight `W(t)`, both quadratic, where `W` has no real root?
fn is_round<S: Scalar>(poles: &[Vec<S>; 3], accuracy: &S) -> bool {
    let weight = poles[0].len() - 1;
    let [w0, w1, w2] = [0, 1, 2].map(|i| poles[i][weight].clone());
    let part = |i: usize, w: &S| -> Vec<S> {
        let rows = poles[i][..weight].iter().zip(&poles[2]);
        rows.map(|(x, last)| x.clone() - last.clone() * w.clone() / w2.clone()).collect()
    };
    // X mod W = a + 2·b·t, with t² = −(w₀ + 2·w₁·t)/w₂.
    let (a, b) = (part(0, &w0), part(1, &w1));
    let dot = |a: &[S], b: &[S]| {
        a.iter().zip(b).fold(S::zero(), |sum, (x, y)| sum + x.clone() * y.clone())
    };
    let four = S::from_integer(4);
    let (aa, ab, bb) = (dot(&a, &a), dot(&a, &b), four * dot(&b, &b));
    let constant = aa.clone() * w2.clone() - bb.clone() * w0.clone();
    let linear = S::from_integer(4) * ab * w2 - S::from_integer(2) * bb.clone() * w1;
    let scale = (aa + bb) * accuracy.clone();
    size(&constant) <= scale && size(&linear) <= scale
}

fn size<S: Scalar>(x: &S) -> S {
    if *x < S::zero() { -x.clone() } else { x.clone() }
}
