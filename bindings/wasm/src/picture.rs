//! Drawn cells as buffers for a graphics card.

use pforms_catalogue::Value;
use pforms_formula::Address;
use pforms_kernel::Result;
use pforms_mesh::{Triangles, tube};
use pforms_scene::{Buffers, Part, Shapes, Style, draw};
use pforms_sheet::{Settings, Sheet};

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
    /// What it consists of: triangles, and points that the page draws as spheres.
    pub buffers: Vec<Buffers>,
}

impl Drawing {
    /// Draws a cell in its style; `None` when it is not shown or holds an error or nothing.
    ///
    /// Errors: those of reading the style and of drawing.
    pub(crate) fn of(sheet: &Sheet, at: Address) -> Result<Option<Self>> {
        let value = sheet.value(at);
        match sheet.document().show(at) {
            Some(settings) if !value.is_error() && !matches!(value, Value::Empty) => {
                Self::in_style(at, value, settings).map(Some)
            }
            _ => Ok(None),
        }
    }

    fn in_style(at: Address, value: &Value, settings: &Settings) -> Result<Self> {
        let style = Style::from_settings(settings)?;
        let parts = draw(&Shapes::in_value(value)?, &style)?;
        Ok(Self {
            address: at.to_string(),
            color: style.color.encoded(),
            opacity: style.opacity,
            buffers: parts.iter().map(solid).collect::<Result<_>>()?,
        })
    }
}

/// A part with its lines as round tubes.
fn solid(part: &Part) -> Result<Buffers> {
    let Part::Lines { polylines, radius } = part else { return Ok(part.buffers()) };
    let mut all = Triangles::default();
    for line in polylines {
        all.append(&tube(line, *radius, SIDES)?);
    }
    Ok(Part::Triangles(all).buffers())
}
