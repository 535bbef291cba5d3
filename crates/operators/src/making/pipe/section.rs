//! The section of a tube.

use pforms_kernel::{Error, Form, Result};

use crate::measuring::vector::norm;
use crate::{Spline, subdivide};

/// A section and what must be known of it.
pub(super) struct Section<'a> {
    pub spline: &'a Spline,
    /// No point of it is further from the origin.
    pub reach: f64,
    /// Points of it, for what is measured and not proved.
    pub samples: Vec<Vec<f64>>,
}

/// Numbers along each axis of a grid of samples, by the number of axes.
const SAMPLES: [usize; 4] = [1, 65, 17, 9];

/// Halvings after which the weights of a section are looked at again.
const LEVELS: [u32; 3] = [2, 4, 6];

impl<'a> Section<'a> {
    pub(super) fn new(spline: &'a Spline) -> Result<Self> {
        let net = spline.net();
        if net.axes() > 3 || !(2..=3).contains(&net.ambient()) {
            return Err(Error::shape(
                "section",
                format!("a {} in {}D", net.kind(), net.ambient()),
                "a form of at most 3 axes in 2D, or in 3D with z along the path",
            ));
        }
        require_across(net)?;
        let mut reach = 0.0_f64;
        for piece in spline.pieces()? {
            reach = reach.max(reach_of(&piece)?);
        }
        Ok(Self { spline, reach, samples: samples(spline)? })
    }

    /// Does it leave the plane across the path?
    pub(super) fn is_solid(&self) -> bool {
        self.spline.ambient() == 3
    }
}

/// Complains about a section in a plane along the path, which would only slide in itself.
fn require_across(net: &Form) -> Result<()> {
    let flat = net.ambient() == 2 || net.homogeneous().chunks_exact(4).all(|pole| pole[2] == 0.0);
    if flat || net.axes() == 0 {
        return Ok(());
    }
    let poles: Vec<[f64; 3]> =
        net.homogeneous().chunks_exact(4).map(|pole| [pole[0], pole[1], pole[3]]).collect();
    let size = poles.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    let unit: Vec<[f64; 3]> = poles.iter().map(|pole| pole.map(|x| x / size)).collect();
    let determinant = |a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    let Some(first) = unit.first() else { return Ok(()) };
    let apart = |a: &[f64; 3], b: &[f64; 3]| {
        norm(&[a[0] * b[2] - a[2] * b[0], a[1] * b[2] - a[2] * b[1], a[0] * b[1] - a[1] * b[0]])
    };
    let Some(second) = unit.iter().max_by(|a, b| apart(first, a).total_cmp(&apart(first, b)))
    else {
        return Ok(());
    };
    if unit.iter().any(|third| determinant(first, second, third).abs() > 1e-12) {
        return Ok(());
    }
    Err(Error::degenerate(
        "section",
        "a curve in a plane along the path: x and y lie on a line",
        "a section across the path: x along the normal, y along the binormal",
    ))
}

/// A bound on the distance from the origin, by the poles of ever smaller pieces.
fn reach_of(form: &Form) -> Result<f64> {
    for level in LEVELS {
        let levels = vec![level.min(12 / form.axes().max(1) as u32); form.axes()];
        let refined = subdivide(form, &levels)?;
        let net = refined.net();
        let sign = net.homogeneous()[net.ambient()].signum();
        let poles = || net.homogeneous().chunks_exact(net.width());
        if poles().all(|pole| sign * pole[net.ambient()] > 0.0) {
            let distance = |pole: &[f64]| {
                let weight = pole[net.ambient()];
                norm(&pole[..net.ambient()].iter().map(|x| x / weight).collect::<Vec<_>>())
            };
            return Ok(poles().map(distance).fold(0.0, f64::max));
        }
    }
    Err(Error::domain("section", "a weight that vanishes", "a section that stays near"))
}

/// Points of the section on a grid over its window.
fn samples(spline: &Spline) -> Result<Vec<Vec<f64>>> {
    let axes = spline.axes();
    let count = SAMPLES[axes.min(3)];
    let mut lists = Vec::with_capacity(axes);
    for axis in 0..axes {
        let (from, to) = spline.window(axis)?;
        lists.push(
            (0..count)
                .map(|i| from + (to - from) * (i as f64 / (count - 1) as f64))
                .collect::<Vec<f64>>(),
        );
    }
    let lists: Vec<&[f64]> = lists.iter().map(Vec::as_slice).collect();
    let points = spline.grid(&lists)?;
    Ok(points.chunks_exact(spline.ambient()).map(<[f64]>::to_vec).collect())
}
