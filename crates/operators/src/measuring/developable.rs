//! Can a surface be unrolled without stretching? (Book, section 326.)

use pforms_kernel::{Error, Form, Rational, Result, Scalar, Scaled};

use super::about_one::{seen_locally, unit_of, with_weights_about_one};
use super::bending::{bending, difference};
use super::guarded::{Guarded, significant};
use super::{normal_form, surface_frame};
use crate::Spline;

/// What is known about a surface that may be developable.
#[derive(Clone, Debug, PartialEq)]
pub struct Developability {
    /// Does the Gauss curvature vanish everywhere, as far as rounding lets anyone tell?
    pub developable: bool,
    /// Does it vanish identically, in exact arithmetic on the very poles given?
    pub exact: bool,
    /// A Gauss curvature that is not 0, if it is not developable; else 0.
    pub gauss: f64,
    /// The parameters where it is that.
    pub parameters: Vec<f64>,
}

/// The numerator of the Gauss curvature, a form in dimension 1 of weight 1: exact.
///
/// With `N = W³·(f_u × f_v)` it is `(W²·N·f_uu)·(W²·N·f_vv) − (W²·N·f_uv)²`, so the Gauss curvature is
/// `W²/|N|⁴` times it. A surface is developable if and only if it vanishes identically. Degrees up to
/// `10m − 8` (`6m − 4` when all weights are equal).
///
/// Errors: `Shape` unless it is a surface in dimension 3; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::gauss_form;
/// let saddle: Form =
///     Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 1.], None)?;
/// assert!(gauss_form(&saddle)?.points()?.iter().all(|g| *g == -1.0)); // z = x·y: K = −1/|N|⁴
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn gauss_form<S: Scalar>(surface: &Form<S>) -> Result<Form<S>> {
    if surface.axes() != 2 || surface.ambient() != 3 {
        return Err(Error::shape(
            "form",
            format!("a {} in dimension {}", surface.kind(), surface.ambient()),
            "a surface in dimension 3",
        ));
    }
    let normal = normal_form(surface)?;
    let along = |k, l| bending(surface, &normal, k, l);
    let (uu, uv, vv) = (along(0, 0)?, along(0, 1)?, along(1, 1)?);
    let gauss = difference(&uu.times(&vv)?, &uv.times(&uv)?)?;
    gauss.beside(&Scaled::one(gauss.degrees())?).into_form()
}

/// Is a surface developable: can it be laid out flat without stretching?
///
/// The numerator of its Gauss curvature, a polynomial, is computed with its coefficients; it vanishes
/// identically if they all do. In floating arithmetic the coefficients know how much of them may be
/// rounding; where they are no more than that, the question is asked again in exact arithmetic, each
/// `f64` being a fraction. Any surface in space, rational or not, in any parametrisation; of a spline
/// every piece.
///
/// Errors: `Shape` unless it is a surface in dimension 3; `Degenerate` when it is collapsed to a curve
/// or a point; `Domain` when it is at infinity; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::is_developable;
/// // A cylinder over a parabola, and a saddle.
/// let flat = [0., 0., 0., 0., 0., 1., 1., 2., 0., 1., 2., 1., 2., 0., 0., 2., 0., 1.];
/// assert!(is_developable(Form::from_points(&[3, 2], 3, &flat, None)?)?.exact);
/// let saddle: Form =
///     Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 1.], None)?;
/// assert!(!is_developable(saddle)?.developable);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn is_developable<S: Scalar>(surface: impl Into<Spline<S>>) -> Result<Developability> {
    let surface = surface.into();
    let mut answer =
        Developability { developable: true, exact: true, gauss: 0.0, parameters: Vec::new() };
    let breaks = surface.breaks();
    let counts = surface.counts();
    for flat in 0..counts.iter().product::<usize>() {
        let index: Vec<usize> = match counts[..] {
            [_, across] => vec![flat / across, flat % across],
            _ => vec![0; counts.len()],
        };
        let piece = surface.piece(&index)?;
        let exact = if S::EXACT || vanishes_nearly(&piece)? { vanishes(&piece)? } else { false };
        answer.exact &= exact;
        if exact || !S::EXACT && vanishes_nearly(&piece)? {
            continue;
        }
        let (local, gauss) = witness(&piece)?;
        let place = local.iter().zip(&index).zip(&breaks).map(|((t, &i), list)| {
            let (from, to) = (list[i].to_f64(), list[i + 1].to_f64());
            from + (to - from) * t
        });
        if answer.developable || gauss.abs() > answer.gauss.abs() {
            answer.gauss = gauss;
            answer.parameters = place.collect();
        }
        answer.developable = false;
    }
    Ok(answer)
}

/// Does the numerator vanish in exact arithmetic?
fn vanishes<S: Scalar>(piece: &Form<S>) -> Result<bool> {
    if S::EXACT {
        require_surface(normal_form(piece)?.homogeneous().chunks_exact(4), |x| !x.is_zero())?;
        return Ok(gauss_form(piece)?.homogeneous().chunks_exact(2).all(|pole| pole[0].is_zero()));
    }
    let exact: Form<Rational> = piece.exact()?;
    vanishes(&exact)
}

/// Does the numerator vanish but for what may be rounding?
fn vanishes_nearly<S: Scalar>(piece: &Form<S>) -> Result<bool> {
    let local = local(piece)?;
    let normal = normal_form(&local)?;
    require_surface(normal.homogeneous().chunks_exact(4), |x| significant(&[*x]))?;
    let gauss = gauss_form(&local)?;
    // A coefficient that is rounding by itself says nothing of the others: each counts alone.
    Ok(!gauss.homogeneous().chunks_exact(2).any(|pole| significant(&pole[..1])))
}

fn local<S: Scalar>(piece: &Form<S>) -> Result<Form<Guarded>> {
    let floating = with_weights_about_one(&piece.map_scalar(Scalar::to_f64)?)?;
    seen_locally(&floating, unit_of(&floating)?)
}

fn require_surface<'a, S: 'a>(
    mut normals: impl Iterator<Item = &'a [S]>,
    counts: impl Fn(&S) -> bool,
) -> Result<()> {
    if normals.any(|pole| pole[..3].iter().any(&counts)) {
        return Ok(());
    }
    Err(Error::degenerate(
        "form",
        "a surface collapsed to a curve or a point",
        "a surface that has normals",
    ))
}

/// Points along each axis among which a witness is sought.
const WITNESSES: usize = 9;

/// Parameters where the Gauss curvature is clearly not 0, and that curvature.
fn witness<S: Scalar>(piece: &Form<S>) -> Result<(Vec<f64>, f64)> {
    let gauss = gauss_form(&local(piece)?)?.map_scalar(|x| x.value)?;
    // Off the border, where collapsed edges are.
    let list: Vec<f64> = (0..WITNESSES).map(|i| (i as f64 + 0.5) / WITNESSES as f64).collect();
    let values = gauss.grid(&[&list, &list])?;
    let best = (0..values.len()).max_by(|a, b| values[*a].abs().total_cmp(&values[*b].abs()));
    let best = best.unwrap_or(0);
    let place = vec![list[best / WITNESSES], list[best % WITNESSES]];
    let frame = surface_frame(&piece.map_scalar(Scalar::to_f64)?, place[0], place[1])?;
    Ok((place, frame.curvature.map_or(0.0, |bend| bend.gauss)))
}
