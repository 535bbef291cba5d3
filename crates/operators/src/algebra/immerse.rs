//! Immersion: one form exactly inside another.
//!
//! With the homogeneous inner form `(X₁, …, X_e, W)` and `n_j` the degrees of the host,
//! `host ∘ inner = Σ_i P_i · Π_j C(n_j, i_j) · X_j^{i_j} · (W − X_j)^{n_j − i_j}`: products of Bernstein
//! polynomials, nothing to solve. Along inner axis `k` of order `q_k` the result has order
//! `(Σ_j n_j)·(q_k − 1) + 1` (book 2236; `DeRose`, Goldman, Hagen, Mann, *Functional composition via
//! blossoming*, 1993).

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use super::immersion_shape::orders;
use super::nested::compose;

/// What an immersion would cost, known before any work.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Forecast {
    /// Orders of the result.
    pub orders: Vec<usize>,
    /// Number of its poles.
    pub poles: u128,
    /// Bytes they would occupy.
    pub bytes: u128,
}

/// The size of `host ∘ inner` from the orders alone; never refuses.
pub fn forecast<S>(inner_orders: &[usize], host_orders: &[usize], ambient: usize) -> Forecast {
    let degree: usize =
        host_orders.iter().fold(0, |sum: usize, order| sum.saturating_add(order.saturating_sub(1)));
    let orders: Vec<usize> = inner_orders
        .iter()
        .map(|order| degree.saturating_mul(order.saturating_sub(1)).saturating_add(1))
        .collect();
    let poles = orders.iter().fold(1u128, |product, &order| product.saturating_mul(order as u128));
    let bytes = poles.saturating_mul(((ambient + 1) * size_of::<S>()) as u128);
    Forecast { orders, poles, bytes }
}

/// The exact composition `host ∘ inner`, with its poles: the inner form drawn inside the host.
///
/// The inner form lives in the parameter space of the host: its coordinate `k` is parameter `k`.
/// It may have more coordinates than the host has axes if those are all 0. Any inner dimension in
/// any host dimension, polynomial or rational on either side. In `f64`, with the inner poles in
/// `[0, 1]`, every sum has terms of one sign but for the signs of the host's coordinates, and the
/// poles are within 1e-13 of the exact ones up to result degree 27, relative to the largest.
///
/// Errors: `Shape` when the coordinates do not fit the axes; `Limit` with the forecast size.
///
/// ```
/// use pforms_kernel::Form;
/// let facet: Form = Form::from_points(&[2, 2], 1, &[0., 0., 0., 1.], None)?; // u·v
/// let line = Form::from_points(&[2], 2, &[0., 0., 1., 1.], None)?;
/// assert_eq!(pforms_operators::immerse(&line, &facet)?.points()?, [0., 0., 1.]); // t²
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn immerse<S: Scalar>(inner: &Form<S>, host: &Form<S>) -> Result<Form<S>> {
    require_fit(inner, host)?;
    let degree: usize = host.orders().iter().map(|order| order - 1).sum();
    let orders = orders(inner.orders(), degree);
    limit::check::<S>("the immersed form", &orders, host.width())?;
    for order in &orders {
        limit::check_degree::<S>(order - 1)?;
    }
    let poles = compose(inner, host, &orders, constant_weight(inner, host).as_ref());
    Form::from_homogeneous(&orders, host.ambient(), poles)
}

/// Pointwise immersion: the images under any map of the euclidean poles of a form, as a form.
///
/// Not the immersion: the curve drawn by moved poles is close to the moved curve only where the
/// map is nearly affine. Weights are kept.
///
/// Errors: `Domain` when a pole is at infinity; those of the map; `Shape` when its dimensions vary.
pub fn immerse_points<S: Scalar>(
    form: &Form<S>,
    mut map: impl FnMut(&[S]) -> Result<Vec<S>>,
) -> Result<Form<S>> {
    let points = form.points()?;
    let mut images = Vec::with_capacity(points.len());
    let mut ambient = None;
    for point in points.chunks_exact(form.ambient()) {
        let image = map(point)?;
        if *ambient.get_or_insert(image.len()) != image.len() {
            return Err(Error::shape(
                "map",
                format!("an image of {} coordinates", image.len()),
                format!("{} like the first", ambient.unwrap_or_default()),
            ));
        }
        images.extend(image);
    }
    let ambient = ambient.unwrap_or(form.ambient());
    Form::from_points(form.orders(), ambient, &images, Some(&form.weights()))
}

/// Complains unless the inner form lives in the parameter space of the host.
pub(super) fn require_fit<S: Scalar>(inner: &Form<S>, host: &Form<S>) -> Result<()> {
    let axes = host.axes();
    let mut poles = inner.homogeneous().chunks_exact(inner.width());
    let flat = poles.all(|pole| {
        pole.get(axes..inner.ambient()).is_some_and(|surplus| surplus.iter().all(S::is_zero))
    });
    if flat {
        return Ok(());
    }
    Err(Error::shape(
        "inner",
        format!("a {} in {}D", inner.kind(), inner.ambient()),
        format!(
            "a form in {axes}D, one coordinate for each parameter of the host, a {} \
             (further coordinates must be 0)",
            host.kind()
        ),
    ))
}

/// The weight `w·v^degree` of the result when the host has the constant weight `w` and the inner
/// form `v`: polynomial in polynomial is polynomial, to the bit.
fn constant_weight<S: Scalar>(inner: &Form<S>, host: &Form<S>) -> Option<S> {
    let degree = host.orders().iter().map(|order| order - 1).sum();
    let factor = inner.uniform_weight()?.power(degree);
    Some(host.uniform_weight()?.clone() * factor)
}
