//! Poles of literal cells, dragged: the text of the cell follows.

use pforms_catalogue::{Arithmetic, Value};
use pforms_formula::{Address, Content, point_spans, replace_point};
use pforms_kernel::{Error, Result};

use crate::Sheet;

/// Roundings by which a coordinate that nobody moved may differ from its text, since it was
/// multiplied by its weight and divided again.
const UNMOVED: f64 = 4.0 * f64::EPSILON;

impl<S: Arithmetic> Sheet<S> {
    /// The indices of the poles that can be moved: the points a literal cell is made of.
    ///
    /// None for a formula, whose poles follow from others, and for a literal with errors.
    pub fn editable_poles(&self, at: Address) -> Vec<Vec<usize>> {
        match self.cells.get(&at).map(|cell| &cell.content) {
            Some(Content::Literal(tree)) if !tree.has_errors() => {
                point_spans(tree).into_iter().map(|(index, _)| index).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Moves one pole of a literal cell to euclidean coordinates (a direction, if its weight is 0).
    ///
    /// Only the coordinates that change are written anew; weights, spacing and expressions such as
    /// `sqrt(2)/2` in the others stay. Within a gesture, all moves are one step.
    ///
    /// Errors: `Shape` when the cell has no such pole or it has another dimension, `Domain` when a
    /// coordinate is not finite.
    pub fn move_pole(&mut self, at: Address, index: &[usize], coordinates: &[f64]) -> Result<()> {
        if let Some(bad) = coordinates.iter().find(|x| !x.is_finite()) {
            return Err(Error::domain("coordinates", bad, "finite numbers"));
        }
        if !self.editable_poles(at).iter().any(|editable| editable == index) {
            let received = format!("{index:?} of {at}");
            return Err(Error::shape("pole", received, "a pole typed in a cell"));
        }
        let before = self.coordinates(at, index);
        let moved: Vec<Option<f64>> = coordinates
            .iter()
            .enumerate()
            .map(|(k, new)| {
                let old = before.as_ref().and_then(|before| before.get(k));
                let same = old.is_some_and(|old| (new - old).abs() <= UNMOVED * old.abs());
                (!same).then_some(*new)
            })
            .collect();
        let text = replace_point(self.document.text(at), index, &moved).ok_or_else(|| {
            let received = format!("{} coordinates", coordinates.len());
            Error::shape("coordinates", received, "as many as the pole has")
        })?;
        self.set(at, &text);
        Ok(())
    }

    /// Where the pole is, if the cell is computed.
    fn coordinates(&self, at: Address, index: &[usize]) -> Option<Vec<f64>> {
        let Value::Form(form) = self.value(at) else { return None };
        if self.dirty.contains(&at) {
            return None;
        }
        let (weight, point) = form.pole(index).ok()?.split_last()?;
        let weight = if weight.is_zero() { 1.0 } else { weight.to_f64() };
        Some(point.iter().map(|x| x.to_f64() / weight).collect())
    }
}
