//! Work that nobody would wait for is refused before it begins.
//!
//! The kernel caps what a result may occupy. A sheet is also typed in by hand, where a slip of the
//! finger must not stop it, so here the time is capped too: to some ten seconds in floating mode,
//! and as roughly in exact mode. Rust and Python may go beyond.

use pforms_kernel::{Error, Form, Kind};
use pforms_operators::{Immersed, Knots, Poles, Shape, Spline, pointwise_work};

use crate::arithmetic::require_plain;
use crate::{Arithmetic, Failure};

/// Multiplications of short numbers that one call may take.
fn cap<S: Arithmetic>() -> f64 {
    if S::EXACT { 2e7 } else { 1e10 }
}

/// The form, if a dense matrix may act along each of its axes: `order³` to make one.
pub(crate) fn workable<S: Arithmetic>(form: Form<S>) -> Result<Form<S>, Failure> {
    workable_at(form, &[])
}

/// The spline, if every pole may be mixed with its neighbours along each axis.
pub(crate) fn workable_spline<S: Arithmetic>(spline: Spline<S>) -> Result<Spline<S>, Failure> {
    let squares = spline.degrees().into_iter().map(|degree| ((degree + 1) as f64).powi(2));
    let (net, knots) = (spline.net(), spline.knots().iter().map(Knots::as_slice).map(longest));
    let bits = longest(net.homogeneous()) + knots.fold(0.0, f64::max);
    require::<S>(net.homogeneous().len() as f64 * squares.sum::<f64>() * long(bits))?;
    Ok(spline)
}

/// [`workable`] or [`workable_spline`].
pub(crate) fn workable_shape<S: Arithmetic>(shape: Shape<S>) -> Result<Shape<S>, Failure> {
    match shape {
        Shape::Form(form) => workable(form).map(Shape::Form),
        Shape::Spline(spline) => workable_spline(spline).map(Shape::Spline),
    }
}

/// [`workable`] for a matrix of powers of `parameters`.
pub(crate) fn workable_at<S: Arithmetic>(
    form: Form<S>,
    parameters: &[S],
) -> Result<Form<S>, Failure> {
    let degree = form.degrees().into_iter().max().unwrap_or(0);
    let cube = |order: &usize| (*order as f64).powi(3);
    let work: f64 = form.orders().iter().map(cube).sum();
    require::<S>(work * long(longest(form.homogeneous()) + degree as f64 * longest(parameters)))?;
    Ok(form)
}

/// Passes if the form may be evaluated `count` times at parameters of so many bits.
pub(crate) fn require_points<S: Arithmetic>(
    form: &Form<S>,
    count: usize,
    bits: f64,
) -> Result<(), Failure> {
    let degree: usize = form.degrees().iter().sum();
    let work = (count * form.homogeneous().len()) as f64;
    require::<S>(work * long(longest(form.homogeneous()) + degree as f64 * bits))
}

/// Bits of the longest number.
pub(crate) fn longest<S: Arithmetic>(numbers: &[S]) -> f64 {
    if S::EXACT { numbers.iter().map(S::bits).fold(0.0, f64::max) } else { 0.0 }
}

/// What a multiplication of fractions of so many bits costs: with its reduction to lowest terms it
/// grows with the square.
fn long(bits: f64) -> f64 {
    (bits / 64.0).max(1.0).powi(2)
}

/// The form, if it may be multiplied by itself a few times: `poles²`, and growing.
pub(crate) fn multipliable<S: Arithmetic>(form: Form<S>) -> Result<Form<S>, Failure> {
    let poles = form.pole_count() as f64;
    let bits = longest(form.homogeneous());
    require::<S>(64.0 * poles * poles * form.width() as f64 * long(bits))?;
    Ok(form)
}

/// Passes if every matrix may be applied to every pole of a section.
pub(crate) fn require_sweepable<S: Arithmetic>(
    matrix: &Form<S>,
    section: &Form<S>,
) -> Result<(), Failure> {
    let work = matrix.homogeneous().len() as f64 * section.pole_count() as f64;
    require::<S>(work * long(longest(matrix.homogeneous()) + longest(section.homogeneous())))
}

/// Passes if every pole of the one may be multiplied with every pole of the other.
pub(crate) fn require_product<S: Arithmetic>(f: &Form<S>, g: &Form<S>) -> Result<(), Failure> {
    let work = f.homogeneous().len() as f64 * g.homogeneous().len() as f64;
    require::<S>(work * long(longest(f.homogeneous()) + longest(g.homogeneous())))
}

/// Passes if the points of forms may be combined over their common denominator.
pub(crate) fn require_combinable<S: Arithmetic>(forms: &[&Form<S>]) -> Result<(), Failure> {
    let bits: f64 = forms.iter().map(|form| longest(form.homogeneous())).sum();
    require::<S>(pointwise_work(forms) * long(bits))
}

/// Passes if `inner` may be immersed in `host`, `copies` times.
pub(crate) fn require_immersible<S: Arithmetic>(
    inner: &Form<S>,
    host: &Form<S>,
    copies: usize,
) -> Result<(), Failure> {
    let size = |degree: usize| -> f64 {
        inner.orders().iter().map(|order| (degree * (order - 1) + 1) as f64).product()
    };
    let mut work = 0.0;
    let mut done = 0;
    for axis in (0..host.axes()).rev() {
        let degree = host.orders()[axis] - 1;
        let products: f64 = host.orders()[..=axis].iter().map(|&order| order as f64).product();
        work += products * size(done) * size(degree) * host.width() as f64;
        done += degree;
    }
    let bits = longest(host.homogeneous()) + done as f64 * longest(inner.homogeneous());
    require::<S>(work * copies as f64 * long(bits))
}

/// [`require_immersible`] for splines, cut where they cross the knots of the host: where that is,
/// is found in plain numbers.
pub(crate) fn require_bendable<S: Arithmetic>(
    inner: &Shape<S>,
    host: &Shape<S>,
    copies: usize,
) -> Result<(), Failure> {
    let (inside, outside) = (inner.clone().into_spline(), host.clone().into_spline());
    let first = |spline: &Spline<S>| spline.piece(&vec![0; spline.axes()]);
    let pieces = inside.counts().iter().product::<usize>();
    let knots = outside.counts().iter().sum::<usize>();
    let copies = copies.saturating_mul(pieces.saturating_mul(knots));
    require_immersible(&first(&inside)?, &first(&outside)?, copies)?;
    if knots > outside.axes() {
        require_plain(inside.net().homogeneous())?;
    }
    Ok(())
}

/// The poles of an immersed form that was kept unexpanded.
pub(crate) fn expanded<S: Arithmetic>(lazy: &Immersed<S>) -> Result<Form<S>, Failure> {
    require_immersible(lazy.inner(), lazy.host(), 1)?;
    Ok(lazy.expand()?)
}

/// Poles whose coefficients EXPLAIN can print on a few pages.
const EXPLAINED: f64 = 400.0;

/// Passes if the coefficients of all poles fit on pages that somebody reads.
pub(crate) fn require_readable(kinds: &[Kind]) -> Result<(), Failure> {
    let poles = |kind: &Kind| kind.orders().iter().map(|&order| order as f64).product::<f64>();
    let total: f64 = kinds.iter().map(poles).sum();
    if total <= EXPLAINED {
        return Ok(());
    }
    let error = Error::domain("kinds", format!("{total} poles"), format!("at most {EXPLAINED}"));
    Err(Failure::of(error, format!("genres : reçu {total} pôles, attendu au plus {EXPLAINED}")))
}

/// Passes if a linear system for the poles inside a boundary may be solved.
pub(crate) fn require_system<S: Arithmetic>(
    boundary: &[Shape<S>],
    orders: &[usize],
) -> Result<(), Failure> {
    let mut poles: f64 = match boundary {
        [single] => single.net().pole_count() as f64,
        // Two faces for each axis: the product of the counts of those across two of them.
        faces => {
            faces.iter().map(|face| face.net().pole_count() as f64).fold(1.0, f64::max).powi(2)
        }
    };
    poles = poles.max(orders.iter().map(|&order| order as f64).product());
    let bits = boundary.iter().map(|shape| longest(shape.net().homogeneous())).fold(0.0, f64::max);
    require::<S>(poles.powf(2.5) * long(bits))
}

fn require<S: Arithmetic>(work: f64) -> Result<(), Failure> {
    let cap = cap::<S>();
    if work <= cap {
        return Ok(());
    }
    Err(Failure::new(
        "Limit",
        format!("about {work:.0e} multiplications: refused, the cap is {cap:.0e}"),
        format!("environ {work:.0e} multiplications : refusé, le plafond est {cap:.0e}"),
    ))
}
