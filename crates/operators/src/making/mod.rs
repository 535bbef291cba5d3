//! Make forms from data: through given points, or near them.

mod coons;
mod fit;
mod fit_parameters;
mod immerse_spline;
mod interpolate;
mod known_nodes;
mod least_squares;
mod nodes;
mod offset_poles;
mod parallel;
mod rational;
mod tangent_developable;
mod unroll;

mod twofold;
mod vandermonde;

pub use coons::{CoonsOptions, coons, coons_splines};
pub use fit::{Fit, FitOptions, fit};
pub use fit_parameters::Parameters;
pub use immerse_spline::immerse_spline;
pub use interpolate::{interpolate, interpolate_homogeneous};
pub use nodes::Nodes;
pub use offset_poles::offset_poles;
pub use parallel::{Distance, Parallel, ParallelOptions, Side, parallel, shell};
pub use rational::{
    Bicubic, arc, bezier_cone, bezier_cylinder, bezier_sphere, bezier_torus, hyperbola, revolve,
    torus_knot,
};
pub use tangent_developable::{tangent_developable, tangent_developable_of_spline};
pub use unroll::{Distortion, Unrolling, unroll};
