//! A curve run through at unit speed (course, "paramétrisation normale").

use pforms_kernel::{Error, Form, Result};

use crate::algebra::{Shape, Spline, immerse, stretch};
use crate::measuring::{ArcLength, Speed, in_units, unit};

/// A curve by its own length.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitSpeed {
    /// The same curve over the window from 0 to its length.
    pub spline: Spline,
    /// The length of the curve.
    pub length: f64,
    /// How far its speed is from 1, at most, as measured at 33 places of every piece, and a tenth of
    /// that for what lies between them.
    pub error: f64,
}

/// Pieces one curve may be cut into.
const MOST: usize = 1 << 14;

/// Places of a piece where its speed is measured.
const PLACES: usize = 33;

/// What the speed may do between those places, beside what it does at them.
const BETWEEN: f64 = 1.1;

/// A curve is said to stand still where its speed is this little of what it is elsewhere.
const STILL: f64 = 1e-8;

/// The curve as a function of its length, within `accuracy` of unit speed.
///
/// No curve but a straight line can have unit speed exactly and be rational (Farouki and Sakkalis
/// 1991), so the parameter is made a spline of the length: polynomials of degree 5 with the right value
/// and two right derivatives at their ends, immersed in the curve. Every point therefore stays on the
/// curve, exactly; only the speed is approximated, and at the joints of the pieces it is right. The
/// degree becomes 5 times that of the curve; four times the pieces make the error 1024 times less.
/// Roundings of poles and knots come on top, some units in the last place of them, divided by the
/// length of a piece: near a place that is almost a cusp pieces are short, and roundings are felt.
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
    let pieces = curve.pieces()?;
    let unit = unit(&pieces);
    let mut cut =
        Cut { measured: &measured, unit, forms: Vec::new(), breaks: vec![0.0], error: 0.0 };
    for (piece, window) in pieces.iter().zip(breaks.windows(2)) {
        cut.piece(piece, [window[0], window[1]], accuracy)?;
    }
    cut.end_at(measured.length());
    let spline = Spline::end_to_end(&cut.forms, 0, &cut.breaks)?;
    Ok(UnitSpeed { spline, length: measured.length(), error: cut.error })
}

/// The accuracy of lengths: beyond what rounding allows they need not go.
fn measured_to(accuracy: f64) -> f64 {
    if accuracy > 0.0 { accuracy.max(1e-14) } else { accuracy }
}

struct Cut<'a> {
    measured: &'a ArcLength,
    /// In which speeds are measured, so that their squares are numbers.
    unit: f64,
    forms: Vec<Form>,
    /// Lengths at which the forms begin and end.
    breaks: Vec<f64>,
    error: f64,
}

impl Cut<'_> {
    /// Cuts one piece of the curve, whose parameter runs over `window`, until each part is even enough.
    fn piece(&mut self, piece: &Form, window: [f64; 2], accuracy: f64) -> Result<()> {
        let [from, to] = window;
        let scaled = in_units(piece, self.unit)?;
        let speed = Speed::of(&scaled, 0.0, 1.0)?;
        let lengths = [self.measured.up_to(from)?, self.measured.up_to(to)?];
        let mut waiting = vec![(lengths, [0.0, 1.0])];
        while let Some((lengths, local)) = waiting.pop() {
            let part = Part::new(&scaled, &speed, local)?;
            let error = part.error()?;
            if error <= accuracy {
                self.push(piece, &part)?;
                self.error = self.error.max(error);
                continue;
            }
            // Where exactly it is cut does not matter: every part measures itself.
            let half = 0.5 * (lengths[0] + lengths[1]);
            let parameter = (self.measured.parameter(half)? - from) / (to - from);
            let apart = local[0] < parameter && parameter < local[1];
            if !apart || self.forms.len() + waiting.len() > MOST {
                if part.is_still()? {
                    return Err(stands_still());
                }
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
    fn push(&mut self, piece: &Form, part: &Part) -> Result<()> {
        let [from, to] = part.local;
        let mut form = immerse(&part.parameter()?, &stretch(piece, &[from], &[to])?)?;
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
        self.breaks.push(self.breaks[self.breaks.len() - 1] + part.length * self.unit);
        Ok(())
    }

    /// Takes up what the sum of the parts differs from the length of the whole, all alike.
    fn end_at(&mut self, length: f64) {
        let last = self.breaks.len() - 1;
        let factor = length / self.breaks[last];
        self.breaks.iter_mut().for_each(|at| *at *= factor);
        self.breaks[last] = length;
    }
}

/// A window of a piece of the curve, and what its parameter does there as a function of the length.
///
/// Speeds and lengths are taken from the whole piece: the poles of a small window differ by little more
/// than their roundings.
struct Part<'a> {
    speed: &'a Speed,
    /// The window in the parameter of the piece.
    local: [f64; 2],
    /// The length of the window.
    length: f64,
    /// Bernstein poles of the parameter of the window, from 0 to 1.
    poles: [f64; 6],
}

impl<'a> Part<'a> {
    fn new(piece: &'a Form, speed: &'a Speed, local: [f64; 2]) -> Result<Self> {
        let length = speed.integral(local[0], local[1])?;
        let share = length / (local[1] - local[0]);
        let [start, end] = local.map(|t| slopes(piece, t, local[1] - local[0], share));
        let ([a, b], [c, d]) = (start?, end?);
        let poles =
            [0.0, a / 5.0, 0.4 * a + b / 20.0, 1.0 - 0.4 * c + d / 20.0, 1.0 - c / 5.0, 1.0];
        Ok(Self { speed, local, length, poles })
    }

    fn parameter(&self) -> Result<Form> {
        Form::from_points(&[6], 1, &self.poles, None)
    }

    /// How far the speed is from 1.
    fn error(&self) -> Result<f64> {
        let parameter = self.parameter()?;
        let [from, to] = self.local;
        let mut worst = 0.0_f64;
        for place in 0..PLACES {
            let share = place as f64 / (PLACES - 1) as f64;
            let at = from + parameter.at(&[share])?[0] * (to - from);
            let slope = parameter.derivative_at(&[share], &[1])?[0] * (to - from);
            let speed = self.speed.at(at)? * slope / self.length;
            worst = worst.max((speed - 1.0).abs());
        }
        // A parameter that ran backwards would come out as a negative speed, far from 1.
        Ok(if worst.is_nan() { f64::INFINITY } else { BETWEEN * worst })
    }

    /// Is its speed next to nothing, seen from the mean speed of its piece?
    fn is_still(&self) -> Result<bool> {
        let mean = self.speed.integral(0.0, 1.0)?;
        Ok(self.length <= STILL * mean * (self.local[1] - self.local[0]))
    }
}

/// First and second derivative of the parameter of a window by the share of its length, at an end
/// `t`; `mean` is the mean speed of the window.
fn slopes(piece: &Form, t: f64, width: f64, mean: f64) -> Result<[f64; 2]> {
    let velocity = piece.derivative_at(&[t], &[1])?;
    let acceleration = piece.derivative_at(&[t], &[2])?;
    let speed = norm(&velocity);
    if speed == 0.0 {
        return Err(stands_still());
    }
    let along: f64 = velocity.iter().zip(&acceleration).map(|(v, a)| v / speed * (a / speed)).sum();
    let first = mean / speed;
    Ok([first, -along * width * first * first])
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
