//! Conics: every one is a projected parabola (book 311).

use pforms_kernel::{Error, Form, Result, Scalar};

use super::Part;
use super::arc::{circle, require_positive};
use crate::{Poles, Shape, combine, stack};

/// The conic from `p0` to `p2` whose tangents there meet in `p1`, which gets the weight `w`.
///
/// `w < 1` is an arc of an ellipse (of a circle if `p1` is as far from both ends and `w` the cosine
/// of half the angle), `1` of a parabola, `w > 1` of a hyperbola; with `w = 0` the chord is left, and
/// `w < 0` is the complementary arc. The points keep weights of their own, and `p1` may be a
/// direction: a half ellipse. Forms instead of points make a form with a conic along its new axis 0.
///
/// Errors: `Shape` when the axes or the spaces differ; `Domain` when `w` is not finite.
///
/// ```
/// use pforms_kernel::Form;
/// let [p0, p1, p2] = [[1., 0.], [1., 1.], [0., 1.]].map(|p| Form::point(&p).unwrap());
/// let quarter = pforms_operators::conic(&p0, &p1, &p2, &0.5_f64.sqrt())?;
/// let middle = quarter.at(&[0.5])?;
/// assert!((middle[0].hypot(middle[1]) - 1.0).abs() < 1e-15);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn conic<S: Scalar>(p0: &Form<S>, p1: &Form<S>, p2: &Form<S>, w: &S) -> Result<Form<S>> {
    if !w.is_finite() {
        return Err(Error::domain("w", format!("{w:?}"), "a finite number"));
    }
    stack(&[p0, &combine(std::slice::from_ref(w), &[p1])?, p2])
}

/// The ellipse of half axes `a` along Ox and `b` along Oy, round the origin: a scaled [`circle`].
///
/// Errors: as [`circle`], for either half axis.
pub fn ellipse<S: Scalar>(a: &S, b: &S, part: Part) -> Result<Shape<S>> {
    require_positive("a", a)?;
    require_positive("b", b)?;
    let round = circle(&S::one(), part)?;
    let mut poles = round.net().homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(4) {
        pole[0] = pole[0].clone() * a.clone();
        pole[1] = pole[1].clone() * b.clone();
    }
    round.with_net(Form::from_homogeneous(round.net().orders(), 3, poles)?)
}

/// The arc of the parabola `y² = 4·f·x` from `y = −h` to `y = h`: `f` is its focal length, `h` the half
/// height.
///
/// Errors: `Domain` unless both are positive, and when the arc overflows.
///
/// ```
/// let arc = pforms_operators::parabola(&1.0, &2.0)?;
/// assert_eq!(arc.points()?, [1., -2., 0., -1., 0., 0., 1., 2., 0.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn parabola<S: Scalar>(focal: &S, height: &S) -> Result<Form<S>> {
    require_positive("focal", focal)?;
    require_positive("height", height)?;
    let (h, zero) = (|| height.clone(), S::zero);
    let x = h() / focal.clone() * (h() / S::from_integer(4));
    let points = [x.clone(), -h(), zero(), -x.clone(), zero(), zero(), x, h(), zero()];
    Form::from_points(&[3], 3, &points, None)
}

/// The arc of the hyperbola `x²/a² − y²/b² = 1` from `y = −b·sinh` to `y = b·sinh`, on the side of
/// positive x.
///
/// Errors: `Domain` unless `a`, `b` and `sinh` are positive and, in exact arithmetic,
/// `cosh² − sinh² = 1`.
pub fn hyperbola_by<S: Scalar>(a: &S, b: &S, [cosh, sinh]: &[S; 2]) -> Result<Form<S>> {
    require_positive("a", a)?;
    require_positive("b", b)?;
    require_positive("height", sinh)?;
    if S::EXACT && cosh.clone() * cosh.clone() - sinh.clone() * sinh.clone() != S::one() {
        let received = format!("{cosh:?}, {sinh:?}");
        return Err(Error::domain("cosh", received, "a point of the unit hyperbola"));
    }
    let (x, y) = (a.clone() * cosh.clone(), b.clone() * sinh.clone());
    let (one, zero) = (S::one, S::zero);
    let ends = [[x.clone(), -y.clone(), zero(), one()], [x, y, zero(), one()]];
    let [first, last] = ends;
    let middle = [a.clone(), zero(), zero(), cosh.clone()];
    Form::from_homogeneous(&[3], 3, [first, middle, last].concat())
}
