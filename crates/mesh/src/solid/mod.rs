//! Solids: closed shells as watertight meshes, and what they have together or apart.

mod boolean;
mod bound;
mod faces;
mod near;
mod shell;
mod skin;
mod zip;

use pforms_kernel::{Error, Result};
use pforms_operators::{Poles, Shape};

use crate::{Mesh, envelope, patches};

pub use boolean::Operation;
use shell::Shell;

/// What a solid is given as, or a part of it.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    /// A closed surface, a patch of one, or a volume.
    Shape(Shape),
    /// A closed mesh.
    Mesh(Mesh),
}

/// A solid as a mesh, and how far that may be from what it stands for.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Closed, its triangles counter-clockwise seen from outside.
    pub mesh: Mesh,
    /// No point of a surface that was given is farther from its mesh than this.
    pub distance: f64,
    /// The true volume differs from that of the mesh by no more than this.
    pub volume_error: f64,
}

/// The solid inside a closed shell.
///
/// Surfaces are taken together as patches of shells and glued where they meet within the accuracy;
/// a volume and a mesh are a shell each, and the solid is all that lies inside any of the shells.
/// Which way round patches are given does not matter.
///
/// `accuracy` is relative to the size of each shell, the diagonal of the box round its poles: no
/// point of a surface is farther from the mesh.
///
/// Errors: `Shape` for a shell that is open, telling where, or has one side only, and for what is no
/// shell (a curve, a cloud, something in another dimension); `Degenerate` for one without a volume;
/// `Domain` for an accuracy that is not between 0 and 1/10; those of [`crate::surfaces`].
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_mesh::{Part, solid};
/// let corners = (0..8).flat_map(|k| [f64::from(k >> 2), f64::from(k >> 1 & 1), f64::from(k & 1)]);
/// let cube = Form::from_points(&[2, 2, 2], 3, &corners.collect::<Vec<_>>(), None)?;
/// let solid = solid(&[Part::Shape(cube.into())], 1e-3)?;
/// assert_eq!(solid.mesh.volume()?, 1.0);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn solid(body: &[Part], accuracy: f64) -> Result<Solid> {
    combine(Operation::Union, &[body.to_vec()], accuracy)
}

/// What solids have together: all of them, the first without the others, or what is in each.
///
/// Each is given as for [`solid`]. Faces that lie in one plane, solids that touch, are inside each
/// other or the same, and shells that cross themselves are no exceptions. The result may be
/// empty. Its volume differs from the true one by no more than what is swept over when every surface
/// becomes its mesh, added up where that decides about the result: per triangle, how high the surface
/// is over it at most, times the area.
///
/// Errors: as [`solid`]; `Shape` for no solid at all.
pub fn combine(operation: Operation, bodies: &[Vec<Part>], accuracy: f64) -> Result<Solid> {
    if !(accuracy > 0.0 && accuracy <= 0.1) {
        return Err(Error::domain("accuracy", accuracy, "a number above 0, at most 0.1"));
    }
    if bodies.is_empty() {
        return Err(Error::shape("solids", "none", "one at least"));
    }
    let mut shells = Vec::with_capacity(bodies.len());
    for (number, body) in bodies.iter().enumerate() {
        let name = if bodies.len() == 1 { "solid".into() } else { format!("solid {}", number + 1) };
        shells.push(shells_of(body, accuracy, &name)?);
    }
    let (mesh, merged) = boolean::combined(operation, &shells)?;
    let distance = shells.iter().flatten().map(|shell| shell.distance).fold(merged, f64::max);
    let volume_error = bound::changed(operation, &shells)? + 2.0 * merged * mesh.area();
    Ok(Solid { mesh, distance, volume_error })
}

/// The shells of a solid: all its surfaces together, each of its volumes and meshes.
fn shells_of(body: &[Part], accuracy: f64, name: &str) -> Result<Vec<Shell>> {
    let mut surfaces = Vec::new();
    let mut shells = Vec::new();
    for part in body {
        match part {
            Part::Mesh(mesh) => shells.extend(shell::of_mesh(mesh, name)?),
            Part::Shape(shape) => {
                let net = shape.net();
                if net.ambient() != 3 || !(2..=3).contains(&net.axes()) {
                    let received = format!("a {} in dimension {}", net.kind(), net.ambient());
                    return Err(Error::shape(
                        name,
                        received,
                        "surfaces, volumes or meshes in space",
                    ));
                }
                match (net.axes(), shape) {
                    (2, _) => surfaces.extend(shape.pieces()?),
                    (_, Shape::Form(form)) => {
                        shells.push(shell::of_volume(&envelope(form)?, accuracy, name)?);
                    }
                    (_, Shape::Spline(spline)) => {
                        shells.push(shell::of_volume(&patches(spline)?, accuracy, name)?);
                    }
                }
            }
        }
    }
    if !surfaces.is_empty() {
        shells.push(shell::of_patches(&surfaces, accuracy, name)?);
    }
    if body.is_empty() {
        return Err(Error::shape(name, "nothing", "surfaces, volumes or meshes in space"));
    }
    Ok(shells)
}
