//! Questions about a form, answered with a stated accuracy.

pub(crate) mod about_one;
mod arc_length;
pub(crate) mod bending;
mod bounding_box;
mod classify;
mod continuity;
mod curvature;
mod curve_frame;
mod developable;
mod embed;
mod feet;
mod folds;
pub(crate) mod guarded;
mod integral;
mod intersect;
mod invert;
mod local;
mod mass;
mod measure;
mod normal_form;
mod normals;
mod patches;
mod project;
mod random;
mod ratios;
pub(crate) mod roots;
mod rotation_minimising;
mod scale;
mod shell;
mod spline_forms;
mod spline_frames;
mod surface_frame;
pub(crate) mod system;
mod tangent_form;
pub(crate) mod twofold;
pub(crate) mod vector;
mod volume;
mod volume_frame;

pub use arc_length::ArcLength;
pub(crate) use arc_length::Speed;
pub use bounding_box::{BoundingBox, bounding_box};
pub use classify::{Conic, classify};
pub use continuity::{Continuity, ContinuityOptions, FormEnd, continuity, joints};
pub use curvature::{Curvature, curvature};
pub use curve_frame::{CurveFrame, FrameKind, curve_frame, curve_frames};
pub use developable::{Developability, gauss_form, is_developable};
pub use embed::{Embedder, Embedding, Outside, Standing, embed};
pub use feet::{Feet, Foot, FootKind, project_all};
pub use folds::{Folding, Folds, folds};
pub use intersect::{
    Branch, Contact, ContactKind, Crossings, Intersections, Overlap, Undecided, intersect,
    intersect_inside, intersect_many,
};
pub use invert::{Doubt, Inversion, Inverter, Preimage, invert};
pub use mass::{Mass, Moments, mass};
pub use measure::{Measure, area, measure, signed_area};
pub use normal_form::{binormal_form, normal_form};
pub use normals::{normal_grid_into, normals_into};
pub use project::{Projection, Projector, SplineProjector, project};
pub use random::{Spread, random_points};
pub use ratios::{GOLDEN_RATIO, Ratios, ratios};
pub(crate) use scale::{in_units, unit};
pub use surface_frame::{SurfaceCurvature, SurfaceFrame, surface_frame};
pub use tangent_form::tangent_form;
pub use volume::{volume, volume_exact};
pub use volume_frame::{VolumeFrame, volume_frame};
