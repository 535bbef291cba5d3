//! Unit normals of a surface at many points, without an allocation per point.
//!
//! With `Q` the coordinates seen from the nearest corner pole and `W` the weight, the normal is
//! the direction of `(Q_u·W − Q·W_u) × (Q_v·W − Q·W_v)`. A collapsed edge has `Q = 0`, so digits
//! survive next to it; on it, and wherever the product says little, the limit is taken.

mod direction;
mod grid;
mod net;
mod scattered;

use pforms_kernel::threads::fill_parts;
use pforms_kernel::vectors::in_lanes;
use pforms_kernel::{Error, Form, Result};

use grid::Grid;
use net::Nets;
use scattered::Scattered;

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
    surface.require_per_axis("parameters", parameters)?;
    let (us, vs) = (parameters[0], parameters[1]);
    if us.len() != vs.len() {
        let received = format!("lists of {} and {}", us.len(), vs.len());
        return Err(Error::shape("parameters", received, "lists of one length"));
    }
    require_lists(parameters, out, us.len())?;
    let nets = Nets::new(surface)?;
    fill_parts(out, 3, nets.cost(), |range, out| {
        in_lanes(Scattered { nets: &nets, us: &us[range.clone()], vs: &vs[range], out })
    })
}

/// Unit normals on a grid of parameters, one list for each axis: `out` has shape
/// `(len₀, len₁, 3)`. The net is contracted once for each `u`. Otherwise as [`normals_into`].
pub fn normal_grid_into(surface: &Form, parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
    require_surface(surface)?;
    surface.require_per_axis("parameters", parameters)?;
    let (us, vs) = (parameters[0], parameters[1]);
    require_lists(parameters, out, us.len() * vs.len())?;
    let nets = Nets::new(surface)?;
    fill_parts(out, 3 * vs.len(), nets.cost() * vs.len(), |range, out| {
        in_lanes(Grid { nets: &nets, us: &us[range], vs, out })
    })
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

fn require_lists(parameters: &[&[f64]], out: &[f64], count: usize) -> Result<()> {
    if out.len() != 3 * count {
        return Err(Error::shape("out", format!("{} numbers", out.len()), 3 * count));
    }
    match parameters.iter().flat_map(|list| list.iter()).find(|t| !t.is_finite()) {
        None => Ok(()),
        Some(t) => Err(Error::domain("parameters", t, "finite numbers")),
    }
}
