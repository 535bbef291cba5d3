//! Surfaces in units in which their numbers are neither large nor small.

use pforms_kernel::{Error, Form, Result};

use super::area::Minimal;
use super::boundary::Frame;
use crate::algebra::Spline;
use crate::measuring::unit;

/// The unit of length and that of weight, powers of two.
pub(super) struct Units {
    length: f64,
    weight: f64,
}

impl Units {
    /// Errors: `Domain` for weights that change sign or are all 0.
    pub(super) fn of(net: &Form) -> Result<Self> {
        let weights = net.weights();
        let (least, most) =
            weights.iter().fold((0.0_f64, 0.0_f64), |(a, b), w| (a.min(*w), b.max(*w)));
        if (least < 0.0) == (most > 0.0) {
            let received = format!("weights from {least} to {most}");
            return Err(Error::domain("boundary", received, "weights of one sign, inside too"));
        }
        let weight = if most > 0.0 { power_of_two(most) } else { -power_of_two(-least) };
        Ok(Self { length: unit([net]), weight })
    }

    pub(super) fn small(&self, spline: &Spline) -> Result<Spline> {
        let net = spline.net();
        let width = net.width();
        let mut poles = net.homogeneous().to_vec();
        for pole in poles.chunks_exact_mut(width) {
            for x in pole.iter_mut() {
                *x /= self.weight;
            }
            for x in &mut pole[..width - 1] {
                *x /= self.length;
            }
            if net.uniform_weight().is_some() {
                let weight = pole[width - 1];
                for x in pole.iter_mut() {
                    *x /= weight;
                }
            }
        }
        let small = Form::from_homogeneous(net.orders(), net.ambient(), poles)?;
        Spline::on(small, spline.knots().to_vec())
    }

    /// The report in the units of the boundary, whose own poles are kept to the bit.
    pub(super) fn restored(&self, found: Minimal, frame: &Frame<f64>) -> Result<Minimal> {
        let net = frame.spline.net();
        let width = net.width();
        let mut poles = net.homogeneous().to_vec();
        let surface = found.surface.into_spline();
        let uniform = net.uniform_weight();
        for &index in &frame.free {
            let pole = &surface.net().homogeneous()[index * width..][..width - 1];
            for (x, y) in poles[index * width..].iter_mut().zip(pole) {
                *x = y * self.length * uniform.copied().unwrap_or(self.weight);
            }
        }
        let restored = Form::from_homogeneous(net.orders(), net.ambient(), poles)?;
        let restored = match uniform {
            Some(weight) => restored.with_uniform_weight(weight),
            None => restored,
        };
        let (length, area) = (self.length, self.length * self.length);
        let found = Minimal {
            surface: frame.with(restored)?,
            area: found.area * area,
            error: found.error * area,
            coons_area: found.coons_area.map(|x| x * area),
            energy: found.energy * area,
            laplacian: found.laplacian * length,
            curvature: found.curvature / length,
            ..found
        };
        let numbers = [found.area, found.error, found.energy, found.laplacian, found.curvature];
        if numbers.iter().all(|x| x.is_finite()) {
            return Ok(found);
        }
        Err(Error::accuracy(
            "boundary",
            "areas beyond the range of numbers",
            "a smaller unit of length",
        ))
    }
}

fn power_of_two(x: f64) -> f64 {
    libm::ldexp(1.0, libm::ilogb(x).clamp(-1000, 1000))
}
