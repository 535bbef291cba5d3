//! Rational forms of given angles and lengths, and polynomial forms that come near them.

mod angles;
mod arc;
mod bicubic;
mod deviation;
mod hyperbola;
mod revolve;
mod torus_knot;

pub use arc::arc;
pub use bicubic::{Bicubic, bezier_cone, bezier_cylinder, bezier_sphere, bezier_torus};
pub use hyperbola::hyperbola;
pub use revolve::revolve;
pub use torus_knot::torus_knot;
