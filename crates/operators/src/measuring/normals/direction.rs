//! From a point and its derivatives to the unit normal, and blocks of normals on their way out.

#![allow(
    clippy::inline_always,
    clippy::needless_range_loop,
    reason = "only what is inlined is compiled for the wider sets; lanes are counted, not iterated"
)]

use pforms_kernel::lanes::{Lanes, MOST};
use pforms_kernel::{Form, Result};

use super::net::Nets;
use crate::measuring::surface_frame::limit_normal;

/// Sine of the angle between the tangents, and share of the largest possible derivative, below
/// which a point goes to the careful way. They trade speed only: both ways are right there.
const CLEAR: f64 = 1e-4;

/// Normals of a block at most.
pub(super) const BLOCK: usize = 256;

/// Length of a column: the last lanes may stand over.
const COLUMN: usize = BLOCK + MOST;

type Column = [f64; COLUMN];

/// The homogeneous points of a block and their derivatives, in columns that stay in the first
/// cache: sums over poles leave lanes, and the formulas then run over contiguous numbers.
pub(super) struct Block {
    /// `Q` and `W`, then their derivatives along `u`, then along `v`.
    jets: [[Column; 4]; 3],
    normals: [Column; 3],
    clear: Column,
}

impl Block {
    #[allow(clippy::large_stack_arrays, reason = "32 kB, once for each call")]
    pub(super) fn new() -> Self {
        Self { jets: [[[0.0; COLUMN]; 4]; 3], normals: [[0.0; COLUMN]; 3], clear: [0.0; COLUMN] }
    }

    /// Puts down one of the three for `N` points, from point `at` on.
    #[inline(always)]
    pub(super) fn put<const N: usize>(&mut self, which: usize, at: usize, sums: &[Lanes<N>; 4]) {
        for (column, lanes) in self.jets[which].iter_mut().zip(sums) {
            lanes.store(&mut column[at..]);
        }
    }

    /// Writes the normals of the points put down, those in doubt by way of the limit at
    /// `parameters(i)`. `uniform` is the weight of all poles, if they have one.
    ///
    /// Errors: `Degenerate` where there is no normal, `Domain` where the weight vanishes.
    #[inline(always)]
    pub(super) fn write(
        &mut self,
        out: &mut [[f64; 3]],
        nets: &Nets,
        parameters: impl Fn(usize) -> [f64; 2],
    ) -> Result<()> {
        assert!(out.len() <= BLOCK);
        if let Some(weight) = nets.uniform {
            self.jets[0][3].fill(weight);
            self.jets[1][3].fill(0.0);
            self.jets[2][3].fill(0.0);
        }
        self.point_normals(out.len(), nets.reach);
        let [x, y, z] = &self.normals;
        let mut doubts = 0;
        for (i, normal) in out.iter_mut().enumerate() {
            *normal = [x[i], y[i], z[i]];
            doubts |= self.clear[i].to_bits() ^ 1.0_f64.to_bits();
        }
        if doubts == 0 {
            return Ok(());
        }
        for (i, normal) in out.iter_mut().enumerate().filter(|(i, _)| self.clear[*i] != 1.0) {
            *normal = limit(nets.surface, parameters(i))?;
        }
        Ok(())
    }

    /// The unit normals of the first points, and 1 where they can be trusted: where the tangents
    /// are neither too short, compared with the `reach` of the poles, nor too aligned.
    #[inline(always)]
    fn point_normals(&mut self, count: usize, reach: f64) {
        assert!(count <= BLOCK);
        let [[x, y, z, w], [xu, yu, zu, wu], [xv, yv, zv, wv]] = &self.jets;
        let [nx, ny, nz] = &mut self.normals;
        for i in 0..count {
            // d·W − Q·W_d: the derivative of Q / W, but for the length.
            let a = [
                xu[i] * w[i] - x[i] * wu[i],
                yu[i] * w[i] - y[i] * wu[i],
                zu[i] * w[i] - z[i] * wu[i],
            ];
            let b = [
                xv[i] * w[i] - x[i] * wv[i],
                yv[i] * w[i] - y[i] * wv[i],
                zv[i] * w[i] - z[i] * wv[i],
            ];
            let n =
                [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
            let (aa, bb, nn) = (square(a), square(b), square(n));
            let short = CLEAR * w[i] * reach;
            let (short, narrow) = (short * short, CLEAR * CLEAR * aa * bb);
            let clear = aa > short && bb > short && nn > narrow;
            self.clear[i] = f64::from(u8::from(clear));
            let length = nn.sqrt();
            nx[i] = n[0] / length;
            ny[i] = n[1] / length;
            nz[i] = n[2] / length;
        }
    }
}

#[inline(always)]
fn square([x, y, z]: [f64; 3]) -> f64 {
    x * x + y * y + z * z
}

#[cold]
fn limit(surface: &Form, at: [f64; 2]) -> Result<[f64; 3]> {
    let normal = limit_normal(surface, &at)?;
    Ok([normal[0], normal[1], normal[2]])
}
