//! A curve run through at unit speed (course, "paramétrisation normale").

use pforms_kernel::{Error, Form, Result};

use crate::algebra::{Shape, Spline, immerse, stretch};
use crate::measuring::ArcLength;

/// A curve by its own length.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitSpeed {
    /// The same curve over the window from 0 to its length.
    pub spline: Spline,
    /// The length of the curve.
    pub length: f64,
    /// How far its speed is from 1, at most, as measured at 17 places of every piece.
    pub error: f64,
}

/// Pieces one curve may be cut into.
const MOST: usize = 1 << 14;

/// Places of a piece where its speed is measured.
const PLACES: usize = 17;

/// The curve as a function of its length, within `accuracy` of unit speed.
///
/// No curve but a straight line can have unit speed exactly and be rational (Farouki and Sakkalis
/// 1991), so the parameter is made a spline of the length: polynomials of degree 5 with the right value
/// and two right derivatives at their ends, immersed in the curve. Every point therefore stays on the
/// curve, exactly; only the speed is approximated, and at the joints of the pieces it is right. The
/// degree becomes 5 times that of the curve; four times the pieces make the error 1024 times less.
///
/// Errors: `Shape` unless it is a curve; `Degenerate` where it stands still; `Domain` unless
/// `accuracy` is between 0 and 1, or where the curve goes to infinity; `Accuracy` when it cannot be
/// reached.
///
/// ```
/// use pforms_kernel::Form;
/// let parabola: Form = Form::from_points(&[3], 2, &[0., 0., 0.5, 0., 1., 1.], None)?;
/// let even = pforms_operators::by_arc_length(parabola, 1e-9)?;
/// assert!(even.error < 1e-9);
/// let [x, y] = even.spline.at(&[0.5 * even.length])?[..] else { panic!("two coordinates") };
/// assert!((y - x * x).abs() < 1e-15);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn by_arc_length(curve: impl Into<Shape>, accuracy: f64) -> Result<UnitSpeed> {
    let curve = curve.into().into_spline();
    let measured = ArcLength::new(curve.clone(), measured_to(accuracy))?;
    if measured.length() == 0.0 {
        return Err(stands_still());
    }
    let breaks = &curve.breaks()[0];
    let mut cut = Cut { measured: &measured, forms: Vec::new(), breaks: vec![0.0], error: 0.0 };
    for (piece, window) in curve.pieces()?.iter().zip(breaks.windows(2)) {
        cut.piece(piece, [window[0], window[1]], accuracy)?;
    }
    let spline = Spline::end_to_end(&cut.forms, 0, &cut.breaks)?;
    Ok(UnitSpeed { spline, length: measured.length(), error: cut.error })
}

/// The accuracy of lengths: beyond what rounding allows they need not go.
fn measured_to(accuracy: f64) -> f64 {
    if accuracy > 0.0 { accuracy.max(1e-14) } else { accuracy }
}

struct Cut<'a> {
    measured: &'a ArcLength,
    forms: Vec<Form>,
    /// Lengths at which the forms begin and end.
    breaks: Vec<f64>,
    error: f64,
}

impl Cut<'_> {
    /// Cuts one piece of the curve, whose parameter runs over `window`, until each part is even enough.
    fn piece(&mut self, piece: &Form, window: [f64; 2], accuracy: f64) -> Result<()> {
        let [from, to] = window;
        let start = self.breaks[self.breaks.len() - 1];
        let mut waiting = vec![([start, self.measured.up_to(to)?], [0.0, 1.0])];
        while let Some((lengths, local)) = waiting.pop() {
            let part = Part::new(piece, local, lengths[1] - lengths[0])?;
            let error = part.error()?;
            if error <= accuracy {
                self.push(&part, lengths[1])?;
                self.error = self.error.max(error);
                continue;
            }
            let half = 0.5 * (lengths[0] + lengths[1]);
            let parameter = (self.measured.parameter(half)? - from) / (to - from);
            let apart = local[0] < parameter && parameter < local[1];
            if !apart || self.forms.len() + waiting.len() > MOST {
                return Err(Error::accuracy(
                    "accuracy",
                    accuracy,
                    format!("an accuracy that the curve allows: {error:.1e} is left"),
                ));
            }
            waiting.push(([half, lengths[1]], [parameter, local[1]]));
            waiting.push(([lengths[0], half], [local[0], parameter]));
        }
        Ok(())
    }

    /// Adds a part, which begins in the very pole where the one before it ends, if they do meet.
    fn push(&mut self, part: &Part, to: f64) -> Result<()> {
        let mut form = immerse(&part.parameter()?, &part.curve)?;
        if let Some(before) = self.forms.last() {
            let width = form.width();
            let end = &before.homogeneous()[before.homogeneous().len() - width..];
            let start = &form.homogeneous()[..width];
            let size = end.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            // The same point of the curve twice: only roundings differ.
            let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 64.0 * f64::EPSILON * size;
            if before.orders() == form.orders() && end.iter().zip(start).all(close) {
                let end = end.to_vec();
                form = form.with_pole(&[0], &end)?;
            }
        }
        self.forms.push(form);
        self.breaks.push(to);
        Ok(())
    }
}

/// A window of the curve, and what its parameter does there as a function of the length.
struct Part {
    /// The curve on the window.
    curve: Form,
    /// The length of the window.
    length: f64,
    /// Bernstein poles of the parameter, from 0 to 1.
    poles: [f64; 6],
}

impl Part {
    fn new(piece: &Form, local: [f64; 2], length: f64) -> Result<Self> {
        let curve = stretch(piece, &[local[0]], &[local[1]])?;
        let [start, end] = [0.0, 1.0].map(|t| slopes(&curve, t, length));
        let ([a, b], [c, d]) = (start?, end?);
        let poles =
            [0.0, a / 5.0, 0.4 * a + b / 20.0, 1.0 - 0.4 * c + d / 20.0, 1.0 - c / 5.0, 1.0];
        Ok(Self { curve, length, poles })
    }

    fn parameter(&self) -> Result<Form> {
        Form::from_points(&[6], 1, &self.poles, None)
    }

    /// How far the speed is from 1.
    fn error(&self) -> Result<f64> {
        let parameter = self.parameter()?;
        let mut worst = 0.0_f64;
        for place in 0..PLACES {
            let share = place as f64 / (PLACES - 1) as f64;
            let at = parameter.at(&[share])?[0];
            let slope = parameter.derivative_at(&[share], &[1])?[0];
            let speed = norm(&self.curve.derivative_at(&[at], &[1])?) * slope / self.length;
            worst = worst.max((speed - 1.0).abs());
        }
        // A parameter that ran backwards would come out as a negative speed, far from 1.
        Ok(if worst.is_nan() { f64::INFINITY } else { worst })
    }
}

/// First and second derivative of the parameter by the share of the length, at an end.
fn slopes(curve: &Form, t: f64, length: f64) -> Result<[f64; 2]> {
    let velocity = curve.derivative_at(&[t], &[1])?;
    let acceleration = curve.derivative_at(&[t], &[2])?;
    let speed = norm(&velocity);
    if speed == 0.0 {
        return Err(stands_still());
    }
    let along: f64 = velocity.iter().zip(&acceleration).map(|(v, a)| v / speed * (a / speed)).sum();
    let first = length / speed;
    Ok([first, -along * first * first])
}

/// The length of a vector of any size.
fn norm(vector: &[f64]) -> f64 {
    vector.iter().fold(0.0_f64, |sum, x| libm::hypot(sum, *x))
}

fn stands_still() -> Error {
    Error::degenerate(
        "curve",
        "a curve that stands still, where its derivative vanishes",
        "a curve that moves on everywhere",
    )
}
