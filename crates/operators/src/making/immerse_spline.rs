//! Immersion of splines: cut where the inner form crosses a knot of the host.

use pforms_kernel::{Error, Form, Result, Scalar};

use crate::measuring::roots::sign_changes;
use crate::{Knots, Shape, Spline, derivative, immerse};

/// The composition `host ∘ inner` of forms and splines, as a spline.
///
/// The inner form lives in the parameter space of the host, over the windows of its knots. It is cut
/// where it crosses a knot of the host, so that every piece lies in one piece of the host and is
/// immersed exactly, see [`immerse`]; beyond the window the outermost pieces go on. Its own joints
/// and gaps remain, and a gap of the host becomes one.
///
/// In `f64` the cuts are right to the rounding of the inner form, which the result, being continuous
/// there, feels no more than other roundings. In exact arithmetic the result is exact, or refused
/// where a crossing is not a fraction. Catalogue 3; `DeRose` and others, 1993.
///
/// Errors: as [`immerse`]; `Domain` when a surface or volume crosses a knot of the host along
/// anything but its own parameter lines, since the pieces are then no tensor products.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Spline, immerse_spline};
/// let net: Form = Form::from_points(&[3], 2, &[0., 0., 1., 1., 2., 0.], None)?;
/// let host = Spline::new(net, &[1], vec![vec![0., 0., 1., 2., 2.]])?; // a roof over [0, 2]
/// let inner: Form = Form::from_points(&[2], 1, &[0., 2.], None)?;
/// let line = immerse_spline(&inner.into(), &host.into())?;
/// assert_eq!(line.breaks(), [[0., 0.5, 1.]]);
/// assert_eq!(line.at(&[0.25])?, [0.5, 0.5]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn immerse_spline<S: Scalar>(inner: &Shape<S>, host: &Shape<S>) -> Result<Spline<S>> {
    let inner = inner.clone().into_spline();
    let host = match host {
        Shape::Form(form) => return inner.map_pieces(|piece, _| immerse(piece, form)),
        Shape::Spline(host) => host,
    };
    require_coordinates(&inner, host)?;
    cut(&inner, host)?.map_pieces(|piece, _| immerse_in_piece(piece, host))
}

fn require_coordinates<S: Scalar>(inner: &Spline<S>, host: &Spline<S>) -> Result<()> {
    if inner.ambient() >= host.axes() {
        return Ok(());
    }
    Err(Error::shape(
        "inner",
        format!("a {} in {}D", inner.net().kind(), inner.ambient()),
        format!("a form in {}D, one coordinate for each parameter of the host", host.axes()),
    ))
}

/// The inner spline with knots where it crosses those of the host.
fn cut<S: Scalar>(inner: &Spline<S>, host: &Spline<S>) -> Result<Spline<S>> {
    let mut result = if has_gaps(host) { parted(inner)? } else { inner.clone() };
    let breaks = inner.breaks();
    let counts = inner.counts();
    for (index, piece) in indexed(&counts, inner.pieces()?) {
        for (coordinate, knots) in host.knots().iter().enumerate() {
            for knot in inner_breaks(knots) {
                let height = height_over(&piece, coordinate, &knot);
                let Some((axis, row)) = profile(&piece, &height, coordinate, &knot)? else {
                    continue;
                };
                let (from, to) = (&breaks[axis][index[axis]], &breaks[axis][index[axis] + 1]);
                for local in crossings(&row, coordinate, &knot)? {
                    let t = from.clone() + local * (to.clone() - from.clone());
                    result = with_knot(&result, axis, &t, is_gap(knots, &knot))?;
                }
            }
        }
    }
    Ok(result)
}

fn has_gaps<S: Scalar>(host: &Spline<S>) -> bool {
    host.knots().iter().any(|knots| inner_breaks(knots).any(|t| is_gap(knots, &t)))
}

fn is_gap<S: Scalar>(knots: &Knots<S>, t: &S) -> bool {
    knots.multiplicity(t) > knots.degree()
}

fn inner_breaks<S: Scalar>(knots: &Knots<S>) -> impl Iterator<Item = S> {
    let breaks = knots.breaks();
    let inner = breaks.len() - 2;
    breaks.into_iter().skip(1).take(inner)
}

/// The spline with a gap at every break: any of them may lie on a gap of the host.
fn parted<S: Scalar>(inner: &Spline<S>) -> Result<Spline<S>> {
    let mut result = inner.clone();
    for (axis, knots) in inner.knots().iter().enumerate() {
        for t in inner_breaks(knots) {
            result = with_knot(&result, axis, &t, true)?;
        }
    }
    Ok(result)
}

/// The pieces with their indices, the last axis fastest.
fn indexed<S: Scalar>(
    counts: &[usize],
    pieces: Vec<Form<S>>,
) -> impl Iterator<Item = (Vec<usize>, Form<S>)> {
    pieces.into_iter().enumerate().map(move |(flat, piece)| {
        let mut rest = flat;
        let mut index: Vec<usize> = counts
            .iter()
            .rev()
            .map(|count| {
                let i = rest % count;
                rest /= count;
                i
            })
            .collect();
        index.reverse();
        (index, piece)
    })
}

/// Bernstein coefficients of `X_k − knot·W`: where they change sign the form crosses the knot.
fn height_over<S: Scalar>(piece: &Form<S>, coordinate: usize, knot: &S) -> Vec<S> {
    let width = piece.width();
    let height = |pole: &[S]| {
        let reach = knot.clone() * pole[width - 1].clone();
        let height = pole[coordinate].clone() - reach.clone();
        if is_rounding(&height, &reach) { S::zero() } else { height }
    };
    piece.homogeneous().chunks_exact(width).map(height).collect()
}

/// Is `x` no more than a few roundings of `size`? Never so in exact arithmetic.
fn is_rounding<S: Scalar>(x: &S, size: &S) -> bool {
    !S::EXACT && x.to_f64().abs() <= 4.0 * f64::EPSILON * size.to_f64().abs()
}

/// The axis along which the form crosses the knot, and the heights along it; `None` when it stays on
/// one side.
fn profile<S: Scalar>(
    piece: &Form<S>,
    height: &[S],
    coordinate: usize,
    knot: &S,
) -> Result<Option<(usize, Vec<S>)>> {
    let zero = S::zero();
    if height.iter().all(|h| *h >= zero) || height.iter().all(|h| *h <= zero) {
        return Ok(None);
    }
    let form = Form::from_homogeneous(piece.orders(), 1, beside_ones(height))?;
    for axis in 0..piece.axes() {
        let across = (0..piece.axes()).filter(|&other| other != axis);
        if across.clone().all(|other| is_constant_along(&form, other)) {
            let mut line = form.clone();
            for other in across.rev() {
                let mut first = vec![S::zero(); line.orders()[other]];
                first[0] = S::one();
                line = line.contract(other, &first)?;
            }
            let row = line.homogeneous().iter().step_by(2).cloned().collect();
            return Ok(Some((axis, row)));
        }
    }
    Err(Error::domain(
        "inner",
        format!(
            "a {} that crosses the knot {knot:?} of parameter {coordinate} aslant",
            piece.kind()
        ),
        "one that crosses it along its own parameter lines, so that it can be cut there \
         (curves may cross anywhere)",
    ))
}

fn beside_ones<S: Scalar>(height: &[S]) -> Vec<S> {
    height.iter().flat_map(|h| [h.clone(), S::one()]).collect()
}

fn is_constant_along<S: Scalar>(form: &Form<S>, axis: usize) -> bool {
    let mut orders = vec![0; form.axes()];
    orders[axis] = 1;
    let size = form.homogeneous().iter().fold(0.0_f64, |most, x| most.max(x.to_f64().abs()));
    let size = S::from_f64(size).unwrap_or_else(S::one);
    derivative(form, &orders).is_ok_and(|slope| {
        let rises = slope.homogeneous().iter().step_by(2);
        rises.into_iter().all(|rise| rise.is_zero() || is_rounding(rise, &size))
    })
}

/// Parameters inside `(0, 1)` where the heights change sign.
fn crossings<S: Scalar>(row: &[S], coordinate: usize, knot: &S) -> Result<Vec<S>> {
    let floating: Vec<f64> = row.iter().map(S::to_f64).collect();
    let found = sign_changes(&floating).into_iter();
    found
        .map(|t| {
            let exact = if S::EXACT { fraction_near(row, t) } else { S::from_f64(t) };
            exact.ok_or_else(|| {
                Error::domain(
                    "inner",
                    format!("a crossing of the knot {knot:?} of parameter {coordinate} near {t}"),
                    "crossings at fractions, in exact mode (use floating mode)",
                )
            })
        })
        .collect()
}

/// The fraction next to `t`, among those of its continued fraction, at which the polynomial is 0.
fn fraction_near<S: Scalar>(row: &[S], t: f64) -> Option<S> {
    let vanishes = |x: &S| {
        let form = Form::from_homogeneous(&[row.len()], 1, beside_ones(row));
        form.and_then(|form| form.homogeneous_at(std::slice::from_ref(x)))
            .is_ok_and(|value| value[0].is_zero())
    };
    let (mut before, mut now) = ((0_i64, 1_i64), (1_i64, 0_i64));
    let mut rest = t;
    while rest.is_finite() && rest.abs() < 1e9 {
        let whole = rest.floor();
        let step = |a: i64, b: i64| (whole as i64).checked_mul(b)?.checked_add(a);
        let next = (step(before.0, now.0)?, step(before.1, now.1)?);
        (before, now) = (now, next);
        let candidate = S::ratio(now.0, now.1);
        if vanishes(&candidate) {
            return Some(candidate);
        }
        rest = 1.0 / (rest - whole);
    }
    S::from_f64(t).filter(vanishes)
}

/// The spline with a knot at `t`: a gap when the host parts there; none where a break is already.
fn with_knot<S: Scalar>(spline: &Spline<S>, axis: usize, t: &S, parts: bool) -> Result<Spline<S>> {
    let (from, to) = spline.window(axis)?;
    let length = to - from;
    let breaks = &spline.breaks()[axis];
    let near = |b: &&S| **b == *t || is_rounding(&((*b).clone() - t.clone()), &length);
    let place = breaks.iter().find(near).unwrap_or(t).clone();
    let ends = [&breaks[0], &breaks[breaks.len() - 1]];
    if ends.contains(&&place) {
        return Ok(spline.clone());
    }
    let knots = &spline.knots()[axis];
    let wanted = if parts { knots.degree() + 1 } else { 1 };
    let missing = wanted.saturating_sub(knots.multiplicity(&place));
    spline.insert_knots(axis, &vec![place; missing])
}

/// Immerses a form that lies within one piece of the host.
fn immerse_in_piece<S: Scalar>(piece: &Form<S>, host: &Spline<S>) -> Result<Form<S>> {
    let width = piece.width();
    let mut poles = piece.homogeneous().to_vec();
    let mut index = Vec::with_capacity(host.axes());
    for (coordinate, knots) in host.knots().iter().enumerate() {
        let breaks = knots.breaks();
        let which = piece_of(piece, coordinate, &breaks)?;
        let (from, to) = (&breaks[which], &breaks[which + 1]);
        let length = to.clone() - from.clone();
        for pole in poles.chunks_exact_mut(width) {
            let start = from.clone() * pole[width - 1].clone();
            pole[coordinate] = (pole[coordinate].clone() - start) / length.clone();
        }
        index.push(which);
    }
    let inner = Form::from_homogeneous(piece.orders(), piece.ambient(), poles)?;
    immerse(&inner, &host.piece(&index)?)
}

/// The interval of `breaks` in which the form's coordinate lies: of a few inner points that one
/// decides which is farthest from a break, since others may touch it.
fn piece_of<S: Scalar>(piece: &Form<S>, coordinate: usize, breaks: &[S]) -> Result<usize> {
    let inner = &breaks[1..breaks.len() - 1];
    let mut best: Option<(S, usize)> = None;
    for (numerator, denominator) in [(1, 2), (1, 3), (3, 4)] {
        let at = vec![S::ratio(numerator, denominator); piece.axes()];
        let pole = piece.homogeneous_at(&at)?;
        let weight = &pole[piece.ambient()];
        if weight.is_zero() {
            continue;
        }
        let x = pole[coordinate].clone() / weight.clone();
        let which = inner.iter().filter(|knot| **knot <= x).count();
        let mut clearance: Option<S> = None;
        for knot in inner {
            let gap = if *knot > x { knot.clone() - x.clone() } else { x.clone() - knot.clone() };
            if clearance.as_ref().is_none_or(|least| gap < *least) {
                clearance = Some(gap);
            }
        }
        let clearance = clearance.unwrap_or_else(S::zero);
        if best.as_ref().is_none_or(|(most, _)| clearance > *most) {
            best = Some((clearance, which));
        }
    }
    Ok(best.map_or(0, |(_, which)| which))
}
