//! Everything that is drawn, and from where.

use pforms_kernel::{Form, Result};

use crate::{Bounds, Camera, Part, Placement, Shapes, Style, draw};

/// A drawn value.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// A cell, or the name of a form.
    pub name: String,
    /// How it is drawn.
    pub style: Style,
    /// The forms themselves, splines in pieces, for pictures that need no triangles; none where
    /// there are meshes among them.
    pub forms: Vec<Form>,
    /// What it consists of.
    pub parts: Vec<Part>,
}

/// Everything that is drawn, and from where.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// The drawn values, in order.
    pub items: Vec<Item>,
    /// Where they are seen from.
    pub camera: Camera,
    /// Are the axes of space drawn in pictures?
    pub axes: bool,
}

impl Scene {
    /// Draws some forms and adds them under a name.
    ///
    /// Errors: those of [`draw`].
    pub fn add(&mut self, name: &str, shapes: &Shapes, style: Style) -> Result<()> {
        let parts = draw(shapes, &style)?;
        let forms = if shapes.meshes().is_empty() { shapes.pieces()? } else { Vec::new() };
        self.items.push(Item { name: name.to_owned(), style, forms, parts });
        Ok(())
    }

    /// The box round everything drawn.
    pub fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::default();
        for part in self.items.iter().flat_map(|item| &item.parts) {
            bounds.join(&part.bounds());
        }
        bounds
    }

    /// The camera with what it leaves open fitted to what is drawn.
    pub fn placement(&self) -> Placement {
        self.camera.placed(&self.bounds())
    }
}
