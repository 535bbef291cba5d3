//! What has poles: a form, or a spline.

use pforms_kernel::{Form, Result, Scalar};

use super::Spline;

/// A thing made of poles. Operators that act on each pole alone, such as affine maps, take any.
pub trait Poles<S: Scalar>: Sized {
    /// The poles.
    fn net(&self) -> &Form<S>;

    /// The same thing with other poles, as many along each axis.
    ///
    /// Errors: `Shape` when their number differs.
    fn with_net(&self, net: Form<S>) -> Result<Self>;
}

impl<S: Scalar> Poles<S> for Form<S> {
    fn net(&self) -> &Form<S> {
        self
    }

    fn with_net(&self, net: Form<S>) -> Result<Self> {
        net.reshape(self.orders())
    }
}

impl<S: Scalar> Poles<S> for Spline<S> {
    fn net(&self) -> &Form<S> {
        Self::net(self)
    }

    fn with_net(&self, net: Form<S>) -> Result<Self> {
        Self::on(net, self.knots().to_vec())
    }
}

/// A form or a spline, when either will do.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape<S = f64> {
    /// One form, on the window from 0 to 1.
    Form(Form<S>),
    /// Forms end to end.
    Spline(Spline<S>),
}

impl<S: Scalar> Shape<S> {
    /// As a spline; a form is one of a single piece.
    pub fn into_spline(self) -> Spline<S> {
        match self {
            Self::Form(form) => form.into(),
            Self::Spline(spline) => spline,
        }
    }

    /// Its pieces, the last axis fastest; a form is its own.
    ///
    /// Errors: `Limit`.
    pub fn pieces(&self) -> Result<Vec<Form<S>>> {
        match self {
            Self::Form(form) => Ok(vec![form.clone()]),
            Self::Spline(spline) => spline.pieces(),
        }
    }
}

impl<S: Scalar> From<Spline<S>> for Shape<S> {
    /// A spline without axes is a point, which is a form.
    fn from(spline: Spline<S>) -> Self {
        if spline.axes() == 0 { Self::Form(spline.net().clone()) } else { Self::Spline(spline) }
    }
}

impl<S: Scalar> Poles<S> for Shape<S> {
    fn net(&self) -> &Form<S> {
        match self {
            Self::Form(form) => form,
            Self::Spline(spline) => spline.net(),
        }
    }

    fn with_net(&self, net: Form<S>) -> Result<Self> {
        match self {
            Self::Form(form) => form.with_net(net).map(Self::Form),
            Self::Spline(spline) => spline.with_net(net).map(Self::Spline),
        }
    }
}

impl<S> From<Form<S>> for Shape<S> {
    fn from(form: Form<S>) -> Self {
        Self::Form(form)
    }
}
