//! Rational forms: conics, circles, and the surfaces they sweep. Exact.

mod arc;
mod axis;
mod conic;
mod cross;
mod cubic_arc;
mod part;
mod quadrics;
mod revolve;
mod torus;
mod viviani;

pub use arc::{arc_by_step, circle};
pub(crate) use arc::{arc_through, require_positive};
pub use axis::Axis;
pub use conic::{conic, ellipse, hyperbola_by, parabola};
pub use cross::cross;
pub(crate) use cubic_arc::quarter_cubic;
pub use part::Part;
pub use quadrics::{cone, cylinder, sphere};
pub use revolve::{revolve_along, revolve_whole};
pub(crate) use torus::shifted;
pub use torus::torus;
pub use viviani::viviani;
