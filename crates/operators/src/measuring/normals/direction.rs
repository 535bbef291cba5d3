//! From a point and its derivatives to the unit normal, and blocks of normals on their way out.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::vectors::{Lanes, MOST, Simd};
use pforms_kernel::{Form, Result};

use crate::measuring::surface_frame::limit_normal;

/// Sine of the angle between the tangents, and share of the largest possible derivative, below
/// which a point goes to the careful way. They trade speed only: both ways are right there.
const CLEAR: f64 = 1e-4;

/// `Q` and `W` at the points of the lanes, and their derivatives along `u` and `v`.
pub(super) struct Jets<S: Simd> {
    pub point: [Lanes<S>; 4],
    pub along_u: [Lanes<S>; 4],
    pub along_v: [Lanes<S>; 4],
}

impl<S: Simd> Jets<S> {
    /// Those of a form whose poles all have one weight: its derivatives vanish, so `Q` is not needed.
    #[inline(always)]
    pub(super) fn polynomial(
        weight: Lanes<S>,
        [xu, yu, zu]: [Lanes<S>; 3],
        [xv, yv, zv]: [Lanes<S>; 3],
    ) -> Self {
        let none = Lanes::splat(weight.simd(), 0.0);
        Self {
            point: [none, none, none, weight],
            along_u: [xu, yu, zu, none],
            along_v: [xv, yv, zv, none],
        }
    }

    /// Normals and their lengths; the length is 0 where they cannot be trusted: where the tangents
    /// are too short, compared with the `reach` of the poles, or too aligned.
    #[inline(always)]
    pub(super) fn normals(&self, reach: f64) -> [Lanes<S>; 4] {
        let weight = self.point[3];
        let simd = weight.simd();
        let constant = |x| Lanes::splat(simd, x);
        let (a, b) = (self.tangent(&self.along_u), self.tangent(&self.along_v));
        let normal =
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let (aa, bb, nn) = (square(&a), square(&b), square(&normal));
        let short = constant(CLEAR * reach) * weight;
        let (short, narrow) = (short * short, constant(CLEAR * CLEAR) * aa * bb);
        let none = constant(0.0);
        let length = nn.if_above(narrow, nn.sqrt(), none);
        let length = aa.if_above(short, length, none);
        let length = bb.if_above(short, length, none);
        [normal[0], normal[1], normal[2], length]
    }

    /// `d·W − Q·W_d`: the derivative of `Q / W`, but for the length.
    #[inline(always)]
    fn tangent(&self, d: &[Lanes<S>; 4]) -> [Lanes<S>; 3] {
        let ([x, y, z, w], [dx, dy, dz, dw]) = (self.point, *d);
        [dx * w - x * dw, dy * w - y * dw, dz * w - z * dw]
    }
}

#[inline(always)]
fn square<S: Simd>([x, y, z]: &[Lanes<S>; 3]) -> Lanes<S> {
    *x * *x + *y * *y + *z * *z
}

/// Normals of a block at most.
pub(super) const BLOCK: usize = 256;

/// Length of a column: the last lanes may stand over.
const COLUMN: usize = BLOCK + MOST;

/// Normals on their way out, and their lengths, in columns that stay in the first cache.
pub(super) struct Block([[f64; COLUMN]; 4]);

impl Block {
    pub(super) fn new() -> Self {
        Self([[0.0; COLUMN]; 4])
    }

    /// Puts down the normals and lengths of the points in the lanes, from point `at` on.
    #[inline(always)]
    pub(super) fn put<S: Simd>(&mut self, at: usize, normals: &[Lanes<S>; 4]) {
        assert!(at <= BLOCK);
        for k in 0..4 {
            normals[k].store(&mut self.0[k][at..]);
        }
    }

    /// Writes the unit normals of the points put down, those in doubt by way of the limit at
    /// `parameters(i)`.
    ///
    /// Errors: `Degenerate` where there is no normal, `Domain` where the weight vanishes.
    #[inline(always)]
    pub(super) fn write(
        &self,
        out: &mut [[f64; 3]],
        surface: &Form,
        parameters: impl Fn(usize) -> [f64; 2],
    ) -> Result<()> {
        assert!(out.len() <= BLOCK);
        let [x, y, z, length] = &self.0;
        let mut trusted = true;
        for (i, normal) in out.iter_mut().enumerate() {
            *normal = [x[i] / length[i], y[i] / length[i], z[i] / length[i]];
            trusted &= length[i] > 0.0;
        }
        if trusted {
            return Ok(());
        }
        for (i, normal) in out.iter_mut().enumerate().filter(|(i, _)| length[*i] == 0.0) {
            *normal = limit(surface, parameters(i))?;
        }
        Ok(())
    }
}

#[cold]
fn limit(surface: &Form, at: [f64; 2]) -> Result<[f64; 3]> {
    let normal = limit_normal(surface, &at)?;
    Ok([normal[0], normal[1], normal[2]])
}
