//! Frames and curvatures of splines: those of the piece, in the parameters of the spline.

use pforms_kernel::{Error, Result};

use super::curvature::{Curvature, curvature};
use super::curve_frame::{CurveFrame, FrameKind, curve_frames};
use super::normals::{normal_grid_into, normals_into};
use super::rotation_minimising::along_pieces;
use super::surface_frame::{SurfaceFrame, surface_frame};
use super::volume_frame::{VolumeFrame, volume_frame};
use crate::{Located, Spline};

/// Frames of a spline; at a break those of the piece that begins there.
impl Spline<f64> {
    /// Frames of a curve at many parameters, as [`curve_frames`].
    ///
    /// A rotation-minimising normal is carried from the beginning of the window through all pieces;
    /// where the tangent jumps it turns with it by the shortest way.
    ///
    /// Errors: as [`curve_frames`].
    pub fn curve_frames(
        &self,
        parameters: &[f64],
        kind: FrameKind,
        accuracy: f64,
    ) -> Result<Vec<CurveFrame>> {
        self.require_axes(1, "a curve")?;
        if kind == FrameKind::RotationMinimising {
            return along_pieces(self, parameters, accuracy);
        }
        parameters
            .iter()
            .map(|&t| {
                let place = self.locate(&[t])?;
                let frames = curve_frames(&place.piece, &place.parameters, kind, accuracy)?;
                let frame = frames.into_iter().next().ok_or_else(|| self.wrong("a curve"))?;
                Ok(CurveFrame { parameter: t, ..frame.slowed(place.lengths[0]) })
            })
            .collect()
    }

    /// The frame of a surface, as [`surface_frame`].
    ///
    /// Errors: as there.
    pub fn surface_frame(&self, u: f64, v: f64) -> Result<SurfaceFrame> {
        self.require_axes(2, "a surface")?;
        let Located { piece, parameters, lengths, .. } = self.locate(&[u, v])?;
        let frame = surface_frame(&piece, parameters[0], parameters[1])?;
        Ok(frame.slowed([lengths[0], lengths[1]]))
    }

    /// The tangents of a spline with any number of axes, as [`volume_frame`].
    ///
    /// Errors: as there.
    pub fn volume_frame(&self, parameters: &[f64]) -> Result<VolumeFrame> {
        let place = self.locate(parameters)?;
        Ok(volume_frame(&place.piece, &place.parameters)?.slowed(&place.lengths))
    }

    /// How a curve or a surface bends, as [`curvature`]: no matter of parameters.
    ///
    /// Errors: as there.
    pub fn curvature(&self, parameters: &[f64]) -> Result<Curvature> {
        let place = self.locate(parameters)?;
        curvature(&place.piece, &place.parameters)
    }

    /// Unit normals of a surface at scattered parameters, as [`normals_into`].
    ///
    /// Errors: as there.
    pub fn normals_into(&self, parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
        self.require_axes(2, "a surface")?;
        self.each_scattered(parameters, out, |piece, _, lists, part| {
            normals_into(piece, lists, part)
        })
    }

    /// Unit normals of a surface on a grid, as [`normal_grid_into`].
    ///
    /// Errors: as there.
    pub fn normal_grid_into(&self, parameters: &[&[f64]], out: &mut [f64]) -> Result<()> {
        self.require_axes(2, "a surface")?;
        self.each_on_grid(parameters, out, normal_grid_into)
    }

    fn require_axes(&self, axes: usize, expected: &str) -> Result<()> {
        if self.axes() == axes { Ok(()) } else { Err(self.wrong(expected)) }
    }

    fn wrong(&self, expected: &str) -> Error {
        let received = format!("a spline of {} axes in dimension {}", self.axes(), self.ambient());
        Error::shape("form", received, expected)
    }
}
