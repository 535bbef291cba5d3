//! Bézier patches as text: the form of Newell's tea set.
//!
//! The first line holds the number of patches. Each patch is a line with its two degrees, then
//! its poles `x y z`, the second parameter running fastest. There are no weights.

use std::fmt::Write;

use pforms_kernel::{Error, Form, Result, limit};

use crate::Named;
use crate::tokens::Tokens;

/// The least a number takes in a file: a digit and a space.
const LEAST_BYTES: usize = 2;

/// Reads patches of any, also mixed, degrees.
///
/// Errors: `Format`, with line and column.
pub fn read(bytes: &[u8]) -> Result<Vec<Named>> {
    let mut tokens = Tokens::new("BPT", bytes)?;
    let count = tokens.whole("the number of patches")?;
    // A patch is two degrees and at least one pole.
    announce(&tokens, count.saturating_mul(5), &format!("{count} patches"))?;
    let mut forms = Vec::new();
    for patch in 1..=count {
        let what = |item: &str| format!("{item} of patch {patch}");
        let orders = [
            tokens.whole(&what("the first degree"))?.saturating_add(1),
            tokens.whole(&what("the second degree"))?.saturating_add(1),
        ];
        let poles = orders[0].saturating_mul(orders[1]);
        announce(&tokens, poles.saturating_mul(3), &what(&format!("{poles} poles")))?;
        limit::check::<f64>("the patch", &orders, 4)?;
        let mut points = Vec::with_capacity(poles * 3);
        for _ in 0..poles * 3 {
            points.push(tokens.number(&what("a coordinate"))?);
        }
        forms.push(Form::from_points(&orders, 3, &points, None)?.into());
    }
    tokens.end(&format!("{count} patches"))?;
    Ok(forms)
}

/// Complains when what is announced cannot stand in what is left of the file.
fn announce(tokens: &Tokens<'_>, numbers: usize, what: &str) -> Result<()> {
    if numbers.saturating_mul(LEAST_BYTES) <= tokens.bytes_left() + 1 {
        return Ok(());
    }
    Err(tokens.error(format!("the file is too short for {what}")))
}

/// Writes polynomial surfaces.
///
/// Errors: `Shape` for a form that is no surface of at most three dimensions; `Domain` for a
/// rational one: the format has no weights. Of a spline its pieces are written.
pub fn write(forms: &[Named]) -> Result<Vec<u8>> {
    let pieces = forms.iter().map(|named| named.shape.pieces()).collect::<Result<Vec<_>>>()?;
    let pieces = pieces.concat();
    let mut text = format!("{}\n", pieces.len());
    for form in &pieces {
        if form.axes() != 2 || form.ambient() > 3 {
            let received = format!("a {} in dimension {}", form.kind(), form.ambient());
            return Err(Error::shape("form", received, "a surface in space: .bpt holds no other"));
        }
        if form.is_rational() {
            let received = format!("a rational {}", form.kind());
            return Err(Error::domain("form", received, "equal weights: .bpt has none"));
        }
        let degrees = form.degrees();
        let _ = writeln!(text, "{} {}", degrees[0], degrees[1]);
        for [x, y, z] in pforms_mesh::embed(form)?.points()?.as_chunks::<3>().0 {
            let _ = writeln!(text, "{x:?} {y:?} {z:?}");
        }
    }
    Ok(text.into_bytes())
}
