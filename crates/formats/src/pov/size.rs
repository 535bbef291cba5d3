//! Brings very small and very large scenes to a size at which POV-Ray computes well.
//!
//! Its own tolerances are fixed lengths, made for scenes of about unit size.

use pforms_kernel::{Form, Result};
use pforms_mesh::vector::{Vec3, norm, scale};
use pforms_scene::{Part, Scene};

/// Scenes whose farthest point lies between these distances stay as they are.
const COMFORTABLE: std::ops::RangeInclusive<f64> = 0.05..=5000.0;

/// The power of two that the coordinates are to be multiplied by; 1 for a scene of usual size.
pub(super) fn factor(scene: &Scene) -> f64 {
    let bounds = scene.bounds();
    let reach = if bounds.is_empty() { 1.0 } else { norm(bounds.low).max(norm(bounds.high)) };
    if COMFORTABLE.contains(&reach) || reach == 0.0 {
        return 1.0;
    }
    libm::exp2(-libm::floor(libm::log2(reach)))
}

/// The scene with all lengths multiplied.
///
/// Errors: `Domain` when a number grows beyond bounds.
pub(super) fn scaled(scene: &Scene, factor: f64) -> Result<Scene> {
    let mut scene = scene.clone();
    let camera = &mut scene.camera;
    camera.position = camera.position.map(|point| scale(factor, point));
    camera.target = camera.target.map(|point| scale(factor, point));
    if camera.view != pforms_scene::View::Perspective {
        camera.zoom = camera.zoom.map(|zoom| zoom / factor);
    }
    for item in &mut scene.items {
        for form in &mut item.forms {
            *form = scaled_form(form, factor)?;
        }
        item.style.tolerance = item.style.tolerance.map(|tolerance| tolerance * factor);
        for part in &mut item.parts {
            scale_part(part, factor);
        }
    }
    Ok(scene)
}

fn scaled_form(form: &Form, factor: f64) -> Result<Form> {
    let mut poles = form.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(form.width()) {
        for x in &mut pole[..form.ambient()] {
            *x *= factor;
        }
    }
    Form::from_homogeneous(form.orders(), form.ambient(), poles)
}

fn scale_part(part: &mut Part, factor: f64) {
    match part {
        Part::Points { positions, radius } => {
            scale_all(positions, factor);
            *radius *= factor;
        }
        Part::Lines { polylines, radius } => {
            for line in polylines {
                scale_all(&mut line.points, factor);
            }
            *radius *= factor;
        }
        Part::Triangles(mesh) => scale_all(&mut mesh.positions, factor),
    }
}

fn scale_all(points: &mut [Vec3], factor: f64) {
    for point in points {
        *point = scale(factor, *point);
    }
}
