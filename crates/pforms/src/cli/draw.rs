//! `pforms draw`: a sheet or forms to a picture, a mesh or a file of forms.

use std::path::PathBuf;

use clap::Args;
use serde_json::{Map, Value as Json, json};

use super::{Outcome, input::Input, output};

/// Draw a sheet or forms into a file.
///
/// What a sheet shows is drawn in its styles and seen from its camera; the options change the
/// style of everything drawn.
#[derive(Args)]
pub(crate) struct Draw {
    /// A .pfs, .json or .bpt file; - reads standard input.
    file: PathBuf,
    /// The file to write: .glb .obj .stl .pov for a drawing, .json .bpt for the forms.
    #[arg(short, long)]
    output: PathBuf,
    #[command(flatten)]
    look: Look,
}

/// What is drawn, and how.
#[derive(Args)]
pub(crate) struct Look {
    /// Draw only this cell, or the form of this name, shown or not; may be given again.
    #[arg(long, value_name = "CELL")]
    cell: Vec<String>,
    /// How to draw: points curve surface envelope sheets fibres net poles normals; may be given again.
    #[arg(long, value_name = "WAY")]
    draw: Vec<String>,
    /// Halve each window so many times; one number, or one for each axis: 2,4.
    #[arg(long, value_name = "N", value_delimiter = ',', conflicts_with = "tolerance")]
    fineness: Vec<u32>,
    /// The greatest distance between the form and its facets.
    #[arg(long, value_name = "LENGTH")]
    tolerance: Option<f64>,
    /// flat or smooth.
    #[arg(long)]
    shading: Option<String>,
    /// #rrggbb.
    #[arg(long)]
    color: Option<String>,
    /// From 0, invisible, to 1.
    #[arg(long)]
    opacity: Option<f64>,
    /// Of points, curves, fibres and normals.
    #[arg(long)]
    radius: Option<f64>,
    /// Number of sheets, or of fibres in each direction.
    #[arg(long)]
    count: Option<usize>,
    /// OX, OY, OZ, AXO or PERSPECTIVE.
    #[arg(long)]
    view: Option<String>,
    /// The axis that stands upright: y (as in the book) or z (as in many models).
    #[arg(long, value_name = "AXIS", value_parser = ["y", "z"])]
    up: Option<String>,
    /// Without perspective, the picture shows 1/ZOOM across.
    #[arg(long)]
    zoom: Option<f64>,
    /// Leave out the axes of space.
    #[arg(long)]
    no_axes: bool,
}

impl Draw {
    pub(crate) fn run(self) -> Outcome {
        let input = Input::open(&self.file)?;
        let Look { cell, no_axes, .. } = &self.look;
        output::write(
            &self.output,
            &input,
            cell,
            &self.look.style(),
            &self.look.camera(),
            !no_axes,
        )?;
        Ok(true)
    }
}

impl Look {
    /// The keys of a style that the options set.
    fn style(&self) -> Map<String, Json> {
        let mut style = given([
            ("tolerance", self.tolerance.map(Json::from)),
            ("shading", self.shading.as_deref().map(Json::from)),
            ("color", self.color.as_deref().map(Json::from)),
            ("opacity", self.opacity.map(Json::from)),
            ("radius", self.radius.map(Json::from)),
            ("count", self.count.map(Json::from)),
        ]);
        if !self.draw.is_empty() {
            style.insert("draw".to_owned(), json!(self.draw));
        }
        match self.fineness.as_slice() {
            [] => {}
            [one] => drop(style.insert("fineness".to_owned(), json!(one))),
            several => drop(style.insert("fineness".to_owned(), json!(several))),
        }
        style
    }

    /// The keys of a camera that the options set.
    fn camera(&self) -> Map<String, Json> {
        given([
            ("view", self.view.as_ref().map(|view| Json::from(view.to_uppercase()))),
            ("up", self.up.as_deref().map(Json::from)),
            ("zoom", self.zoom.map(Json::from)),
        ])
    }
}

fn given<const N: usize>(keys: [(&str, Option<Json>); N]) -> Map<String, Json> {
    keys.into_iter().filter_map(|(key, value)| Some((key.to_owned(), value?))).collect()
}
