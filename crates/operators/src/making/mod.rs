//! Make forms from data: through given points, or near them.

mod bspline;
mod by_arc_length;
mod coons;
mod deform;
mod fit;
mod fit_parameters;
mod geodesic;
mod golden;
mod gordon;
mod immerse_spline;
mod interpolate;
mod interpolating_spline;
mod join_forms;
mod known_nodes;
mod least_squares;
mod minimal;
mod nodes;
mod offset_poles;
mod parallel;
mod pipe;
mod rational;
mod remove_knots;
mod tangent_developable;
mod tile_shapes;
mod unroll;

mod vandermonde;

pub use bspline::{KnotRule, bspline, nurbs};
pub use by_arc_length::{UnitSpeed, by_arc_length};
pub use coons::{CoonsOptions, coons, coons_splines};
pub use deform::{Rest, deform};
pub use fit::{Fit, FitOptions, fit};
pub use fit_parameters::Parameters;
pub use geodesic::{
    Arrivals, Connection, Ending, Geodesic, GeodesicOptions, Heading, Mark, Minimality, Plank,
    PlankOptions, geodesic, geodesic_between, geodesics, plank_lines, planks, shortest_geodesic,
};
pub use golden::golden;
pub use gordon::{Network, gordon, gordon_network};
pub use immerse_spline::immerse_spline;
pub use interpolate::{interpolate, interpolate_homogeneous};
pub use interpolating_spline::{
    SplineEnds, cubic_chain, interpolating_spline, quadratic_chain, spline_parameters,
};
pub use join_forms::{Joined, Smoothness, join_forms};
pub use minimal::{Functional, Minimal, MinimalOptions, extremal, minimal};
pub use nodes::Nodes;
pub use offset_poles::offset_poles;
pub use parallel::{Distance, Parallel, ParallelOptions, Side, parallel, shell};
pub use pipe::{Law, Pipe, PipeOptions, pipe};
pub use rational::{
    Bicubic, arc, bezier_cone, bezier_cylinder, bezier_sphere, bezier_torus, hyperbola, revolve,
    torus_knot,
};
pub use remove_knots::{Simplified, remove_knots};
pub use tangent_developable::{tangent_developable, tangent_developable_of_spline};
pub use tile_shapes::tile_shapes;
pub use unroll::{Distortion, Unrolling, unroll};
