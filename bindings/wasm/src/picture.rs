//! Drawn cells as buffers for a graphics card.

use pforms_catalogue::Value;
use pforms_formula::Address;
use pforms_kernel::Result;
use pforms_scene::{Buffers, Part, Shapes, Style, draw};
use pforms_sheet::{Settings, Sheet};

/// A drawn cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// The cell.
    pub address: String,
    /// Red, green and blue as a screen takes them, 0 to 1.
    pub color: [f64; 3],
    /// 0 to 1.
    pub opacity: f64,
    /// What it consists of.
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
            buffers: parts.iter().map(Part::buffers).collect(),
        })
    }
}
