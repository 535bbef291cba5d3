//! How a value is drawn.

use pforms_kernel::{Error, Result};
use pforms_mesh::Sampling;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::{Color, Mode};

/// Are facets seen, or is light carried smoothly over them?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Shading {
    /// Every facet has its own normal.
    Flat,
    /// Exact normals at every sample.
    #[default]
    Smooth,
}

/// One number for all axes, or one for each.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged, expecting = "a whole number, or a list of one for each axis")]
pub enum Levels {
    /// The same for all.
    Same(u32),
    /// One for each.
    Each(Vec<u32>),
}

/// How a value is drawn: the table `[show.A4]` of a sheet.
///
/// Keys that are absent have the values of [`Style::default`]; unknown keys are refused.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Style {
    /// The ways to draw it; none stands for the most usual one.
    pub draw: Vec<Mode>,
    /// Facets or smooth.
    pub shading: Shading,
    /// The colour.
    pub color: Color,
    /// From 0, invisible, to 1.
    pub opacity: f64,
    /// Halvings of the window, 0 to 24.
    pub fineness: Levels,
    /// Greatest distance between form and facets; takes the place of `fineness`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Radius of points, curves, fibres and normals.
    pub radius: f64,
    /// Number of sheets, or of fibres in each direction.
    pub count: usize,
    /// The axis that sheets lie across and fibres run along.
    pub axis: usize,
    /// Length of normals; negative on the other side.
    pub length: f64,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            draw: Vec::new(),
            shading: Shading::Smooth,
            color: Color([0xf2, 0xc1, 0x4e]),
            opacity: 1.0,
            fineness: Levels::Same(4),
            tolerance: None,
            radius: 0.01,
            count: 5,
            axis: 0,
            length: 0.1,
        }
    }
}

impl Style {
    /// The style of a sheet's table.
    ///
    /// Errors: `Format` for an unknown key or a value of the wrong kind; `Domain` for one out of
    /// its range.
    ///
    /// ```
    /// use pforms_scene::{Mode, Style};
    /// let table = serde_json::json!({"draw": ["curve"], "radius": 0.02});
    /// let style = Style::from_settings(table.as_object().unwrap())?;
    /// assert_eq!(style.draw, [Mode::Curve]);
    /// assert_eq!(style.count, 5);
    /// # Ok::<(), pforms_kernel::Error>(())
    /// ```
    pub fn from_settings(settings: &Map<String, Value>) -> Result<Self> {
        let style: Self = serde_json::from_value(Value::Object(settings.clone()))
            .map_err(|error| Error::format("style", None, error))?;
        style.check()?;
        Ok(style)
    }

    /// Complains about a number out of its range.
    pub fn check(&self) -> Result<()> {
        if !(0.0..=1.0).contains(&self.opacity) {
            return Err(Error::domain("opacity", self.opacity, "0 to 1"));
        }
        if !(self.radius > 0.0 && self.radius.is_finite()) {
            return Err(Error::domain("radius", self.radius, "a positive length"));
        }
        if !self.length.is_finite() {
            return Err(Error::domain("length", self.length, "a finite length"));
        }
        if self.count == 0 {
            return Err(Error::domain("count", 0, "at least 1"));
        }
        Ok(())
    }

    /// How finely the form is to be sampled.
    pub fn sampling(&self) -> Sampling {
        match (self.tolerance, &self.fineness) {
            (Some(tolerance), _) => Sampling::Tolerance(tolerance),
            (None, Levels::Same(level)) => Sampling::Fineness(vec![*level]),
            (None, Levels::Each(levels)) => Sampling::Fineness(levels.clone()),
        }
    }
}
