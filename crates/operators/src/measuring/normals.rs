//! Unit normals of a surface at many points, without an allocation per point.
//!
//! With `Q` the coordinates seen from the nearest corner pole and `W` the weight, the normal is
//! the direction of `(Q_u·W − Q·W_u) × (Q_v·W − Q·W_v)`. A collapsed edge has `Q = 0`, so digits
//! survive next to it; on it, and wherever the product says little, the limit is taken.

use pforms_kernel::{Error, Form, Result};

use super::local::{corner_point, seen_from};
use super::surface_frame::limit_normal;
use super::vector::{cross, dot};

/// Sine of the angle between the tangents, and share of the largest possible derivative, below
/// which a point goes to the careful way. They trade speed only: both ways are right there.
const CLEAR: f64 = 1e-4;

/// Unit normals `f_u × f_v / |f_u × f_v|` at scattered parameters: `parameters[k][i]` is parameter
/// `k` of point `i`; three numbers of `out` for each.
///
/// Where the product vanishes (collapsed edges, coincident poles) the normal is its limit from
/// inside the window.
///
/// Errors: `Shape` unless it is a surface in dimension 3 and lengths fit; `Degenerate` where there
/// is no limit; `Domain` where the weight vanishes or a parameter is not finite.
pub fn normals_into(surface: &Form, parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
    require_surface(surface)?;
    let mut nets = Nets::new(surface);
    let mut rows = [Rows::default(), Rows::default()];
    surface.each_scattered(parameters, out, 3, |surface, at, part| {
        for (rows, (t, order)) in rows.iter_mut().zip(at.iter().zip(surface.orders())) {
            rows.fill(order - 1, *t);
        }
        let line = nets.line(surface, [at[0] > 0.5, at[1] > 0.5], &rows[0]);
        if normal_on(line, &rows[1], part) { Ok(()) } else { careful(surface, at, part) }
    })
}

/// Unit normals on a grid of parameters, one list for each axis: `out` has shape
/// `(len₀, len₁, 3)`. The net is contracted once for each `u`. Otherwise as [`normals_into`].
pub fn normal_grid_into(surface: &Form, parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
    require_surface(surface)?;
    surface.require_per_axis("parameters", parameters)?;
    let (us, vs) = (parameters[0], parameters[1]);
    if out.len() != us.len() * vs.len() * 3 {
        let expected = us.len() * vs.len() * 3;
        return Err(Error::shape("out", format!("{} numbers", out.len()), expected));
    }
    if let Some(t) = us.iter().chain(vs).find(|t| !t.is_finite()) {
        return Err(Error::domain("parameters", t, "finite numbers"));
    }
    let mut nets = Nets::new(surface);
    let columns: Vec<Rows> = vs.iter().map(|v| Rows::new(surface.orders()[1] - 1, *v)).collect();
    for (u, line_out) in us.iter().zip(out.chunks_exact_mut((3 * vs.len()).max(1))) {
        let rows = Rows::new(surface.orders()[0] - 1, *u);
        for far in [false, true] {
            let line = nets.line(surface, [*u > 0.5, far], &rows);
            for ((v, column), part) in vs.iter().zip(&columns).zip(line_out.chunks_exact_mut(3)) {
                if (*v > 0.5) == far && !normal_on(line, column, part) {
                    careful(surface, &[*u, *v], part)?;
                }
            }
        }
    }
    Ok(())
}

fn require_surface(form: &Form) -> Result<()> {
    if form.axes() == 2 && form.ambient() == 3 {
        return Ok(());
    }
    Err(Error::shape(
        "form",
        format!("a {} in dimension {}", form.kind(), form.ambient()),
        "a surface in dimension 3",
    ))
}

fn careful(surface: &Form, at: &[f64], part: &mut [f64]) -> Result<()> {
    part.copy_from_slice(&limit_normal(surface, at)?);
    Ok(())
}

/// Values and slopes of the Bernstein polynomials at one parameter.
#[derive(Default)]
struct Rows {
    value: Vec<f64>,
    slope: Vec<f64>,
}

impl Rows {
    fn new(degree: usize, t: f64) -> Self {
        let mut rows = Self::default();
        rows.fill(degree, t);
        rows
    }

    /// By the triangle of de Casteljau, kept one step before its end for the slopes.
    fn fill(&mut self, degree: usize, t: f64) {
        self.value.clear();
        self.value.push(1.0);
        self.slope.clear();
        self.slope.resize(degree + 1, 0.0);
        for step in 1..=degree {
            if step == degree {
                self.take_slopes();
            }
            let mut left = 0.0;
            for entry in &mut self.value {
                (left, *entry) = (t * *entry, (1.0 - t) * *entry + left);
            }
            self.value.push(left);
        }
    }

    /// `B_j′ = n·(B_{j−1} − B_j)`, from the row of degree `n − 1`.
    fn take_slopes(&mut self) {
        let degree = self.value.len() as f64;
        for (j, entry) in self.value.iter().enumerate() {
            self.slope[j] -= degree * entry;
            self.slope[j + 1] += degree * entry;
        }
    }
}

/// The poles of the surface seen from each corner, made when first needed, and a line of them.
struct Nets {
    seen: [Option<Vec<f64>>; 4],
    line: Vec<[f64; 8]>,
}

impl Nets {
    fn new(surface: &Form) -> Self {
        Self { seen: [const { None }; 4], line: vec![[0.0; 8]; surface.orders()[1]] }
    }

    /// The net contracted along `u`: `(Q, W)` and its derivative for each pole along `v`.
    fn line(&mut self, surface: &Form, corner: [bool; 2], rows: &Rows) -> &[[f64; 8]] {
        let place = usize::from(corner[0]) + 2 * usize::from(corner[1]);
        let poles = self.seen[place].get_or_insert_with(|| seen_from_corner(surface, corner));
        self.line.fill([0.0; 8]);
        let width = 4 * self.line.len();
        for ((value, slope), row) in
            rows.value.iter().zip(&rows.slope).zip(poles.chunks_exact(width))
        {
            for (sum, pole) in self.line.iter_mut().zip(row.chunks_exact(4)) {
                for k in 0..4 {
                    sum[k] += value * pole[k];
                    sum[4 + k] += slope * pole[k];
                }
            }
        }
        &self.line
    }
}

fn seen_from_corner(surface: &Form, corner: [bool; 2]) -> Vec<f64> {
    let centre = corner_point(surface, &corner);
    let poles = surface.homogeneous().chunks_exact(4);
    poles
        .flat_map(|pole| {
            let seen = |k: usize| seen_from(pole[k], centre[k] * pole[3]).value;
            [seen(0), seen(1), seen(2), pole[3]]
        })
        .collect()
}

/// Writes the normal from a line of poles; false when the tangents are too short or too aligned
/// to trust it.
fn normal_on(line: &[[f64; 8]], rows: &Rows, out: &mut [f64]) -> bool {
    let mut sums = [[0.0; 4]; 3];
    let mut reach = 0.0_f64;
    for ((value, slope), pole) in rows.value.iter().zip(&rows.slope).zip(line) {
        for k in 0..4 {
            sums[0][k] += value * pole[k];
            sums[1][k] += value * pole[4 + k];
            sums[2][k] += slope * pole[k];
            reach = reach.max(pole[k].abs());
        }
    }
    let [point, along_u, along_v] = sums;
    let weight = point[3];
    let tangent = |d: [f64; 4]| [0, 1, 2].map(|k| d[k] * weight - point[k] * d[3]);
    let (a, b) = (tangent(along_u), tangent(along_v));
    let normal = cross(&a, &b);
    let (aa, bb, nn) = (dot(&a, &a), dot(&b, &b), dot(&normal, &normal));
    let short = (CLEAR * weight * reach).powi(2);
    let clear = aa > short && bb > short && nn > CLEAR * CLEAR * aa * bb;
    if clear {
        let size = nn.sqrt();
        out.iter_mut().zip(normal).for_each(|(x, n)| *x = n / size);
    }
    clear
}
