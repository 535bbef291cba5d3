//! Values, styles and a camera to plain buffers. Knows no window, no graphics card and no file.
//!
//! Coordinates are those of the sheet. A picture shows them as the book does: x to the right, y
//! up, z away from the viewer.

mod bounds;
mod camera;
mod color;
mod draw;
mod mode;
mod part;
mod scene;
mod shapes;
mod style;

pub use bounds::Bounds;
pub use camera::{Camera, HALF_ANGLE_TANGENT, Placement, Projection, Up, View};
pub use color::Color;
pub use draw::draw;
pub use mode::Mode;
pub use part::{Buffers, Part};
pub use scene::{Item, Scene};
pub use shapes::Shapes;
pub use style::{Levels, Shading, Style};
