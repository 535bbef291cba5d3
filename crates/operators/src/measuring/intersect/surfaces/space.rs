//! Vectors of space, on the stack.

pub(super) type V3 = [f64; 3];

pub(super) fn dot(a: &V3, b: &V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: &V3, b: &V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn norm(a: &V3) -> f64 {
    dot(a, a).sqrt()
}

pub(super) fn minus(a: &V3, b: &V3) -> V3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a + factor·b`, of any dimension.
pub(super) fn plus<const N: usize>(a: &[f64; N], factor: f64, b: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|k| a[k] + factor * b[k])
}

pub(super) fn times<const N: usize>(a: &[f64; N], factor: f64) -> [f64; N] {
    a.map(|x| x * factor)
}

/// The unit vector along `a`, unless `a` vanishes.
pub(super) fn unit(a: &V3) -> Option<V3> {
    let length = norm(a);
    (length > 0.0 && length.is_finite()).then(|| times(a, 1.0 / length))
}

/// `(x, y, z)` with `x·a + y·b + z·c = d`, by Cramer's rule.
pub(super) fn solve(a: &V3, b: &V3, c: &V3, d: &V3) -> Option<V3> {
    let bc = cross(b, c);
    let determinant = dot(a, &bc);
    let solution = [
        dot(d, &bc) / determinant,
        dot(a, &cross(d, c)) / determinant,
        dot(a, &cross(b, d)) / determinant,
    ];
    solution.iter().all(|x| x.is_finite()).then_some(solution)
}

/// The largest difference of two places, coordinate by coordinate.
pub(super) fn apart<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).fold(0.0, |most, (x, y)| most.max((x - y).abs()))
}
