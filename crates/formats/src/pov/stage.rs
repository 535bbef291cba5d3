//! Camera, lights, background and axes.

use std::fmt::Write;

use pforms_mesh::vector::{Vec3, add, norm, scale, subtract};
use pforms_scene::{Camera, Placement, Projection, Scene};

use super::vector;

/// Radius of the ball round the book's usual scene, a cube of side 1: the measure of its lights.
const USUAL_RADIUS: f64 = 0.87;

/// What the book's usual picture shows across at its target: the measure of its axes.
const USUAL_WIDTH: f64 = 1.84;

/// The book's three lights, for its usual scene.
const LIGHTS: [Vec3; 3] = [[2.0, 2.0, -2.0], [-2.0, 2.0, -2.0], [2.0, 0.0, 2.0]];

const AXES: [(Vec3, &str); 3] = [
    ([1.0, 0.0, 0.0], "rgb <0.8, 0, 0>"),
    ([0.0, 1.0, 0.0], "rgb <0, 0.6, 0>"),
    ([0.0, 0.0, 1.0], "rgb <0, 0, 0.8>"),
];

/// Writes everything but the drawn values. Writing to a string cannot fail.
pub(super) fn write(text: &mut String, scene: &Scene) {
    let (centre, radius) = scene.bounds().ball();
    let placement = scene.placement();
    text.push_str("global_settings { assumed_gamma 1.0 max_trace_level 64 }\n");
    text.push_str("background { color srgb 3/4 }\n");
    camera(text, &placement);
    for light in LIGHTS {
        let place = vector(add(centre, scale(radius / USUAL_RADIUS, light)));
        let _ = writeln!(text, "light_source {{ {place} color rgb 0.75 shadowless }}");
    }
    if scene.axes {
        let width = match placement.projection {
            Projection::Parallel { across } => across,
            Projection::Perspective => norm(subtract(placement.position, placement.target)),
        };
        axes(text, &scene.camera, width / USUAL_WIDTH);
    }
}

fn camera(text: &mut String, placement: &Placement) {
    let Placement { position, target, up, projection } = placement;
    text.push_str("#declare Aspect = image_width / image_height;\n");
    let (kind, across) = match projection {
        Projection::Parallel { across } => ("orthographic", *across),
        // `direction z` is one long: half of the picture's side over it is the tangent ½.
        Projection::Perspective => ("perspective", 1.0),
    };
    let _ = writeln!(
        text,
        "camera {{\n  {kind}\n  location {}\n  direction z\n  \
         right x*{across:?}*max(1, Aspect)\n  up y*{across:?}*max(1, 1/Aspect)\n  \
         sky {}\n  look_at {}\n}}",
        vector(*position),
        vector(*up),
        vector(*target),
    );
}

/// Thin cylinders, but for the axis one looks along.
fn axes(text: &mut String, camera: &Camera, size: f64) {
    for (direction, color) in AXES {
        if camera.view.direction(camera.up).map(f64::abs) == direction {
            continue;
        }
        let [from, to] = [-10.0 * size, 10.0 * size].map(|reach| vector(scale(reach, direction)));
        let _ = writeln!(
            text,
            "cylinder {{ {from}, {to}, {:?} pigment {{ color {color} }} \
             finish {{ ambient 0.6 diffuse 0.4 }} }}",
            0.005 * size,
        );
    }
}
