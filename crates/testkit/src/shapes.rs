//! Known shapes.

use pforms_kernel::Form;

/// An eighth of the unit sphere, mirrored by the signs; its last row of poles is the pole of the sphere.
pub fn octant(signs: [f64; 3]) -> Form {
    let w = 0.5_f64.sqrt();
    let arc = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let mut points = Vec::new();
    for [r, z] in arc {
        for [x, y] in arc {
            points.extend([signs[0] * r * x, signs[1] * r * y, signs[2] * z]);
        }
    }
    let weights = [1.0, w, 1.0, w, w * w, w, 1.0, w, 1.0];
    Form::from_points(&[3, 3], 3, &points, Some(&weights)).unwrap()
}

/// The eight octants.
pub fn whole_sphere() -> Vec<Form> {
    let sign = |bit: usize| if bit == 0 { 1.0 } else { -1.0 };
    (0..8).map(|k| octant([sign(k & 1), sign(k & 2), sign(k & 4)])).collect()
}
