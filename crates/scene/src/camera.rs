//! Where a scene is seen from.
//!
//! The picture is the book's: x to the right, y up, z away from the viewer; or turned about x so
//! that z is up.

use pforms_kernel::{Error, Result};
use pforms_mesh::vector::{Vec3, add, dot, norm, scale, subtract, unit};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::Bounds;

/// Half the vertical angle of a perspective picture has this tangent: the book's 53.13 degrees.
pub const HALF_ANGLE_TANGENT: f64 = 0.5;

/// Room left round the drawn forms when the picture is fitted to them.
const MARGIN: f64 = 1.12;

/// A named direction to look from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum View {
    /// From far out on the axis x, without perspective.
    Ox,
    /// From above.
    Oy,
    /// From the front.
    Oz,
    /// Along the diagonal of the cube, from above right in front, without perspective.
    #[default]
    Axo,
    /// With perspective.
    Perspective,
}

/// The axis that stands upright in the picture: y in the book, z in many models.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Up {
    /// The axis y.
    #[default]
    Y,
    /// The axis z; the axis y then points towards the viewer.
    Z,
}

/// The table `[camera]` of a sheet. What is left open is fitted to what is drawn.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Camera {
    /// The direction, and whether there is perspective.
    pub view: View,
    /// The axis that stands upright.
    #[serde(skip_serializing_if = "is_usual")]
    pub up: Up,
    /// The eye.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position: Option<Vec3>,
    /// The point in the middle of the picture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<Vec3>,
    /// Without perspective the picture shows `1 / zoom` across; with it, a fitted picture is
    /// enlarged by `zoom`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub zoom: Option<f64>,
}

/// What the picture holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Parallel rays; the shorter side of the picture shows this length.
    Parallel {
        /// The length shown.
        across: f64,
    },
    /// Rays from the eye, [`HALF_ANGLE_TANGENT`] up and down.
    Perspective,
}

/// A camera with nothing left open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// The eye.
    pub position: Vec3,
    /// The point in the middle of the picture.
    pub target: Vec3,
    /// The direction that stands upright in the picture.
    pub up: Vec3,
    /// What the picture holds.
    pub projection: Projection,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "the form that serde calls")]
fn is_usual(up: &Up) -> bool {
    *up == Up::default()
}

impl Up {
    /// The direction itself.
    fn direction(self) -> Vec3 {
        self.turned([0.0, 1.0, 0.0])
    }

    /// A direction of the book's picture, in a picture with this axis upright.
    fn turned(self, [x, y, z]: Vec3) -> Vec3 {
        match self {
            Self::Y => [x, y, z],
            Self::Z => [x, 0.0 - z, y],
        }
    }
}

impl View {
    /// From the target to the eye. A view named after an axis looks along that axis.
    pub fn direction(self, up: Up) -> Vec3 {
        let front = [0.0, 0.0, -1.0];
        match (self, up) {
            (Self::Ox, _) => [1.0, 0.0, 0.0],
            (Self::Oy, Up::Y) | (Self::Oz, Up::Z) => up.direction(),
            (Self::Oz, Up::Y) | (Self::Oy, Up::Z) => up.turned(front),
            (Self::Axo, _) => up.turned([1.0, 1.0, -1.0]),
            (Self::Perspective, _) => up.turned([0.7, 1.3, -1.1]),
        }
    }
}

impl Camera {
    /// The camera of a sheet's table.
    ///
    /// Errors: `Format` for an unknown key or a value of the wrong kind; `Domain` for one out of
    /// its range.
    pub fn from_settings(settings: &Map<String, Value>) -> Result<Self> {
        let camera: Self = serde_json::from_value(Value::Object(settings.clone()))
            .map_err(|error| Error::format("camera", None, error))?;
        camera.check()?;
        Ok(camera)
    }

    fn check(&self) -> Result<()> {
        for (name, point) in [("position", self.position), ("target", self.target)] {
            if let Some(point) = point
                && !point.iter().all(|x| x.is_finite())
            {
                return Err(Error::domain(name, format!("{point:?}"), "finite numbers"));
            }
        }
        match self.zoom {
            Some(zoom) if !(zoom > 0.0 && zoom.is_finite()) => {
                Err(Error::domain("zoom", zoom, "a positive number"))
            }
            _ => Ok(()),
        }
    }

    /// The camera with what is left open fitted to `bounds`.
    pub fn placed(&self, bounds: &Bounds) -> Placement {
        let (centre, radius) = bounds.ball();
        let radius = radius * MARGIN;
        let target = self.target.unwrap_or(centre);
        let zoom = self.zoom.unwrap_or(1.0);
        let (distance, projection) = if self.view == View::Perspective {
            let sine = HALF_ANGLE_TANGENT / (1.0 + HALF_ANGLE_TANGENT.powi(2)).sqrt();
            (radius / (sine * zoom), Projection::Perspective)
        } else {
            let across = self.zoom.map_or(2.0 * radius, f64::recip);
            // Far enough out that nothing lies behind the eye.
            (4.0 * (radius + norm(subtract(target, centre))), Projection::Parallel { across })
        };
        let direction = unit(self.view.direction(self.up)).unwrap_or_default();
        let position = self.position.filter(|position| *position != target);
        let position = position.unwrap_or_else(|| add(target, scale(distance, direction)));
        let up = upright(self.up, subtract(target, position));
        Placement { position, target, up, projection }
    }
}

/// The upright axis, unless one looks along it: then the one that points away in the book's picture.
fn upright(up: Up, forward: Vec3) -> Vec3 {
    let along = dot(up.direction(), forward);
    let sideways = norm(subtract(forward, scale(along, up.direction())));
    if sideways > 1e-6 * norm(forward) { up.direction() } else { up.turned([0.0, 0.0, 1.0]) }
}
