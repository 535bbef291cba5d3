//! The forms and meshes in a value.

use pforms_catalogue::{Arithmetic, Value};
use pforms_kernel::{Error, Form, Result, Scalar};
use pforms_mesh::Mesh;
use pforms_operators::{Poles, Shape};

/// The forms, splines and meshes of a value that can be drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shapes {
    shapes: Vec<Shape>,
    meshes: Vec<Mesh>,
}

impl Shapes {
    /// Forms.
    pub fn of(forms: Vec<Form>) -> Self {
        Self::of_all(forms.into_iter().map(Shape::Form).collect())
    }

    /// Forms and splines.
    pub fn of_all(shapes: Vec<Shape>) -> Self {
        Self { shapes, meshes: Vec::new() }
    }

    /// The same, and these meshes.
    #[must_use]
    pub fn with(mut self, meshes: Vec<Mesh>) -> Self {
        self.meshes.extend(meshes);
        self
    }

    /// All forms and meshes in a value: its own, those of a list and of the lists inside it.
    ///
    /// Numbers, texts and the like in a list are passed over.
    ///
    /// Errors: `Shape` when the value holds no form and no mesh; `Limit` when an immersed form is too
    /// large to be expanded.
    pub fn in_value<S: Arithmetic>(value: &Value<S>) -> Result<Self> {
        let mut shapes = Self::default();
        shapes.gather(value)?;
        if shapes.shapes.is_empty() && shapes.meshes.is_empty() {
            let kind = value.kind(pforms_catalogue::Language::English);
            return Err(Error::shape("value", format!("a value of kind {kind}"), "a form to draw"));
        }
        Ok(shapes)
    }

    fn gather<S: Arithmetic>(&mut self, value: &Value<S>) -> Result<()> {
        match value {
            Value::Form(form) => self.shapes.push(floating(form)?.into()),
            Value::Immersed(lazy) => self.shapes.push(floating(&lazy.expand()?)?.into()),
            Value::Spline(spline) => self.shapes.push(spline.map_scalar(S::to_f64)?.into()),
            Value::Mesh(mesh) => self.meshes.push(mesh.clone()),
            Value::List(items) => items.iter().try_for_each(|item| self.gather(item))?,
            Value::Empty
            | Value::Number(_)
            | Value::Boolean(_)
            | Value::Text(_)
            | Value::Record(_)
            | Value::Error(_) => {}
        }
        Ok(())
    }

    /// The forms and splines.
    pub fn as_slice(&self) -> &[Shape] {
        &self.shapes
    }

    /// The meshes and clouds.
    pub fn meshes(&self) -> &[Mesh] {
        &self.meshes
    }

    /// What carries the poles: forms, and the nets of splines.
    pub fn nets(&self) -> Vec<&Form> {
        self.shapes.iter().map(Poles::net).collect()
    }

    /// The forms, and the pieces of the splines.
    ///
    /// Errors: `Limit`.
    pub fn pieces(&self) -> Result<Vec<Form>> {
        Ok(self.shapes.iter().map(Shape::pieces).collect::<Result<Vec<_>>>()?.concat())
    }
}

fn floating<S: Scalar>(form: &Form<S>) -> Result<Form> {
    form.map_scalar(S::to_f64)
}
