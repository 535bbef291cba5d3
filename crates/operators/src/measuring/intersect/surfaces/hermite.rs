//! Quintics with the value and two derivatives of a curve at both ends.

use super::pair::Knot;
use super::space::{V3, apart, dot, minus, norm, plus, times};

/// The poles of the quintic over an interval of this length, from value and derivatives at both ends.
pub(super) fn poles<const N: usize>(
    length: f64,
    [p, dp, ddp]: [&[f64; N]; 3],
    [q, dq, ddq]: [&[f64; N]; 3],
) -> [[f64; N]; 6] {
    let (first, second) = (length / 5.0, length * length / 20.0);
    [
        *p,
        plus(p, first, dp),
        plus(&plus(p, 2.0 * first, dp), second, ddp),
        plus(&plus(q, -2.0 * first, dq), second, ddq),
        plus(q, -first, dq),
        *q,
    ]
}

/// The curve between two knots: in space and in all parameters.
pub(super) struct Piece {
    pub space: [V3; 6],
    pub places: [[f64; 4]; 6],
    pub length: f64,
}

impl Piece {
    /// The piece between two knots; its parameter is arc length, as nearly as a quintic has it.
    pub(super) fn between(from: &Knot, to: &Knot) -> Self {
        let ends =
            |length: f64| poles(length, [&from.p, &from.dp, &from.ddp], [&to.p, &to.dp, &to.ddp]);
        let mut length = norm(&minus(&to.p, &from.p));
        for _ in 0..3 {
            length = arc_length(&ends(length));
        }
        Self::over(from, to, length)
    }

    /// The piece of this length.
    pub(super) fn over(from: &Knot, to: &Knot, length: f64) -> Self {
        Self {
            space: poles(length, [&from.p, &from.dp, &from.ddp], [&to.p, &to.dp, &to.ddp]),
            places: poles(length, [&from.x, &from.dx, &from.ddx], [&to.x, &to.dx, &to.ddx]),
            length,
        }
    }

    /// Point in space, its direction, and place, at a share of the piece.
    pub(super) fn at(&self, share: f64) -> (V3, V3, [f64; 4]) {
        let (p, dp) = value_and_slope(&self.space, share);
        (p, dp, value_and_slope(&self.places, share).0)
    }

    /// Does it come within `reach` of a place, in every parameter?
    pub(super) fn passes(&self, x: &[f64; 4], reach: f64) -> bool {
        let (from, to) = (&self.places[0], &self.places[5]);
        if apart(x, from) > 2.0 * apart(from, to) + reach {
            return false;
        }
        let chord = plus(to, -1.0, from);
        let square: f64 = chord.iter().map(|d| d * d).sum();
        let along: f64 = chord.iter().zip(plus(x, -1.0, from)).map(|(c, d)| c * d).sum();
        let mut share = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
        for _ in 0..6 {
            let (place, slope) = value_and_slope(&self.places, share);
            let square: f64 = slope.iter().map(|d| d * d).sum();
            let ahead: f64 = slope.iter().zip(plus(x, -1.0, &place)).map(|(s, d)| s * d).sum();
            if square > 0.0 {
                share = (share + ahead / square).clamp(0.0, 1.0);
            }
        }
        apart(&value_and_slope(&self.places, share).0, x) <= reach
    }

    /// Does it come within `reach` of a point of space?
    pub(super) fn comes_to(&self, p: &V3, reach: f64) -> bool {
        let way = minus(p, &self.space[0]);
        let chord = minus(&self.space[5], &self.space[0]);
        if norm(&way) > 2.0 * self.length + reach {
            return false;
        }
        let mut share = (dot(&way, &chord) / dot(&chord, &chord)).clamp(0.0, 1.0);
        for _ in 0..6 {
            let (q, slope) = value_and_slope(&self.space, share);
            let off = minus(p, &q);
            if norm(&off) <= reach {
                return true;
            }
            share = (share + dot(&off, &slope) / dot(&slope, &slope)).clamp(0.0, 1.0);
        }
        false
    }

    /// The first share at which parameter `axis` has a value, if it is passed.
    pub(super) fn reaches(&self, axis: usize, value: f64) -> Option<f64> {
        let off = |share: f64| value_and_slope(&self.places, share).0[axis] - value;
        let (mut low, mut high) = (0.0, 1.0);
        let side = off(high) > 0.0;
        if (off(low) > 0.0) == side {
            return None;
        }
        for _ in 0..50 {
            let middle = f64::midpoint(low, high);
            if (off(middle) > 0.0) == side { high = middle } else { low = middle }
        }
        Some(high)
    }
}

fn value_and_slope<const N: usize>(poles: &[[f64; N]; 6], t: f64) -> ([f64; N], [f64; N]) {
    let mut row = *poles;
    for last in (1..5).rev() {
        for i in 0..=last {
            row[i] = std::array::from_fn(|k| row[i][k] + t * (row[i + 1][k] - row[i][k]));
        }
    }
    let slope = times(&plus(&row[1], -1.0, &row[0]), 5.0);
    (plus(&row[0], t / 5.0, &slope), slope)
}

/// By Gauss's rule with five nodes.
fn arc_length(poles: &[V3; 6]) -> f64 {
    const NODES: [(f64, f64); 3] = [
        (0.0, 0.284_444_444_444_444_45),
        (0.269_234_655_052_841_55, 0.239_314_335_249_683_23),
        (0.453_089_922_969_332, 0.118_463_442_528_094_54),
    ];
    let speed = |t: f64| {
        let slope = value_and_slope(poles, t).1;
        dot(&slope, &slope).sqrt()
    };
    NODES[1..].iter().fold(NODES[0].1 * speed(0.5), |sum, (off, weight)| {
        sum + weight * (speed(0.5 - off) + speed(0.5 + off))
    })
}
