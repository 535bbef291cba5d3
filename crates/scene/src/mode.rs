//! The ways to draw a form.

use pforms_kernel::Form;
use pforms_mesh::Mesh;
use serde::{Deserialize, Serialize};

/// A way to draw a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Mode {
    /// Samples of any form, or vertices of a mesh, as spheres.
    Points,
    /// A curve as a round tube.
    Curve,
    /// A surface or a mesh as triangles.
    Surface,
    /// The six faces of a volume.
    Envelope,
    /// A stack of leaves of a volume.
    Sheets,
    /// A bundle of curves of a volume or of a surface.
    Fibres,
    /// The poles as spheres, joined along every axis; the edges of a mesh.
    Net,
    /// The poles as spheres.
    Poles,
    /// The normals of a surface at its samples.
    Normals,
}

impl Mode {
    /// The ways that suit a form, the most usual one first.
    pub fn suiting(form: &Form) -> &'static [Self] {
        use Mode::{Curve, Envelope, Fibres, Net, Normals, Points, Poles, Sheets, Surface};
        match form.axes() {
            0 => &[Points],
            1 => &[Curve, Points, Net, Poles],
            2 => &[Surface, Points, Fibres, Net, Poles, Normals],
            3 => &[Envelope, Sheets, Fibres, Points, Net, Poles],
            _ => &[Points, Net, Poles],
        }
    }

    /// The ways that suit a mesh, the most usual one first.
    pub fn suiting_mesh(mesh: &Mesh) -> &'static [Self] {
        if mesh.is_cloud() && mesh.vertex_count() > 0 {
            &[Self::Points]
        } else {
            &[Self::Surface, Self::Net, Self::Points]
        }
    }
}
