//! Three numbers as a point or a direction of space.

/// A point or a direction.
pub type Vec3 = [f64; 3];

/// `a + b`.
pub fn add(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// `a − b`.
pub fn subtract(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `factor · a`.
pub fn scale(factor: f64, a: Vec3) -> Vec3 {
    [factor * a[0], factor * a[1], factor * a[2]]
}

/// The scalar product.
pub fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector product.
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The length; no overflow and no underflow on the way.
pub fn norm(a: Vec3) -> f64 {
    let largest = a.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if largest == 0.0 {
        return 0.0;
    }
    let scaled = scale(1.0 / largest, a);
    largest * dot(scaled, scaled).sqrt()
}

/// The direction of length 1, unless `a` is 0.
pub fn unit(a: Vec3) -> Option<Vec3> {
    let largest = a.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if largest < f64::MIN_POSITIVE {
        return None;
    }
    let scaled = a.map(|x| x / largest);
    Some(scale(1.0 / dot(scaled, scaled).sqrt(), scaled))
}

/// A direction of length 1 at right angles to `a`, which has length 1 too.
pub fn perpendicular(a: Vec3) -> Vec3 {
    let [x, y, z] = a.map(f64::abs);
    let helper = if x <= y && x <= z {
        [1.0, 0.0, 0.0]
    } else if y <= z {
        [0.0, 1.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    };
    unit(cross(a, helper)).unwrap_or([0.0, 0.0, 1.0])
}
