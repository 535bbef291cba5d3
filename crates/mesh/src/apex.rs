//! Unit normals along an edge that has collapsed to a point.

use pforms_kernel::{Form, Result, bernstein_row};
use pforms_operators::normals_into;

use crate::edge::Edge;
use crate::space::quadruples;
use crate::vector::{Vec3, cross, dot, scale};

/// Sine of the angle between direction and turn below which a limit is left to the careful way.
const CLEAR: f64 = 1e-4;

/// Which of the edges `u = 0`, `u = 1`, `v = 0`, `v = 1` are single points.
pub(crate) fn collapsed(form: &Form) -> [bool; 4] {
    [0, 1, 2, 3].map(|side| Edge::of(form, side / 2, side % 2 == 1).single_point().is_some())
}

/// Unit normals at parameters `ts` of a collapsed edge, on the way out from inside.
///
/// Seen from the apex, the form next to the edge runs in directions `q(t)`, the sum of the next
/// row of poles: its normal is the direction of `q × q′`.
///
/// Errors: those of [`normals_into`], for the points where that vanishes.
pub(crate) fn apex_normals(form: &Form, side: usize, ts: &[f64], out: &mut [Vec3]) -> Result<()> {
    let apex = Edge::of(form, side / 2, side % 2 == 1).single_point().unwrap_or_default();
    let row = next_row(form, side, apex);
    let degree = row.len() - 1;
    let slopes: Vec<Vec3> = row
        .windows(2)
        .map(|pair| [0, 1, 2].map(|k| degree as f64 * (pair[1][k] - pair[0][k])))
        .collect();
    let turn = if side == 0 || side == 3 { 1.0 } else { -1.0 };
    for (t, out) in ts.iter().zip(out) {
        let (q, dq) = (sum(&row, *t), sum(&slopes, *t));
        let normal = cross(q, dq);
        let size = dot(normal, normal);
        if size > CLEAR * CLEAR * dot(q, q) * dot(dq, dq) {
            *out = scale(turn / size.sqrt(), normal);
        } else {
            let at = [(side % 2) as f64, *t];
            let [u, v] = if side < 2 { at } else { [at[1], at[0]] };
            normals_into(form, &[&[u], &[v]], out)?;
        }
    }
    Ok(())
}

/// The poles next to an edge, seen from the point it has collapsed to.
fn next_row(form: &Form, side: usize, apex: Vec3) -> Vec<Vec3> {
    let (orders, poles) = (form.orders(), quadruples(form));
    let fixed = side / 2;
    let index =
        if side % 2 == 1 { orders[fixed].saturating_sub(2) } else { 1.min(orders[fixed] - 1) };
    let pole = |k: usize| {
        let [x, y, z, w] =
            if fixed == 0 { poles[index * orders[1] + k] } else { poles[k * orders[1] + index] };
        [x - apex[0] * w, y - apex[1] * w, z - apex[2] * w]
    };
    (0..orders[1 - fixed]).map(pole).collect()
}

/// The curve of these poles at `t`; 0 without any.
fn sum(poles: &[Vec3], t: f64) -> Vec3 {
    let mut sum = [0.0; 3];
    if poles.is_empty() {
        return sum;
    }
    for (factor, pole) in bernstein_row(poles.len() - 1, &t).iter().zip(poles) {
        for k in 0..3 {
            sum[k] += factor * pole[k];
        }
    }
    sum
}
