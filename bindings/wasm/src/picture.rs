//! Drawn cells as buffers for a graphics card.

use std::collections::BTreeMap;

use pforms_catalogue::Value;
use pforms_formula::Address;
use pforms_kernel::Result;
use pforms_mesh::{Triangles, tube};
use pforms_scene::{Buffers, Part, Shapes, Style, draw};
use pforms_sheet::Sheet;

/// Sides of a tube on the screen.
const SIDES: usize = 10;

/// A drawn cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// The cell.
    pub address: String,
    /// Red, green and blue as a screen takes them, 0 to 1.
    pub color: [f64; 3],
    /// 0 to 1.
    pub opacity: f64,
    /// What it consists of; none when that is as it was when the cell was drawn last.
    pub shape: Option<Vec<Piece>>,
}

/// A part of a drawing: triangles, or points that the page draws as spheres.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// Triangles, in arrays of three numbers each.
    Mesh {
        /// The vertices.
        positions: Vec<f32>,
        /// Their unit normals.
        normals: Vec<f32>,
        /// Three vertices for each triangle; none when they are as they were.
        indices: Option<Vec<u32>>,
    },
    /// Points.
    Balls {
        /// The centres.
        positions: Vec<f32>,
        /// Radius of each.
        radius: f64,
    },
}

/// What the page has of the cells it was told to draw, as far as it need not be told again.
#[derive(Clone, Debug, Default)]
pub(crate) struct Gallery {
    hung: BTreeMap<Address, Hung>,
}

/// A drawing as the page has it.
#[derive(Clone, Debug)]
struct Hung {
    style: Style,
    /// The triangles of each piece; a mesh dragged by its poles mostly keeps them.
    indices: Vec<Vec<u32>>,
}

impl Gallery {
    /// Draws a cell in its style; `None` when it is not shown or holds an error or nothing.
    ///
    /// `same` tells that its value is the one that was drawn last.
    ///
    /// Errors: those of reading the style and of drawing.
    pub(crate) fn draw(
        &mut self,
        sheet: &Sheet,
        at: Address,
        same: bool,
    ) -> Result<Option<Drawing>> {
        let before = self.hung.remove(&at);
        let value = sheet.value(at);
        let Some(settings) = sheet.document().show(at) else { return Ok(None) };
        if value.is_error() || matches!(value, Value::Empty) {
            return Ok(None);
        }
        let style = Style::from_settings(settings)?;
        let (color, opacity) = (style.color.encoded(), style.opacity);
        let drawing = |shape| Drawing { address: at.to_string(), color, opacity, shape };
        if let Some(before) = before.as_ref().filter(|before| same && before.shapes_as(&style)) {
            self.hung.insert(at, Hung { style, ..before.clone() });
            return Ok(Some(drawing(None)));
        }
        let parts = draw(&Shapes::in_value(value)?, &style)?;
        let mut indices = before.map(|before| before.indices).unwrap_or_default();
        let shape = pieces(parts, &mut indices)?;
        self.hung.insert(at, Hung { style, indices });
        Ok(Some(drawing(Some(shape))))
    }
}

impl Hung {
    /// Does the other style change nothing but the colour?
    fn shapes_as(&self, style: &Style) -> bool {
        let Style { color, opacity, .. } = *style;
        Style { color, opacity, ..self.style.clone() } == *style
    }
}

/// The parts for a graphics card; `known` are the triangles that the page has, and will have.
fn pieces(parts: Vec<Part>, known: &mut Vec<Vec<u32>>) -> Result<Vec<Piece>> {
    let mut shape = Vec::with_capacity(parts.len());
    let mut meshes = 0;
    for part in parts {
        shape.push(match solid(part)?.into_buffers() {
            Buffers::Triangles { positions, normals, indices } => {
                if known.len() == meshes {
                    known.push(Vec::new());
                }
                let same = known[meshes] == indices && !indices.is_empty();
                if !same {
                    known[meshes].clone_from(&indices);
                }
                meshes += 1;
                Piece::Mesh { positions, normals, indices: (!same).then_some(indices) }
            }
            Buffers::Points { positions, radius } => Piece::Balls { positions, radius },
            // Lines are tubes by now.
            Buffers::Lines { .. } => continue,
        });
    }
    known.truncate(meshes);
    Ok(shape)
}

/// A part with its lines as round tubes.
fn solid(part: Part) -> Result<Part> {
    let Part::Lines { polylines, radius } = part else { return Ok(part) };
    let mut all = Triangles::default();
    for line in polylines {
        all.append(&tube(&line, radius, SIDES)?);
    }
    Ok(Part::Triangles(all))
}
