//! Unnormalised tangents and normals of splines as splines: those of the pieces.

use pforms_kernel::{Error, Form, Result, Scalar};

use super::normal_form::{binormal_form, normal_form};
use super::tangent_form::tangent_form;
use crate::Spline;

impl<S: Scalar> Spline<S> {
    /// The tangent along `axis` as a spline of vectors, `W²·∂f/∂u_axis`: see [`tangent_form`]. Exact.
    ///
    /// Where it may jump, at a knot as often repeated as the degree, the pieces keep their own poles.
    ///
    /// Errors: as there.
    pub fn tangent_form(&self, axis: usize) -> Result<Self> {
        self.net().require_axis(axis)?;
        let orders: Vec<usize> = (0..self.axes()).map(|k| usize::from(k == axis)).collect();
        self.differentiated(
            &orders,
            |piece| tangent_form(piece, axis),
            |length| length[axis].clone(),
        )
    }

    /// The normal as a spline of vectors: see [`normal_form`]. Exact.
    ///
    /// Errors: as there.
    pub fn normal_form(&self) -> Result<Self> {
        match (self.axes(), self.ambient()) {
            (1, 2) => self.differentiated(&[1], normal_form, |length| length[0].clone()),
            (1, 3) => self.differentiated(&[2], normal_form, |length| length[0].power(4)),
            (2, 3) => self.differentiated(&[1, 1], normal_form, |length| {
                length[0].clone() * length[1].clone()
            }),
            _ => Err(Error::shape(
                "form",
                format!("a spline of {} axes in dimension {}", self.axes(), self.ambient()),
                "a surface in dimension 3 or a curve in dimension 2 or 3",
            )),
        }
    }

    /// The binormal of a curve in space as a spline of vectors: see [`binormal_form`]. Exact.
    ///
    /// Errors: as there.
    pub fn binormal_form(&self) -> Result<Self> {
        if self.axes() == 1 {
            return self.differentiated(&[2], binormal_form, |length| length[0].power(3));
        }
        binormal_form(self.net()).map(Self::from)
    }

    /// What an operator makes of the pieces, parted where derivatives of these orders may jump,
    /// divided by the powers of the lengths of their windows that it is too large by.
    fn differentiated(
        &self,
        orders: &[usize],
        operator: impl Fn(&Form<S>) -> Result<Form<S>>,
        excess: impl Fn(&[S]) -> S,
    ) -> Result<Self> {
        self.parted_by(orders)?.map_pieces(|piece, window| {
            let lengths: Vec<S> = window.iter().map(|(a, b)| b.clone() - a.clone()).collect();
            let vectors = operator(piece)?;
            let (width, divisor) = (vectors.width(), excess(&lengths));
            let mut poles = vectors.homogeneous().to_vec();
            for pole in poles.chunks_exact_mut(width) {
                for x in &mut pole[..width - 1] {
                    *x = x.clone() / divisor.clone();
                }
            }
            Form::from_homogeneous(vectors.orders(), vectors.ambient(), poles)
        })
    }
}
