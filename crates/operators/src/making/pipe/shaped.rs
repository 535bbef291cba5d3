//! The columns of a tube's matrices: its frame times its radius, turned by its twist.

use pforms_kernel::{Error, Result};

use super::circle::circle;
use super::frames::{Frame, MOST_PARTS};
use super::law::Law;
use super::path::Part;
use super::poly::Poly;
use super::vector::Vector;

/// What becomes of the frame.
pub(super) struct Laws<'a> {
    pub radius: &'a Law,
    pub twist: &'a Law,
    /// The angle by which the frame is turned back, evenly from the start to the end.
    pub closing: f64,
    /// Window of the path.
    pub window: (f64, f64),
}

/// A part of the tube's matrices: vectors of a degree of at most [`DEGREE`].
#[derive(Clone, Debug)]
pub(super) struct Shaped {
    pub part: Part,
    pub columns: Vec<Vector>,
    /// How far each column may be from the true one.
    pub error: f64,
}

/// The degree of the polynomials that stand for frames.
const DEGREE: usize = 5;

/// How often a part may be halved for the sake of radius and twist.
const DEPTH: usize = 40;

impl Laws<'_> {
    fn share(&self, t: f64) -> f64 {
        let (from, to) = self.window;
        ((t - from) / (to - from)).clamp(0.0, 1.0)
    }

    /// Columns for every frame; `room` is what radius and twist may add to the error of a column.
    pub(super) fn shape(&self, frames: Vec<Frame>, room: f64) -> Result<Vec<Shaped>> {
        let mut done = Vec::with_capacity(frames.len());
        let mut stack: Vec<(Frame, usize)> =
            frames.into_iter().rev().map(|frame| (frame, DEPTH)).collect();
        while let Some((frame, depth)) = stack.pop() {
            let (shaped, added) = self.shaped(&frame)?;
            if added <= room {
                done.push(shaped);
                continue;
            }
            if depth == 0 || done.len() >= MOST_PARTS || !frame.part.is_divisible() {
                let expected = "a larger one, or a smoother radius and twist";
                return Err(Error::accuracy("tolerance", format!("{room:e}"), expected));
            }
            let (left, right) = halves(&frame);
            stack.extend([(right, depth - 1), (left, depth - 1)]);
        }
        Ok(done)
    }

    /// Columns over a part, and what was added to the error of the frame.
    fn shaped(&self, frame: &Frame) -> Result<(Shaped, f64)> {
        let (from, to) = (self.share(frame.part.from), self.share(frame.part.to));
        let (radius, radius_off) = self.radius.over(from, to)?;
        let (mut angle, angle_off) = self.twist.over(from, to)?;
        if self.closing != 0.0 {
            angle = angle.plus(-self.closing, &Poly(vec![from, to]));
        }
        let (turned, turn_off, grown) = turned(frame, &angle, angle_off);
        let (mut columns, mut off) = (Vec::new(), 0.0_f64);
        for vector in turned {
            let column = vector.times(&radius);
            let near = lowered(&column);
            off = off.max(near.plus(-1.0, &column).most());
            columns.push(near);
        }
        let added = off + radius_off + (radius.most() + radius_off) * turn_off;
        let error = added + (radius.most() + radius_off) * grown * frame.error;
        Ok((Shaped { part: frame.part.clone(), columns, error }, added))
    }
}

/// Normal and binormal turned by an angle; how far off the turn is, and by what factor it enlarges
/// the error of the frame.
fn turned(frame: &Frame, angle: &Poly, angle_off: f64) -> (Vec<Vector>, f64, f64) {
    let mut vectors = frame.vectors.clone();
    if angle.most() == 0.0 && angle_off == 0.0 {
        return (vectors, 0.0, 1.0);
    }
    let (cosine, sine, off) = circle(angle);
    let (normal, binormal) = (&frame.vectors[0], &frame.vectors[1]);
    vectors[0] = normal.times(&cosine).plus(1.0, &binormal.times(&sine));
    vectors[1] = binormal.times(&cosine).plus(-1.0, &normal.times(&sine));
    // |p|·|Δn| + |q|·|Δb| for a point (p, q) near the circle, and the same for its own distance.
    let root = std::f64::consts::SQRT_2;
    (vectors, root * (off + angle_off), root * (1.0 + off))
}

/// A vector of degree 5 at most with the same ends and derivatives there.
fn lowered(column: &Vector) -> Vector {
    if column.degree() <= DEGREE {
        return column.clone();
    }
    let first = column.derivative();
    let second = first.derivative();
    let jets = [column, &first, &second];
    Vector::hermite(jets.map(Vector::first), jets.map(Vector::last))
}

fn halves(frame: &Frame) -> (Frame, Frame) {
    let (left, right) = frame.part.halves();
    let (low, high) = frame.vectors.iter().map(Vector::halves).unzip();
    (
        Frame { part: left, vectors: low, error: frame.error },
        Frame { part: right, vectors: high, error: frame.error },
    )
}
