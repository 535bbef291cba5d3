//! Diagonalisation: two parameters become one.
//!
//! `q_k = Σ_{i+j=k} C(m−1,i)·C(n−1,j)/C(m+n−2,k) · p_ij`, means along the antidiagonals (book 12 and
//! 13).

#![allow(clippy::inline_always, reason = "only what is inlined is compiled for the wider vectors")]

use pforms_kernel::vectors::{Job, Simd};
use pforms_kernel::{Binomials, Error, Form, Result, Scalar, limit};
use smallvec::SmallVec;

/// The form on the diagonal of axes `first` and `second`: orders `m` and `n` give `m + n − 1`.
///
/// The new axis stands where the lower of the two stood. In `f64` every pole is a mean of old
/// ones with positive weights, within `order + 5` roundings of the exact one.
///
/// Errors: `Shape` when the axes are the same or not there; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// let facet: Form = Form::from_points(&[2, 2], 1, &[0., 1., 3., 4.], None)?;
/// assert_eq!(pforms_operators::diagonal(&facet, 0, 1)?.points()?, [0., 2., 4.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn diagonal<S: Scalar>(form: &Form<S>, first: usize, second: usize) -> Result<Form<S>> {
    require_two_axes(form)?;
    if first == second {
        return Err(Error::shape("axes", format!("({first}, {second})"), "two different axes"));
    }
    form.require_axis(first)?;
    form.require_axis(second)?;
    let (low, high) = (first.min(second), first.max(second));
    let mut orders: SmallVec<[usize; 8]> = form.orders().into();
    orders[low] += orders.remove(high) - 1;
    limit::check::<S>("the diagonal", &orders, form.width())?;
    limit::check_degree::<S>(orders[low] - 1)?;
    let mut poles = vec![S::zero(); orders.iter().product::<usize>() * form.width()];
    S::in_lanes(Antidiagonals { form, low, high, poles: &mut poles });
    let merged = Form::from_homogeneous(&orders, form.ambient(), poles)?;
    Ok(match form.uniform_weight() {
        Some(weight) => merged.with_uniform_weight(weight),
        None => merged,
    })
}

/// Adds up the poles along the antidiagonals of two axes.
struct Antidiagonals<'a, S> {
    form: &'a Form<S>,
    low: usize,
    high: usize,
    poles: &'a mut [S],
}

impl<S: Scalar> Job for Antidiagonals<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<V: Simd>(self, _: V) {
        let after = &self.form.orders()[self.high + 1..];
        let inner = after.iter().product::<usize>() * self.form.width();
        let orders = self.form.orders();
        let (m, n) = (orders[self.low], orders[self.high]);
        let between: usize = orders[self.low + 1..self.high].iter().product();
        let shares = shares::<S>(m, n);
        let blocks = self.form.homogeneous().chunks_exact(m * between * n * inner);
        let targets = self.poles.chunks_exact_mut((m + n - 1) * between * inner);
        for (source, target) in blocks.zip(targets) {
            for (index, line) in source.chunks_exact(inner).enumerate() {
                let (i, b, j) = (index / n / between, index / n % between, index % n);
                let place = ((i + j) * between + b) * inner;
                S::add_multiple(&mut target[place..][..inner], &shares[i * n + j], line);
            }
        }
    }
}

/// What each pole of an `m × n` net contributes to the mean along its antidiagonal.
fn shares<S: Scalar>(m: usize, n: usize) -> SmallVec<[S; 32]> {
    let row = Binomials::<S>::of;
    let (left, right, whole) = (row(m - 1), row(n - 1), row(m + n - 2));
    let mut shares = SmallVec::new();
    for i in 0..m {
        shares.extend((0..n).map(|j| left.get(i) * right.get(j) / whole.get(i + j)));
    }
    shares
}

/// The curve on the diagonal of all axes: the last two are merged until one is left.
///
/// Errors: as [`diagonal`]; a form of fewer than two axes has no diagonal.
pub fn diagonal_all<S: Scalar>(form: &Form<S>) -> Result<Form<S>> {
    require_two_axes(form)?;
    let mut curve = form.clone();
    while curve.axes() > 1 {
        curve = diagonal(&curve, curve.axes() - 2, curve.axes() - 1)?;
    }
    Ok(curve)
}

fn require_two_axes<S: Scalar>(form: &Form<S>) -> Result<()> {
    if form.axes() >= 2 {
        return Ok(());
    }
    Err(Error::shape("form", format!("a {}", form.kind()), "a form with at least two axes"))
}
