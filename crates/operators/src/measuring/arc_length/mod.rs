//! Arc length: from parameters to lengths and back (course, "paramétrisation normale").

mod parameter;
mod speed;
mod sum;

use pforms_kernel::{Error, Form, Result};

pub(crate) use self::speed::Speed;
use self::sum::Sum;
use super::scale::{in_units, unit};
use crate::algebra::Shape;

/// A curve whose length has been measured: the way from parameters to lengths and back.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::ArcLength;
/// let parabola: Form = Form::from_points(&[3], 2, &[0., 0., 0.5, 0., 1., 1.], None)?; // (t, t²)
/// let measured = ArcLength::new(parabola, 1e-12)?;
/// let wanted = 0.5 * 5.0_f64.sqrt() + 0.25 * 2.0_f64.asinh();
/// assert!((measured.length() - wanted).abs() < 1e-14);
/// let half = measured.parameter(0.5 * measured.length())?;
/// assert!((measured.up_to(half)? - 0.5 * wanted).abs() < 1e-14);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct ArcLength {
    stretches: Vec<Stretch>,
    /// Parameters where the pieces meet.
    breaks: Vec<f64>,
    length: f64,
    error: f64,
    /// What lengths of `stretches` are to be multiplied by.
    unit: f64,
}

/// A window on which the length is known well enough.
#[derive(Clone, Debug)]
struct Stretch {
    /// The piece, and the window in its own parameter.
    piece: usize,
    from: f64,
    to: f64,
    speed: Speed,
    /// Length of all stretches before this one.
    before: f64,
    length: f64,
    error: f64,
    /// May its length be integrated? Otherwise it is so short that its polygon tells enough.
    smooth: bool,
}

/// Stretches one curve may take, and as many more as it has pieces times [`EACH`]; a cusp takes some
/// fifty.
const MOST: usize = 1 << 16;

/// Stretches a piece takes on the average, at most.
const EACH: usize = 32;

/// Roundings that sums of positive terms may hold, in units of the result.
const ROUNDINGS: f64 = 8.0;

/// How often the whole may be measured again when it was shorter than its polygon promised.
const ATTEMPTS: usize = 4;

impl ArcLength {
    /// Measures a curve over its window, to `accuracy` relative to its length.
    ///
    /// The error is bounded, not estimated: a stretch is integrated by 16 points of Gauss where the
    /// speed is shown to be analytic in a disc around it, and halved elsewhere; what is left around a
    /// cusp lies between chord and control polygon. The bounds hold up to rounding, of which some
    /// `10⁻¹⁵` of the length are reported too.
    ///
    /// Errors: `Shape` unless the form is a curve; `Domain` when `accuracy` is not between 0 and 1
    /// or the curve goes to infinity; `Accuracy` when the bound cannot be had.
    pub fn new(curve: impl Into<Shape>, accuracy: f64) -> Result<Self> {
        let curve = curve.into().into_spline();
        if curve.axes() != 1 {
            let received = format!("a form with {} axes", curve.axes());
            return Err(Error::shape("curve", received, "a curve"));
        }
        require_accuracy(accuracy)?;
        let breaks = curve.breaks().swap_remove(0);
        let pieces = curve.pieces()?;
        let unit = unit(&pieces);
        let pieces =
            pieces.iter().map(|piece| in_units(piece, unit)).collect::<Result<Vec<_>>>()?;
        let (mut scale, mut worst) = (1.0, None);
        for _ in 0..ATTEMPTS {
            let measured = Self::attempt(&pieces, accuracy, accuracy * scale)?;
            let length = measured.iter().map(|stretch| stretch.length).collect::<Sum>().value();
            let error = measured.iter().map(|stretch| stretch.error).sum::<f64>();
            if error <= accuracy * length || length == 0.0 {
                let error = error + ROUNDINGS * f64::EPSILON * length;
                return Ok(Self {
                    stretches: measured,
                    breaks,
                    length: length * unit,
                    error: error * unit,
                    unit,
                });
            }
            scale = 1e-3 * (length / error * accuracy).min(scale);
            worst = measured.into_iter().max_by(|a, b| a.error.total_cmp(&b.error));
        }
        Err(match worst {
            Some(stretch) => given_up(&pieces[stretch.piece], stretch.from, accuracy)?,
            None => not_reached(accuracy),
        })
    }

    /// The length over the whole window.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// By how much the true length may differ, at most.
    pub fn error(&self) -> f64 {
        self.error
    }

    fn attempt(pieces: &[Form], accuracy: f64, crumb: f64) -> Result<Vec<Stretch>> {
        let most = MOST.saturating_add(EACH.saturating_mul(pieces.len()));
        let mut stretches = Vec::new();
        let mut before = Sum::default();
        for (piece, form) in pieces.iter().enumerate() {
            let mut waiting = vec![(0.0, 1.0)];
            while let Some((from, to)) = waiting.pop() {
                let speed = Speed::of(form, from, to)?;
                let middle = 0.5 * (from + to);
                let last = !(from < middle && middle < to);
                let Some((length, error, smooth)) = settled(&speed, accuracy, crumb, last)? else {
                    waiting.extend([(middle, to), (from, middle)]);
                    if stretches.len() + waiting.len() > most {
                        return Err(given_up(form, from, accuracy)?);
                    }
                    continue;
                };
                let start = before.value();
                let stretch =
                    Stretch { piece, from, to, speed, before: start, length, error, smooth };
                stretches.push(stretch);
                before.add(length);
            }
        }
        Ok(stretches)
    }
}

/// The length of a stretch, its error and whether it was integrated; `None` if it is to be halved.
fn settled(
    speed: &Speed,
    accuracy: f64,
    crumb: f64,
    last: bool,
) -> Result<Option<(f64, f64, bool)>> {
    /// Part of the accuracy that integration may use up; the rest is for what lies around cusps.
    const SHARE: f64 = 0.5;
    /// Cusps that share what is left.
    const CUSPS: f64 = 64.0;
    if let Some(bound) = speed.bound()? {
        let integral = speed.integral(0.0, 1.0)?;
        let length =
            speed.polygon().map_or(integral, |[chord, most]| integral.min(most).max(chord));
        if bound <= SHARE * accuracy * length {
            return Ok(Some((length, bound, true)));
        }
    }
    match speed.polygon() {
        // Short as a whole, so that it does not matter either where in it a length is reached.
        Some([chord, polygon]) if last || polygon <= SHARE * crumb / CUSPS => {
            Ok(Some((0.5 * (chord + polygon), 0.5 * (polygon - chord), false)))
        }
        None if last => Err(infinite()),
        _ => Ok(None),
    }
}

fn require_accuracy(accuracy: f64) -> Result<()> {
    if !(accuracy > 0.0 && accuracy < 1.0) {
        return Err(Error::domain("accuracy", accuracy, "a number between 0 and 1"));
    }
    if accuracy < 2.0 * ROUNDINGS * f64::EPSILON {
        return Err(not_reached(accuracy));
    }
    Ok(())
}

/// Why a piece could not be measured near `t`: a double zero of the weight looks like a cusp.
fn given_up(piece: &Form, t: f64, accuracy: f64) -> Result<Error> {
    /// The square of a parameter's rounding, and some.
    const VANISHED: f64 = 1e-12;
    let here = piece.homogeneous_at(&[t])?[piece.ambient()].abs();
    let heaviest = piece.weights().iter().fold(0.0_f64, |most, w| most.max(w.abs()));
    Ok(if here <= VANISHED * heaviest { infinite() } else { not_reached(accuracy) })
}

fn infinite() -> Error {
    Error::domain(
        "curve",
        "a curve that goes to infinity, where its weight vanishes",
        "a curve of finite length",
    )
}

fn not_reached(accuracy: f64) -> Error {
    Error::accuracy("accuracy", accuracy, "an accuracy that the curve's numbers allow")
}
