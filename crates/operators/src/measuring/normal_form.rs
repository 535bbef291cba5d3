//! Unnormalised normals and binormals as forms (book, section 326).

use pforms_kernel::{Error, Form, Result, Scalar, Scaled};

use super::tangent_form::{ends, scaled_vectors, tangent_form, vectors};

/// The normal as a form of vectors (all weights 1), exact; `W` is the weight of `f`.
///
/// * Surface in space: `W³·(f_u × f_v)`, of degrees `3m−2` and `3n−2` (`2m−1`, `2n−1` when all
///   weights are equal).
/// * Curve in the plane: the tangent `W²·f′` turned left by a right angle.
/// * Curve in space: the principal normal `W⁵·(f′ × f″) × f′`, of degree `5n−8` (`3n−4` when all
///   weights are equal); zero where the curve is straight.
///
/// Errors: `Shape` for other numbers of axes and dimensions, `Limit`.
pub fn normal_form<S: Scalar>(form: &Form<S>) -> Result<Form<S>> {
    match (form.axes(), form.ambient()) {
        (1, 2) => turned_left(&tangent_form(form, 0)?),
        (1, 3) => {
            let binormal = Scaled::from_form(&binormal_form(form)?);
            let tangent = Scaled::from_form(&tangent_form(form, 0)?);
            let normal = cross(&binormal, &tangent)?;
            scaled_vectors(gather(&normal), &S::one())
        }
        (2, 3) if form.orders().contains(&1) => no_vectors(form),
        (2, 3) => match form.uniform_weight().filter(|weight| !weight.is_zero()) {
            None => rational_surface(form),
            Some(weight) => over(weight, &tangent_form(form, 0)?, &tangent_form(form, 1)?),
        },
        _ => Err(Error::shape(
            "form",
            format!("a {} in dimension {}", form.kind(), form.ambient()),
            "a surface in dimension 3 or a curve in dimension 2 or 3",
        )),
    }
}

/// The binormal of a curve in space as a form of vectors: `W³·(f′ × f″)`, of degree `3n−6`
/// (`2n−3` when all weights are equal), exact.
///
/// It vanishes identically for a straight line. Errors: `Shape` unless it is a curve in dimension
/// 3, `Limit`.
pub fn binormal_form<S: Scalar>(form: &Form<S>) -> Result<Form<S>> {
    if form.axes() != 1 || form.ambient() != 3 {
        return Err(Error::shape(
            "form",
            format!("a {} in dimension {}", form.kind(), form.ambient()),
            "a curve in dimension 3",
        ));
    }
    let degree = form.orders()[0] - 1;
    if degree < 2 {
        return no_vectors(form);
    }
    if let Some(weight) = form.uniform_weight().filter(|weight| !weight.is_zero()) {
        let tangent = tangent_form(form, 0)?;
        return over(weight, &tangent, &tangent_form(&tangent, 0)?);
    }
    let (first, last) = ends(form, 0)?;
    let (p0, p1) = ends(&first, 0)?;
    let (_, p2) = ends(&last, 0)?;
    let [p0, p1, p2] = [p0, p1, p2].map(|p| Scaled::from_form(&p));
    let n = degree as i64;
    scaled_vectors(plane(&p0, &p1, &p2)?, &S::from_integer(n * n * (n - 1)))
}

/// The cross product of two polynomial vectors, divided by a constant.
fn over<S: Scalar>(weight: &S, a: &Form<S>, b: &Form<S>) -> Result<Form<S>> {
    let product = cross(&Scaled::from_form(a), &Scaled::from_form(b))?;
    scaled_vectors(gather(&product), &(S::one() / weight.clone()))
}

/// With the four last points of de Casteljau's scheme, `a = P00`, `b = P10`, `c = P01`,
/// `d = P11`: `(1−u)·((1−v)·[abc] − v·[acd]) + u·((1−v)·[abd] − v·[bcd])`, times `m·n`.
fn rational_surface<S: Scalar>(form: &Form<S>) -> Result<Form<S>> {
    let (low, high) = ends(form, 0)?;
    let ((a, c), (b, d)) = (ends(&low, 1)?, ends(&high, 1)?);
    let [a, b, c, d] = [a, b, c, d].map(|p| Scaled::from_form(&p));
    let corners = [
        (plane(&a, &b, &c)?, [0, 0], 1),
        (plane(&a, &c, &d)?, [0, 1], -1),
        (plane(&a, &b, &d)?, [1, 0], 1),
        (plane(&b, &c, &d)?, [1, 1], -1),
    ];
    let degrees: Vec<usize> = form.degrees().iter().map(|degree| 3 * degree - 2).collect();
    let mut normal = Scaled::zero(&degrees, 4)?;
    for (bracket, side, sign) in corners {
        let mut bilinear = vec![S::zero(); 8];
        let chosen = 2 * (2 * side[0] + side[1]);
        bilinear[chosen] = S::from_integer(sign);
        let factor = Scaled::from_form(&Form::from_homogeneous(&[2, 2], 1, bilinear)?);
        normal.add_product(&bracket, &factor.component(0));
    }
    let sides: usize = form.degrees().iter().product();
    scaled_vectors(normal, &S::from_integer(sides as i64))
}

/// The direction of the plane of three homogeneous points:
/// `w_a·(b × c) + w_b·(c × a) + w_c·(a × b)`, and a weight to be forgotten.
fn plane<S: Scalar>(a: &Scaled<S>, b: &Scaled<S>, c: &Scaled<S>) -> Result<Scaled<S>> {
    let terms = [(a, cross(b, c)?), (b, cross(c, a)?), (c, cross(a, b)?)];
    let mut sums: Vec<Scaled<S>> = Vec::new();
    for (point, products) in terms {
        let weight = point.component(3);
        for (k, product) in products.iter().enumerate() {
            let term = product.times(&weight)?;
            match sums.get_mut(k) {
                Some(sum) => sum.add_multiple(&S::one(), &term),
                None => sums.push(term),
            }
        }
    }
    Ok(gather(&sums))
}

/// The cross product of the first three components.
fn cross<S: Scalar>(a: &Scaled<S>, b: &Scaled<S>) -> Result<Vec<Scaled<S>>> {
    let term = |i: usize, j: usize| a.component(i).times(&b.component(j));
    [(1, 2), (2, 0), (0, 1)].into_iter().map(|(i, j)| Ok(term(i, j)?.minus(&term(j, i)?))).collect()
}

/// Three single components side by side, and one more in place of the weight.
fn gather<S: Scalar>(components: &[Scaled<S>]) -> Scaled<S> {
    let first = components[0].clone();
    components[1..].iter().chain([&first]).fold(first.clone(), |all, next| all.beside(next))
}

fn turned_left<S: Scalar>(tangent: &Form<S>) -> Result<Form<S>> {
    let pairs = tangent.homogeneous().chunks_exact(3);
    let poles = pairs.flat_map(|p| [-p[1].clone(), p[0].clone(), S::one()]).collect();
    Form::from_homogeneous(tangent.orders(), 2, poles)
}

/// A single vector 0.
fn no_vectors<S: Scalar>(form: &Form<S>) -> Result<Form<S>> {
    let orders = vec![1; form.axes()];
    let zeros = vec![S::zero(); form.width()];
    vectors(&Form::from_homogeneous(&orders, form.ambient(), zeros)?)
}
