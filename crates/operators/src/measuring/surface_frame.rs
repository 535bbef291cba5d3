//! Frames and curvatures of surfaces.

use pforms_kernel::{Error, Form, Result};

use super::guarded::{Guarded, significant, values};
use super::local::{Local, Series, leading, minus, product};
use super::vector::{cross, dot, norm, plus, scaled, unit};

/// The frame of a surface at one point, its two fundamental forms and its curvatures.
///
/// Axis 0 is `u`, axis 1 is `v`. The normal, in dimension 3 only, has the direction of
/// `f_u × f_v`; the curvatures are positive where the surface bends towards it.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceFrame {
    /// The euclidean point.
    pub point: Vec<f64>,
    /// Unit tangents along `u` and `v`; where a derivative vanishes, the direction it has next to
    /// this point, in the window.
    pub tangents: [Vec<f64>; 2],
    /// Lengths of `f_u` and `f_v`: 0 on a collapsed edge.
    pub lengths: [f64; 2],
    /// The unit normal, in dimension 3; where `f_u × f_v` vanishes, its limit.
    pub normal: Option<Vec<f64>>,
    /// Length of `f_u × f_v`: the stretch of area (in any dimension).
    pub area: f64,
    /// First fundamental form: `E = f_u·f_u`, `F = f_u·f_v`, `G = f_v·f_v`.
    pub first: [f64; 3],
    /// Second fundamental form, in dimension 3: `L = n·f_uu`, `M = n·f_uv`, `N = n·f_vv`.
    pub second: Option<[f64; 3]>,
    /// Curvatures, in dimension 3.
    pub curvature: Option<SurfaceCurvature>,
}

/// How a surface bends at one point.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceCurvature {
    /// Gauss curvature, the product of the principal ones.
    pub gauss: f64,
    /// Mean curvature, half their sum.
    pub mean: f64,
    /// Principal curvatures, the larger first.
    pub principal: [f64; 2],
    /// Unit tangent vectors in which the surface bends so; `None` where `f_u × f_v` vanishes.
    pub directions: Option<[Vec<f64>; 2]>,
}

impl SurfaceFrame {
    /// The frame of the same surface over windows longer by these factors.
    pub(crate) fn slowed(self, [u, v]: [f64; 2]) -> Self {
        let per = |[a, b, c]: [f64; 3]| [a / (u * u), b / (u * v), c / (v * v)];
        Self {
            lengths: [self.lengths[0] / u, self.lengths[1] / v],
            area: self.area / (u * v),
            first: per(self.first),
            second: self.second.map(per),
            ..self
        }
    }

    /// The same frame with its natural lengths: `f_u`, `f_v` and `f_u × f_v`.
    #[must_use]
    pub fn unnormalised(&self) -> Self {
        let [u, v] = &self.tangents;
        Self {
            tangents: [scaled(u, self.lengths[0]), scaled(v, self.lengths[1])],
            normal: self.normal.as_ref().map(|normal| scaled(normal, self.area)),
            ..self.clone()
        }
    }
}

/// The frame of a surface at `(u, v)`, by exact derivatives.
///
/// A derivative counts as zero when rounding could have made it. Then tangents, normal and
/// curvatures are limits from inside the window, along its diagonal: at the pole of a sphere they
/// are those of the sphere. Curvatures lose some roundings times the condition of the point.
///
/// Errors: `Shape` unless the form has two axes and lies in dimension 2 or more; `Degenerate`
/// where no limit exists, as for a surface collapsed to a curve; `Domain` where the weight
/// vanishes or a parameter is not finite.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::surface_frame;
/// let saddle: Form =
///     Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 1.], None)?;
/// let frame = surface_frame(&saddle, 0.0, 0.0)?; // z = x·y
/// assert_eq!(frame.normal, Some(vec![0.0, 0.0, 1.0]));
/// assert_eq!(frame.curvature.map(|bend| (bend.gauss, bend.principal)), Some((-1.0, [1.0, -1.0])));
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn surface_frame(surface: &Form, u: f64, v: f64) -> Result<SurfaceFrame> {
    if surface.axes() != 2 || surface.ambient() < 2 {
        return Err(Error::shape(
            "form",
            format!("a {} in dimension {}", surface.kind(), surface.ambient()),
            "a surface in dimension 2 or more",
        ));
    }
    let local = Local::new(surface, &[u, v], 1)?;
    let (along_u, along_v) = (start(&local.first(0)), start(&local.first(1)));
    let first = [dot(&along_u, &along_u), dot(&along_u, &along_v), dot(&along_v, &along_v)];
    let tangent = |axis: usize| -> Result<Vec<f64>> { limit_tangent(surface, &[u, v], axis) };
    let mut frame = SurfaceFrame {
        point: local.at(),
        tangents: [tangent(0)?, tangent(1)?],
        lengths: [norm(&along_u), norm(&along_v)],
        normal: None,
        area: norm(&plus(&along_v, -first[1] / nonzero(first[0]), &along_u)) * norm(&along_u),
        first,
        second: None,
        curvature: None,
    };
    if surface.ambient() == 3 {
        bend(&mut frame, surface, &local, &[u, v])?;
    }
    Ok(frame)
}

/// Adds what only exists in space: normal, second fundamental form, curvatures.
fn bend(frame: &mut SurfaceFrame, surface: &Form, local: &Local, at: &[f64]) -> Result<()> {
    let raw = cross_series(&local.first(0), &local.first(1));
    let normal = if significant(&raw.each_ref().map(|series| series[0])) {
        unit(&start(&raw))
    } else {
        limit_normal(surface, at)?
    };
    let [uu, uv, vv] = [(0, 0), (0, 1), (1, 1)].map(|(k, l)| start(&local.second(k, l)));
    let second = [dot(&normal, &uu), dot(&normal, &uv), dot(&normal, &vv)];
    frame.area = norm(&start(&raw));
    frame.curvature = Some(if significant(&raw.each_ref().map(|series| series[0])) {
        principal(frame, &normal, &second)
    } else {
        limit_curvature(surface, at)?
    });
    frame.second = Some(second);
    frame.normal = Some(normal);
    Ok(())
}

/// The second fundamental form in an orthonormal basis of the tangent plane, diagonalised.
fn principal(frame: &SurfaceFrame, normal: &[f64], second: &[f64; 3]) -> SurfaceCurvature {
    let [_, f, _] = frame.first;
    let length = frame.lengths[0];
    let across = frame.area / length;
    let (e1, e2) = (&frame.tangents[0], cross(normal, &frame.tangents[0]));
    // f_u = length·e1, f_v = lean·e1 + across·e2.
    let lean = f / length;
    let [l, m, n] = *second;
    let a = l / (length * length);
    let b = (m / length - lean * a) / across;
    let c = (n - 2.0 * lean * m / length + lean * lean * a) / (across * across);
    let (mean, half) = (f64::midpoint(a, c), (a - c) / 2.0);
    let radius = (half * half + b * b).sqrt();
    // The eigenvector of the larger curvature, without cancellation.
    let (x, y) = if half >= 0.0 { (half + radius, b) } else { (b, radius - half) };
    let size = (x * x + y * y).sqrt();
    let (x, y) = if size > 0.0 { (x / size, y / size) } else { (1.0, 0.0) };
    let combined = |x: f64, y: f64| plus(&scaled(e1, x), y, &e2);
    SurfaceCurvature {
        gauss: a * c - b * b,
        mean,
        principal: [mean + radius, mean - radius],
        directions: Some([combined(x, y), combined(-y, x)]),
    }
}

/// The unit tangent along `axis`, or its limit.
pub(crate) fn limit_tangent(form: &Form, at: &[f64], axis: usize) -> Result<Vec<f64>> {
    expansions(form, |length| {
        let series = Local::new(form, at, length)?.first(axis);
        Ok(leading(&series, 0).map(|(_, tangent)| unit(&tangent)))
    })?
    .ok_or_else(|| undefined(&format!("tangent along axis {axis}"), form))
}

/// The unit normal of a surface in space, or its limit.
pub(crate) fn limit_normal(surface: &Form, at: &[f64]) -> Result<Vec<f64>> {
    expansions(surface, |length| {
        let local = Local::new(surface, at, length)?;
        let normal = cross_series(&local.first(0), &local.first(1));
        Ok(leading(&normal, 0).map(|(_, normal)| unit(&normal)))
    })?
    .ok_or_else(|| undefined("normal", surface))
}

/// Gauss `(LN − M²)/|n|⁴` and mean curvature `(E·N − 2F·M + G·L)/2|n|³`, with `n = f_u × f_v` and
/// `L = n·f_uu` …, as quotients of first coefficients.
fn limit_curvature(surface: &Form, at: &[f64]) -> Result<SurfaceCurvature> {
    let order = expansions(surface, |length| {
        let local = Local::new(surface, at, length)?;
        Ok(leading(&cross_series(&local.first(0), &local.first(1)), 0).map(|(power, _)| power))
    })?
    .ok_or_else(|| undefined("normal", surface))?;
    let local = Local::new(surface, at, 4 * order + 1)?;
    let (u, v) = (local.first(0), local.first(1));
    let n = cross_series(&u, &v);
    let along = |k, l| dot_series(&n, &local.second(k, l));
    let (uu, uv, vv) = (along(0, 0), along(0, 1), along(1, 1));
    let gauss = minus(&product(&uu, &vv), &product(&uv, &uv));
    let (e, f, g) = (dot_series(&u, &u), dot_series(&u, &v), dot_series(&v, &v));
    let twice = product(&f, &uv);
    let sum: Series = minus(&minus(&product(&e, &vv), &twice), &minus(&twice, &product(&g, &uu)));
    let size = norm(&n.each_ref().map(|series| series[order].value));
    let gauss = limit_of(&gauss, 4 * order, size.powi(4));
    let mean = limit_of(&sum, 3 * order, 2.0 * size.powi(3));
    let radius = (mean * mean - gauss).max(0.0).sqrt();
    Ok(SurfaceCurvature {
        gauss,
        mean,
        principal: [mean + radius, mean - radius],
        directions: None,
    })
}

/// The limit of `series / (divisor·h^power)`.
fn limit_of(series: &Series, power: usize, divisor: f64) -> f64 {
    match leading(std::slice::from_ref(series), 0) {
        Some((first, value)) if first < power => value[0].signum() * f64::INFINITY,
        _ => series[power].value / divisor,
    }
}

/// Tries longer and longer expansions, until one answers or the form has no more to tell.
fn expansions<T>(form: &Form, attempt: impl Fn(usize) -> Result<Option<T>>) -> Result<Option<T>> {
    let longest = 3 * form.degrees().iter().sum::<usize>() + 1;
    let mut length = 1;
    loop {
        let answer = attempt(length)?;
        if answer.is_some() || length > longest {
            return Ok(answer);
        }
        length *= 3;
    }
}

fn undefined(what: &str, form: &Form) -> Error {
    Error::degenerate(
        "form",
        format!("a {} without a {what} here: it collapses", form.kind()),
        "a form whose derivatives do not all vanish or align",
    )
}

/// The vector at `h = 0`.
fn start(vector: &[Series]) -> Vec<f64> {
    let first: Vec<Guarded> = vector.iter().map(|series| series[0]).collect();
    values(&first)
}

fn nonzero(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x }
}

fn cross_series(a: &[Series], b: &[Series]) -> [Series; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| minus(&product(&a[i], &b[j]), &product(&a[j], &b[i])))
}

fn dot_series(a: &[Series], b: &[Series]) -> Series {
    let mut terms = a.iter().zip(b).map(|(x, y)| product(x, y));
    let first = terms.next().unwrap_or_default();
    terms.fold(first, |sum, term| sum.iter().zip(&term).map(|(x, y)| *x + *y).collect())
}
