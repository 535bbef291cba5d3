//! The unit circle at a polynomial angle, near enough a polynomial itself.

use super::poly::Poly;

/// Polynomials near the cosine and the sine of an angle on `[0, 1]`, and a bound on the distance of
/// the two points of the plane.
///
/// `z = exp(iθ)` turns: `z′ = iθ′z`. So what the residual `p′ − iθ′p` of the polynomial of degree 5
/// through its ends leaves over adds up to its distance, and no more.
pub(super) fn circle(angle: &Poly) -> (Poly, Poly, f64) {
    let speed = angle.derivative();
    if speed.most() == 0.0 {
        let (sine, cosine) = libm::sincos(angle.first());
        return (Poly::constant(cosine), Poly::constant(sine), 0.0);
    }
    let growth = speed.derivative();
    let first = jet(angle.first(), speed.first(), growth.first());
    let last = jet(angle.last(), speed.last(), growth.last());
    let [cosine, sine] = [0, 1].map(|k| Poly::hermite(first[k], last[k]));
    let residuals = [
        cosine.derivative().plus(1.0, &speed.times(&sine)),
        sine.derivative().plus(-1.0, &speed.times(&cosine)),
    ];
    let error = residuals[0].most().hypot(residuals[1].most());
    (cosine, sine, error)
}

/// Cosine and sine with their first two derivatives.
fn jet(angle: f64, speed: f64, growth: f64) -> [[f64; 3]; 2] {
    let (sine, cosine) = libm::sincos(angle);
    let square = speed * speed;
    [
        [cosine, -speed * sine, -growth * sine - square * cosine],
        [sine, speed * cosine, growth * cosine - square * sine],
    ]
}
