//! A form around one point: its expansion along a line into the window.
//!
//! Where a derivative vanishes (coincident poles, a collapsed edge), the direction that the
//! derivative has close by, on the way into the window, is the first coefficient of this
//! expansion that is not zero.

use pforms_kernel::{Error, Form, Matrix, Result, Scalar, taylor_rows};

use super::guarded::{Guarded, significant, values};

/// Coefficients of `h⁰, h¹, …`.
pub(crate) type Series = Vec<Guarded>;

/// The homogeneous Taylor coefficients of a form at a point, seen from a nearby corner pole.
pub(crate) struct Local {
    taylor: Form<Guarded>,
    /// `+1` or `−1` for each axis: where the window lies. The line is `parameters + h·directions`.
    pub directions: Vec<f64>,
    length: usize,
    centre: Vec<f64>,
    /// The point and the weight along the line.
    point: Vec<Series>,
    weight: Series,
}

impl Local {
    /// Expands far enough for `length` coefficients of second derivatives.
    ///
    /// Errors: `Shape` unless there is a parameter for each axis; `Domain` when one is not finite or
    /// the weight vanishes there.
    pub(crate) fn new(form: &Form, parameters: &[f64], length: usize) -> Result<Self> {
        form.require_per_axis("parameters", parameters)?;
        if let Some(t) = parameters.iter().find(|t| !t.is_finite()) {
            return Err(Error::domain("parameters", t, "finite numbers"));
        }
        let corner: Vec<bool> = parameters.iter().map(|t| *t > 0.5).collect();
        let (mut taylor, centre) = recentred(form, &corner)?;
        for (axis, t) in parameters.iter().enumerate() {
            let degree = form.orders()[axis] - 1;
            let rows = rows_near(degree, degree.min(length + 1), *t);
            taylor = taylor.along(axis, &rows)?;
        }
        let directions = parameters.iter().map(|t| if *t < 1.0 { 1.0 } else { -1.0 }).collect();
        let mut local =
            Self { taylor, directions, length, centre, point: Vec::new(), weight: Vec::new() };
        let mut point = local.homogeneous(&[]);
        local.weight = point.pop().unwrap_or_default();
        if !significant(&local.weight[..1]) {
            return Err(Error::domain(
                "parameters",
                "a point where the weight vanishes",
                "parameters where the form is finite",
            ));
        }
        local.point = point.iter().map(|x| quotient(x, &local.weight)).collect();
        Ok(local)
    }

    /// The euclidean point.
    pub(crate) fn at(&self) -> Vec<f64> {
        let pairs = self.centre.iter().zip(&self.point);
        pairs.map(|(centre, x)| centre + x[0].value).collect()
    }

    /// The euclidean point along the line, seen from the corner.
    pub(crate) fn point(&self) -> &[Series] {
        &self.point
    }

    /// `∂f/∂u_axis` along the line: `(X_k − f·W_k) / W`.
    pub(crate) fn first(&self, axis: usize) -> Vec<Series> {
        let mut upper = self.homogeneous(&[axis]);
        let slope = upper.pop().unwrap_or_default();
        let pairs = upper.iter().zip(&self.point);
        pairs.map(|(x, f)| quotient(&minus(x, &product(f, &slope)), &self.weight)).collect()
    }

    /// `∂²f/∂u_k∂u_l` along the line: `(X_kl − f_k·W_l − f_l·W_k − f·W_kl) / W`.
    pub(crate) fn second(&self, k: usize, l: usize) -> Vec<Series> {
        let mut upper = self.homogeneous(&[k, l]);
        let bend = upper.pop().unwrap_or_default();
        let slope = |axis| self.homogeneous(&[axis]).pop().unwrap_or_default();
        let (slope_k, slope_l) = (slope(k), slope(l));
        let (first_k, first_l) = (self.first(k), self.first(l));
        (0..upper.len())
            .map(|x| {
                let rest = minus(&upper[x], &product(&first_k[x], &slope_l));
                let rest = minus(&rest, &product(&first_l[x], &slope_k));
                quotient(&minus(&rest, &product(&self.point[x], &bend)), &self.weight)
            })
            .collect()
    }

    /// Homogeneous coordinates, differentiated along the named axes, on the line.
    fn homogeneous(&self, along: &[usize]) -> Vec<Series> {
        let width = self.taylor.width();
        let mut series = vec![vec![Guarded::zero(); self.length]; width];
        let mut index = vec![0; self.taylor.axes()];
        for coefficients in self.taylor.homogeneous().chunks_exact(width) {
            let total: usize = index.iter().sum();
            if let Some(power) = total.checked_sub(along.len())
                && power < self.length
            {
                let factor = Guarded::from(self.factor(&index, along));
                for (sum, x) in series.iter_mut().zip(coefficients) {
                    sum[power] += factor * *x;
                }
            }
            advance(&mut index, self.taylor.orders());
        }
        series
    }

    /// The derivative of `Π (directions·h)^index` along the axes, at `h = 1`.
    fn factor(&self, index: &[usize], along: &[usize]) -> f64 {
        let mut rest = index.to_vec();
        let mut factor = 1.0;
        for &axis in along {
            factor *= rest[axis] as f64;
            rest[axis] = rest[axis].saturating_sub(1);
        }
        let signs = rest.iter().zip(&self.directions);
        signs.fold(
            factor,
            |factor, (power, sign)| if power % 2 == 1 { factor * sign } else { factor },
        )
    }
}

/// Taylor rows at `t`, from the end of the window that is nearer: `1 − t` is exact beyond ½, so
/// the distance to either end counts as known to the last digit.
fn rows_near(degree: usize, last: usize, t: f64) -> Matrix<Guarded> {
    if t <= 0.5 {
        return taylor_rows(degree, last, &Guarded::from(t));
    }
    let mirrored = taylor_rows(degree, last, &Guarded::from(1.0 - t));
    Matrix::from_rule(last + 1, degree + 1, |r, j| {
        let entry = mirrored.row(r)[degree - j];
        if r % 2 == 1 { -entry } else { entry }
    })
}

/// The next index in C order.
fn advance(index: &mut [usize], orders: &[usize]) {
    for (i, order) in index.iter_mut().zip(orders).rev() {
        *i = (*i + 1) % order;
        if *i > 0 {
            return;
        }
    }
}

/// The first coefficient of a vector series that is more than rounding, and its power of `h`.
pub(crate) fn leading(vector: &[Series], from: usize) -> Option<(usize, Vec<f64>)> {
    let length = vector.first().map_or(0, Vec::len);
    (from..length).find_map(|power| {
        let coefficient: Vec<Guarded> = vector.iter().map(|series| series[power]).collect();
        significant(&coefficient).then(|| (power, values(&coefficient)))
    })
}

pub(crate) fn product(a: &[Guarded], b: &[Guarded]) -> Series {
    let mut sum = vec![Guarded::zero(); a.len().min(b.len())];
    for i in 0..sum.len() {
        for j in 0..sum.len() - i {
            sum[i + j] += a[i] * b[j];
        }
    }
    sum
}

pub(crate) fn minus(a: &[Guarded], b: &[Guarded]) -> Series {
    a.iter().zip(b).map(|(x, y)| *x - *y).collect()
}

/// The quotient; the divisor does not vanish at `h = 0`.
fn quotient(a: &[Guarded], b: &[Guarded]) -> Series {
    let mut result: Series = Vec::with_capacity(a.len());
    for k in 0..a.len() {
        let known = result.iter().enumerate();
        let rest = known.fold(a[k], |rest, (j, q)| rest - *q * b[k - j]);
        result.push(rest / b[0]);
    }
    result
}

/// The form seen from one of its corner poles, and that pole (the origin if it is at infinity).
///
/// Coordinates within a few roundings of the corner's become exactly 0, so a collapsed edge
/// stays collapsed and directions close to it keep all their digits.
fn recentred(form: &Form, corner: &[bool]) -> Result<(Form<Guarded>, Vec<f64>)> {
    let (ambient, width) = (form.ambient(), form.width());
    let centre = corner_point(form, corner);
    let mut poles = Vec::with_capacity(form.homogeneous().len());
    for pole in form.homogeneous().chunks_exact(width) {
        let weight = pole[ambient];
        poles.extend(pole[..ambient].iter().zip(&centre).map(|(x, c)| seen_from(*x, c * weight)));
        poles.push(Guarded::from(weight));
    }
    Ok((Form::from_homogeneous(form.orders(), ambient, poles)?, centre))
}

/// The euclidean corner pole on the given side of each axis; the origin if it is at infinity.
pub(crate) fn corner_point(form: &Form, corner: &[bool]) -> Vec<f64> {
    let sides = corner.iter().zip(form.orders());
    let flat = sides.fold(0, |flat, (far, order)| flat * order + if *far { order - 1 } else { 0 });
    let pole = &form.homogeneous()[flat * form.width()..][..form.width()];
    let weight = pole[form.ambient()];
    let point = pole[..form.ambient()].iter();
    point.map(|x| if weight == 0.0 { 0.0 } else { x / weight }).collect()
}

/// `x − origin`, exactly 0 when it is within the roundings of the two.
pub(crate) fn seen_from(x: f64, origin: f64) -> Guarded {
    let size = x.abs() + origin.abs();
    if (x - origin).abs() <= 2.0 * f64::EPSILON * size {
        return Guarded::zero();
    }
    Guarded { value: x - origin, size }
}
