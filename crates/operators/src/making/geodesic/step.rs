//! One step of a geodesic by the method of order 8 of Dormand and Prince.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; components are counted"
)]

use super::number::Number;
use super::tableau::{ALL, BETWEEN, FIFTH, MORE, PLACES, STAGES, STEP, THIRD, Tap};

/// A place and a velocity.
#[derive(Clone, Copy, Debug)]
pub(super) struct State<T> {
    pub place: [T; 2],
    pub velocity: [T; 2],
}

/// A step, its end not yet looked at.
pub(super) struct Step<T> {
    /// The derivative of the state at each stage: velocity, acceleration.
    stages: [[T; 4]; ALL],
    pub end: State<T>,
    /// What the end differs by from those of orders 5 and 3.
    pub errors: [[T; 4]; 2],
}

/// Bernstein coefficients of the places over a step, from its begin to its end.
pub(super) type Path = [[f64; 8]; 2];

impl<T: Number> State<T> {
    #[inline(always)]
    fn moved(&self, by: T, stages: &[[T; 4]; ALL], taps: &[Tap]) -> Self {
        let sum = combined(by, stages, taps);
        Self {
            place: [self.place[0] + sum[0], self.place[1] + sum[1]],
            velocity: [self.velocity[0] + sum[2], self.velocity[1] + sum[3]],
        }
    }
}

#[inline(always)]
fn combined<T: Number>(by: T, stages: &[[T; 4]; ALL], taps: &[Tap]) -> [T; 4] {
    let mut sum = [by.like(0.0); 4];
    for &(stage, factor) in taps {
        let factor = by.like(factor);
        for k in 0..4 {
            sum[k] = sum[k] + factor * stages[stage][k];
        }
    }
    sum.map(|x| by * x)
}

/// Goes `by` along, from a state whose acceleration is known.
#[inline(always)]
pub(super) fn step<T: Number>(
    from: &State<T>,
    acceleration: [T; 2],
    by: T,
    field: &impl Fn([T; 2], [T; 2]) -> [T; 2],
) -> Step<T> {
    let derivative = |velocity: [T; 2], [a, b]: [T; 2]| [velocity[0], velocity[1], a, b];
    let mut stages = [[by.like(0.0); 4]; ALL];
    stages[0] = derivative(from.velocity, acceleration);
    for (stage, taps) in PLACES.iter().enumerate() {
        let at = from.moved(by, &stages, taps);
        stages[stage + 1] = derivative(at.velocity, field(at.place, at.velocity));
    }
    let end = from.moved(by, &stages, STEP);
    let errors = [combined(by, &stages, FIFTH), combined(by, &stages, THIRD)];
    Step { stages, end, errors }
}

impl Step<f64> {
    /// The polynomial of degree 7 between the ends, given the acceleration at the end.
    pub(super) fn path(
        &mut self,
        from: &State<f64>,
        acceleration: [f64; 2],
        by: f64,
        field: &impl Fn([f64; 2], [f64; 2]) -> [f64; 2],
    ) -> Path {
        let end = self.end.velocity;
        self.stages[STAGES] = [end[0], end[1], acceleration[0], acceleration[1]];
        for (more, taps) in MORE.iter().enumerate() {
            let at = from.moved(by, &self.stages, taps);
            let [a, b] = field(at.place, at.velocity);
            self.stages[STAGES + 1 + more] = [at.velocity[0], at.velocity[1], a, b];
        }
        let last: [[f64; 4]; 4] = BETWEEN.map(|taps| combined(by, &self.stages, taps));
        [0, 1].map(|k| {
            let rise = self.end.place[k] - from.place[k];
            let (begin, end) = (by * from.velocity[k], by * end[k]);
            let factors = [
                from.place[k],
                rise,
                begin - rise,
                2.0 * rise - (begin + end),
                last[0][k],
                last[1][k],
                last[2][k],
                last[3][k],
            ];
            let mut path = nested(&factors);
            path[7] = self.end.place[k];
            path
        })
    }
}

/// `a₀ + x(a₁ + (1−x)(a₂ + x(a₃ + (1−x)(a₄ + x(a₅ + (1−x)(a₆ + x a₇))))))` in Bernstein form.
fn nested(factors: &[f64; 8]) -> [f64; 8] {
    let mut poles = [0.0; 8];
    poles[0] = factors[7];
    for degree in 1..8 {
        // Odd degrees come by a factor x, even ones by 1 − x.
        let mut raised = [0.0; 8];
        for i in 0..=degree {
            let share = i as f64 / degree as f64;
            raised[i] = if degree % 2 == 1 {
                if i == 0 { 0.0 } else { share * poles[i - 1] }
            } else if i == degree {
                0.0
            } else {
                (1.0 - share) * poles[i]
            };
            raised[i] += factors[7 - degree];
        }
        poles = raised;
    }
    poles
}

/// Value, slope and second derivative of a polynomial of degree 7 over a step of length `by`.
pub(super) fn along(poles: &[f64; 8], share: f64, by: f64) -> [f64; 3] {
    let mut row = *poles;
    for length in (3..8).rev() {
        for i in 0..length {
            row[i] = (1.0 - share) * row[i] + share * row[i + 1];
        }
    }
    let [a, b, c, ..] = row;
    let bend = 42.0 * (a - 2.0 * b + c);
    let (a, b) = ((1.0 - share) * a + share * b, (1.0 - share) * b + share * c);
    [(1.0 - share) * a + share * b, 7.0 * (b - a) / by, bend / (by * by)]
}
