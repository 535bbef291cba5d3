//! Frames of curves: tangent, normals, curvature and torsion.

use pforms_kernel::{Error, Form, Result, Scalar};

use super::guarded::{Guarded, significant, values};
use super::local::{Local, Series, leading};
use super::rotation_minimising::rotation_minimising;
use super::vector::{cross, dot, norm, scaled, unit};

/// Which normals go with the tangent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FrameKind {
    /// The principal normal, towards the centre of curvature. It jumps to the other side at an
    /// inflection, and a straight line has none.
    #[default]
    Frenet,
    /// A normal that turns about the tangent as little as possible, carried from `u = 0`, where
    /// it is the principal normal (any normal, if the curve is a straight line).
    RotationMinimising,
    /// The tangent alone.
    Tangent,
}

/// The moving frame of a curve at one parameter; vectors of length 1.
///
/// In dimension 2 the normal is the tangent turned left, always, and the curvature is positive
/// where the curve turns left. In dimension 3 the binormal is `T × N`. In higher dimensions there
/// is no binormal and no torsion here.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveFrame {
    /// The parameter.
    pub parameter: f64,
    /// The euclidean point.
    pub point: Vec<f64>,
    /// The direction of the derivative; where the derivative vanishes, the direction it has next
    /// to this point, in the window.
    pub tangent: Vec<f64>,
    /// The normal of the chosen kind.
    pub normal: Option<Vec<f64>>,
    /// The binormal, in dimension 3.
    pub binormal: Option<Vec<f64>>,
    /// Length of the derivative `f′`: 0 at a degenerate pole.
    pub speed: f64,
    /// Length of the part of `f″` across the tangent: `curvature·speed²`.
    pub bend: f64,
    /// The curvature, its limit at a degenerate pole (there it may be infinite).
    pub curvature: f64,
    /// The torsion, in dimension 3: 0 for plane curves.
    pub torsion: Option<f64>,
}

impl CurveFrame {
    /// The frame of the same curve run through in windows `length` times as long: slower by that.
    pub(crate) fn slowed(self, length: f64) -> Self {
        Self { speed: self.speed / length, bend: self.bend / (length * length), ..self }
    }

    /// The same frame with its natural lengths: tangent `f′`, normal the part of `f″` across it
    /// (for the Frenet kind), binormal `f′ × f″`. A rotation-minimising normal has no length of
    /// its own and keeps 1.
    #[must_use]
    pub fn unnormalised(&self, kind: FrameKind) -> Self {
        let (bend, area) = match kind {
            FrameKind::Frenet => (self.bend, self.speed * self.bend),
            FrameKind::RotationMinimising | FrameKind::Tangent => (1.0, 1.0),
        };
        Self {
            tangent: scaled(&self.tangent, self.speed),
            normal: self.normal.as_ref().map(|normal| scaled(normal, bend)),
            binormal: self.binormal.as_ref().map(|binormal| scaled(binormal, area)),
            ..self.clone()
        }
    }
}

/// The Frenet frame at one parameter. Errors: as [`curve_frames`].
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::curve_frame;
/// let parabola: Form = Form::from_points(&[3], 2, &[0., 0., 1., 0., 2., 2.], None)?;
/// let frame = curve_frame(&parabola, 0.0)?;
/// assert_eq!((frame.tangent, frame.normal), (vec![1.0, 0.0], Some(vec![0.0, 1.0])));
/// assert_eq!(frame.curvature, 1.0);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn curve_frame(curve: &Form, parameter: f64) -> Result<CurveFrame> {
    require_curve(curve)?;
    Station::new(curve, parameter)?.frenet()
}

/// Frames of a curve at many parameters, in any order.
///
/// The tangent is the derivative of the euclidean curve, for weights of any sign. A derivative
/// counts as zero when rounding could have made it; then the next one decides, and vectors and
/// curvatures are limits from inside the window (from the right, at 1 and beyond from the left).
/// `accuracy` is for rotation-minimising frames: the largest angle, in radians, by which a normal
/// may be off; the other kinds ignore it and are right to some roundings times the condition.
///
/// Errors: `Shape` unless `curve` has one axis and lies in dimension 2 or more; `Degenerate` for a
/// single point, and for the Frenet frame of a straight line; `Domain` where the weight vanishes
/// or a parameter is not finite; `Accuracy` when that asked for was not reached.
pub fn curve_frames(
    curve: &Form,
    parameters: &[f64],
    kind: FrameKind,
    accuracy: f64,
) -> Result<Vec<CurveFrame>> {
    require_curve(curve)?;
    match kind {
        FrameKind::Frenet => parameters.iter().map(|t| Station::new(curve, *t)?.frenet()).collect(),
        FrameKind::Tangent => {
            parameters.iter().map(|t| Ok(Station::new(curve, *t)?.bare_frame())).collect()
        }
        FrameKind::RotationMinimising => rotation_minimising(curve, parameters, accuracy),
    }
}

/// Complains unless the form is a curve in at least a plane.
fn require_curve(form: &Form) -> Result<()> {
    if form.axes() == 1 && form.ambient() >= 2 {
        return Ok(());
    }
    Err(Error::shape(
        "form",
        format!("a {} in dimension {}", form.kind(), form.ambient()),
        "a curve in dimension 2 or more",
    ))
}

/// A curve near one of its points: `f = f₀ + c_k·hᵏ + … + c_j·hʲ + …`, the first direction and
/// the first that leaves it.
pub(crate) struct Station {
    parameter: f64,
    pub point: Vec<f64>,
    pub tangent: Vec<f64>,
    side: f64,
    series: Vec<Series>,
    first: usize,
    leaving: Option<Leaving>,
}

struct Leaving {
    power: usize,
    /// The part of `c_j` across the tangent.
    across: Vec<f64>,
}

impl Station {
    /// Expands as far as needed: three derivatives nearly always suffice.
    pub(crate) fn new(curve: &Form, parameter: f64) -> Result<Self> {
        let degree = curve.orders()[0] - 1;
        let short = Self::expanded(curve, parameter, 4)?;
        match short {
            Some(station) if station.is_regular() || degree < 2 => Ok(station),
            _ => Self::expanded(curve, parameter, 2 * degree + 2)?.ok_or_else(|| {
                Error::degenerate(
                    "form",
                    format!("a {} whose poles coincide", curve.kind()),
                    "a curve with a tangent",
                )
            }),
        }
    }

    fn is_regular(&self) -> bool {
        self.first == 1 && self.leaving.as_ref().is_some_and(|leaving| leaving.power == 2)
    }

    fn expanded(curve: &Form, parameter: f64, length: usize) -> Result<Option<Self>> {
        let local = Local::new(curve, &[parameter], length)?;
        let Some((first, direction)) = leading(local.point(), 1) else {
            return Ok(None);
        };
        let side = local.directions[0];
        let series = local.point().to_vec();
        let leaving = leaving(&series, first);
        Ok(Some(Self {
            parameter,
            point: local.at(),
            tangent: scaled(&unit(&direction), side),
            side,
            series,
            first,
            leaving,
        }))
    }

    /// Point, tangent and scalars, without normals.
    pub(crate) fn bare_frame(&self) -> CurveFrame {
        let speed = if self.first == 1 { norm(&self.coefficient(1)) } else { 0.0 };
        CurveFrame {
            parameter: self.parameter,
            point: self.point.clone(),
            tangent: self.tangent.clone(),
            normal: None,
            binormal: None,
            speed,
            bend: self.leaving.as_ref().map_or(0.0, Leaving::bend),
            curvature: self.curvature(),
            torsion: (self.point.len() == 3).then(|| self.torsion()),
        }
    }

    /// With the principal normal.
    pub(crate) fn frenet(&self) -> Result<CurveFrame> {
        match self.principal_normal() {
            Some(normal) => Ok(self.frame_with(normal)),
            None => Err(Error::degenerate(
                "form",
                "a straight line",
                "a curve that bends, or frames of kind rotation-minimising or tangent",
            )),
        }
    }

    /// With a given normal.
    pub(crate) fn frame_with(&self, normal: Vec<f64>) -> CurveFrame {
        let space = self.point.len() == 3;
        CurveFrame {
            binormal: space.then(|| cross(&self.tangent, &normal).to_vec()),
            normal: Some(normal),
            ..self.bare_frame()
        }
    }

    pub(crate) fn principal_normal(&self) -> Option<Vec<f64>> {
        if self.point.len() == 2 {
            return Some(vec![-self.tangent[1], self.tangent[0]]);
        }
        self.leaving.as_ref().map(|leaving| unit(&leaving.across))
    }

    fn coefficient(&self, power: usize) -> Vec<f64> {
        values(&self.guarded(power))
    }

    fn guarded(&self, power: usize) -> Vec<Guarded> {
        self.series.iter().map(|x| x[power]).collect()
    }

    /// The limit of `|f′ × f″| / |f′|³`, with a sign in the plane.
    fn curvature(&self) -> f64 {
        let Some(leaving) = &self.leaving else {
            return 0.0;
        };
        let (k, j) = (self.first as f64, leaving.power as f64);
        let length = norm(&self.coefficient(self.first));
        let size = match leaving.power.cmp(&(2 * self.first)) {
            std::cmp::Ordering::Less => f64::INFINITY,
            std::cmp::Ordering::Equal => {
                j * (j - k) / (k * k) * norm(&leaving.across) / (length * length)
            }
            std::cmp::Ordering::Greater => 0.0,
        };
        if self.point.len() == 2 {
            let left = dot(&leaving.across, &[-self.tangent[1], self.tangent[0]]);
            return size * left.signum();
        }
        size
    }

    /// The limit of `det(f′, f″, f‴) / |f′ × f″|²`: with `c_l` the first coefficient out of the
    /// plane of `c_k` and `c_j`, it is finite when `l = k + j`.
    fn torsion(&self) -> f64 {
        let Some(leaving) = &self.leaving else {
            return 0.0;
        };
        let (k, j) = (self.first, leaving.power);
        for l in j + 1..self.series[0].len().min(k + j + 1) {
            let volume = determinant(&self.guarded(k), &self.guarded(j), &self.guarded(l));
            let [a, b, c] = [k, j, l].map(|power| power as f64);
            let area = dot(&leaving.across, &leaving.across)
                * dot(&self.coefficient(k), &self.coefficient(k));
            let factor = c * (c - a) * (c - b) / (a * b * (b - a));
            if significant(&[volume]) {
                let value = factor * volume.value / area;
                return if l == k + j { value } else { value * self.side * f64::INFINITY };
            }
        }
        0.0
    }
}

impl Leaving {
    /// Length of the part of `f″` across the tangent.
    fn bend(&self) -> f64 {
        if self.power == 2 { 2.0 * norm(&self.across) } else { 0.0 }
    }
}

/// The first coefficient that is not along `c_k`, and its part across it.
fn leaving(series: &[Series], k: usize) -> Option<Leaving> {
    let along: Vec<Guarded> = series.iter().map(|x| x[k]).collect();
    let square = guarded_dot(&along, &along);
    let length = series[0].len();
    (k + 1..length).find_map(|power| {
        let coefficient: Vec<Guarded> = series.iter().map(|x| x[power]).collect();
        let share = guarded_dot(&coefficient, &along) / square;
        let across: Vec<Guarded> =
            coefficient.iter().zip(&along).map(|(x, t)| *x - *t * share).collect();
        significant(&across).then(|| Leaving { power, across: values(&across) })
    })
}

fn guarded_dot(a: &[Guarded], b: &[Guarded]) -> Guarded {
    a.iter().zip(b).fold(Guarded::zero(), |sum, (x, y)| sum + *x * *y)
}

fn determinant(a: &[Guarded], b: &[Guarded], c: &[Guarded]) -> Guarded {
    let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
    a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1)
}
