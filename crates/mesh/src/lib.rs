//! Forms to points, lines and triangles, within an accuracy. Knows no colour.
//!
//! ```
//! use pforms_kernel::Form;
//! use pforms_mesh::{Sampling, surface};
//!
//! // An eighth of the unit sphere: three arcs, the last shrunk to the pole.
//! let w = 0.5_f64.sqrt();
//! let points = [1., 0., 0., 1., 0., 1., 0., 0., 1.]
//!     .iter().chain(&[1., 1., 0., 1., 1., 1., 0., 1., 1.])
//!     .chain(&[0., 1., 0., 0., 1., 0., 0., 1., 0.]).copied().collect::<Vec<f64>>();
//! let octant = Form::from_points(&[3, 3], 3, &points, Some(&[1., w, 1., w, 0.5, w, 1., w, 1.]))?;
//! let mesh = surface(&octant, &Sampling::Tolerance(1e-3))?;
//! for (point, normal) in mesh.positions.iter().zip(&mesh.normals) {
//!     let radius = point.iter().map(|x| x * x).sum::<f64>().sqrt();
//!     assert!((radius - 1.0).abs() < 1e-14);
//!     let along: f64 = point.iter().zip(normal).map(|(x, n)| x * n).sum();
//!     assert!((along.abs() - 1.0).abs() < 1e-12);
//! }
//! # Ok::<(), pforms_kernel::Error>(())
//! ```

mod adaptive;
mod apex;
mod cloud;
mod crease;
mod curve;
mod deviation;
mod edge;
mod edges;
mod mesh;
mod moments;
mod net;
mod normal;
mod pieces;
mod room;
mod sample;
mod sampling;
mod series;
mod solid;
mod space;
mod sphere;
mod spline;
mod surface;
mod triangles;
mod tube;
mod uniform;
pub mod vector;
mod volume;
mod weld;

pub use cloud::points;
pub use curve::{Curve, Polyline, curve};
pub use mesh::Mesh;
pub use moments::{mesh_area, mesh_box, mesh_mass, mesh_volume};
pub use net::{net, normals};
pub use room::require_room;
pub use sampling::Sampling;
pub use solid::{Operation, Part, Solid, combine, solid};
pub use space::{embed, poles};
pub use sphere::{push_spheres, sphere};
pub use spline::{chain, patches};
pub use surface::{facets, surface, surfaces};
pub use triangles::Triangles;
pub use tube::tube;
pub use volume::{envelope, fibres, leaves};
