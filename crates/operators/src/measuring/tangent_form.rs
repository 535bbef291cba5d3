//! The unnormalised tangent as a form (book, section 326 asks for it).

use pforms_kernel::{Form, Matrix, Result, Scalar, Scaled};

/// The form whose point at `u` is the vector `W(u)²·∂f/∂u_axis`, `W` the weight of `f`.
///
/// Exact, in any number of axes. With `P0`, `P1` the last two points of de Casteljau's scheme
/// along the axis, it is `n·(P1·w0 − P0·w1)`: degree `2n−2` along the axis, twice that of `f`
/// along the others. When all weights are equal it is the hodograph, of degree `n−1`. All weights of
/// the result are 1: it is polynomial, even for a rational `f`.
///
/// Errors: `Shape` when there is no such axis, `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::tangent_form;
/// let circle: Form = Form::from_homogeneous(&[3], 2, vec![1., 0., 1., 1., 1., 1., 0., 2., 2.])?;
/// let tangent = tangent_form(&circle, 0)?;
/// assert_eq!(tangent.kind().to_string(), "pL3");
/// assert_eq!(tangent.at(&[0.0])?, [0.0, 2.0]); // across the radius, on the whole arc
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn tangent_form<S: Scalar>(form: &Form<S>, axis: usize) -> Result<Form<S>> {
    form.require_axis(axis)?;
    let degree = form.orders()[axis] - 1;
    if degree == 0 {
        return vectors(&Form::from_homogeneous(
            form.orders(),
            form.ambient(),
            vec![S::zero(); form.homogeneous().len()],
        )?);
    }
    let (first, last) = ends(form, axis)?;
    let factor = S::from_integer(degree as i64);
    let Some(weight) = form.uniform_weight() else {
        let (first, last) = (Scaled::from_form(&first), Scaled::from_form(&last));
        let weight = form.ambient();
        let forward = last.times(&first.component(weight))?;
        let difference = forward.minus(&first.times(&last.component(weight))?);
        return scaled_vectors(difference, &factor);
    };
    let poles = last.homogeneous().iter().zip(first.homogeneous());
    let scale = factor * weight.clone();
    let poles = poles.map(|(b, a)| scale.clone() * (b.clone() - a.clone())).collect();
    vectors(&Form::from_homogeneous(first.orders(), form.ambient(), poles)?)
}

/// All poles but the last along an axis, and all but the first.
pub(crate) fn ends<S: Scalar>(form: &Form<S>, axis: usize) -> Result<(Form<S>, Form<S>)> {
    let order = form.orders()[axis];
    let pick = |shift: usize| {
        let entry = |i: usize, j: usize| if j == i + shift { S::one() } else { S::zero() };
        form.along(axis, &Matrix::from_rule(order - 1, order, entry))
    };
    Ok((pick(0)?, pick(1)?))
}

/// The coordinates of a form as vectors: every weight becomes 1.
pub(crate) fn vectors<S: Scalar>(form: &Form<S>) -> Result<Form<S>> {
    scaled_poles(form, &S::one())
}

/// Coordinates times a factor, as vectors.
pub(crate) fn scaled_vectors<S: Scalar>(coordinates: Scaled<S>, factor: &S) -> Result<Form<S>> {
    scaled_poles(&coordinates.into_form()?, factor)
}

fn scaled_poles<S: Scalar>(form: &Form<S>, factor: &S) -> Result<Form<S>> {
    let mut poles = form.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(form.width()) {
        for x in pole.iter_mut() {
            *x = factor.clone() * x.clone();
        }
        pole[form.ambient()] = S::one();
    }
    Form::from_homogeneous(form.orders(), form.ambient(), poles)
}
