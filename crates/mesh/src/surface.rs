//! Surfaces to triangles, without cracks between patches.

use pforms_kernel::{Form, Result};

use crate::adaptive::within;
use crate::uniform::uniform;
use crate::{Sampling, Triangles};

/// Samples a surface: exact points, exact unit normals `∂ᵤ × ∂ᵥ`.
///
/// Where the normal vanishes (at the pole of a sphere, along a collapsed edge) the limit from
/// inside the window stands in its place. Triangles without area are left out.
///
/// Errors: `Shape` unless the form has two axes; those of [`Sampling::segments`]; `Domain`, naming
/// the parameters, where the weight vanishes.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_mesh::{Sampling, surface};
/// let facet = Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 0.], None)?;
/// let mesh = surface(&facet, &Sampling::Fineness(vec![2]))?;
/// assert_eq!((mesh.positions.len(), mesh.indices.len()), (25, 32));
/// assert_eq!(mesh.normals[0], [0.0, 0.0, 1.0]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn surface(form: &Form, sampling: &Sampling) -> Result<Triangles> {
    Ok(surfaces(std::slice::from_ref(form), sampling)?.pop().unwrap_or_default())
}

/// Samples patches that fit together.
///
/// Patches with a common edge (the same homogeneous poles, in either direction) get the same
/// points on it, to the last bit, so a closed surface gives a watertight mesh.
///
/// Errors: those of [`surface`].
pub fn surfaces(forms: &[Form], sampling: &Sampling) -> Result<Vec<Triangles>> {
    meshes(forms, sampling, true)
}

/// Samples patches as [`surfaces`] does, but leaves their lists of normals empty.
///
/// Errors: those of [`surface`].
pub fn facets(forms: &[Form], sampling: &Sampling) -> Result<Vec<Triangles>> {
    meshes(forms, sampling, false)
}

fn meshes(forms: &[Form], sampling: &Sampling, normals: bool) -> Result<Vec<Triangles>> {
    match sampling {
        Sampling::Tolerance(tolerance) => within(forms, *tolerance, normals),
        even => uniform(forms, even, normals),
    }
}
