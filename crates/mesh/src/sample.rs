//! Points and unit normals of a surface in space.

use pforms_kernel::{Error, Form, Result};
use pforms_operators::{normal_grid_into, normals_into};

use crate::normal::Surface;
use crate::vector::Vec3;

/// Points and unit normals, one after the other.
pub(crate) struct Sample {
    pub(crate) positions: Vec<Vec3>,
    /// None if they were not asked for.
    pub(crate) normals: Vec<Vec3>,
}

/// Samples on the grid `us × vs`, in C order.
pub(crate) fn sample(form: &Form, us: &[f64], vs: &[f64], normals: bool) -> Result<Sample> {
    let parameters = [us, vs];
    let mut positions = vec![[0.0; 3]; us.len() * vs.len()];
    form.grid_into(&parameters, positions.as_flattened_mut())?;
    if !normals {
        return Ok(Sample { positions, normals: Vec::new() });
    }
    let mut normals = vec![[0.0; 3]; positions.len()];
    match normal_grid_into(form, &parameters, normals.as_flattened_mut()) {
        Err(Error::Degenerate(_)) => {
            let at: Vec<[f64; 2]> = us.iter().flat_map(|u| vs.iter().map(|v| [*u, *v])).collect();
            normals = Surface::new(form)?.normals(&at)?;
        }
        done => done?,
    }
    Ok(Sample { positions, normals })
}

/// Unit normals at scattered parameters.
pub(crate) fn normals_at(form: &Form, parameters: &[[f64; 2]]) -> Result<Vec<Vec3>> {
    let [us, vs]: [Vec<f64>; 2] =
        [0, 1].map(|axis: usize| parameters.iter().map(|at| at[axis]).collect());
    let mut normals = vec![[0.0; 3]; parameters.len()];
    match normals_into(form, &[&us, &vs], normals.as_flattened_mut()) {
        // A surface that is a line or a point somewhere still gets directions, any across it.
        Err(Error::Degenerate(_)) => Surface::new(form)?.normals(parameters),
        done => done.map(|()| normals),
    }
}
