//! A nested list of points is a net of poles.

use pforms_kernel::{Error, Form, limit};

use crate::{Arithmetic, Failure, Value};

/// The form whose poles are the points of a nested list.
///
/// Errors: `Shape` when rows differ in length, depth or dimension, or when an item is no point.
pub(crate) fn form_of_list<S: Arithmetic>(items: &[Value<S>]) -> Result<Form<S>, Failure> {
    let mut orders = Vec::new();
    measure(items, &mut orders);
    let mut net = Net { orders, ambient: None, poles: Vec::new() };
    net.gather(items, 0)?;
    let ambient = net.ambient.ok_or_else(|| not_points("an empty list", "une liste vide"))?;
    limit::check::<S>("the form", &net.orders, ambient + 1)?;
    Ok(Form::from_homogeneous(&net.orders, ambient, net.poles)?)
}

/// The lengths met on the way to the first point.
fn measure<S>(items: &[Value<S>], orders: &mut Vec<usize>) {
    orders.push(items.len());
    if let Some(Value::List(first)) = items.first() {
        measure(first, orders);
    }
}

struct Net<S> {
    orders: Vec<usize>,
    ambient: Option<usize>,
    poles: Vec<S>,
}

impl<S: Arithmetic> Net<S> {
    fn gather(&mut self, items: &[Value<S>], level: usize) -> Result<(), Failure> {
        for item in items {
            match item {
                Value::List(row) if level + 1 < self.orders.len() => {
                    if row.len() != self.orders[level + 1] {
                        return Err(ragged(items));
                    }
                    self.gather(row, level + 1)?;
                }
                Value::Form(point) if point.axes() == 0 && level + 1 == self.orders.len() => {
                    self.push(point)?;
                }
                Value::Error(failure) => return Err(failure.clone()),
                Value::Form(form) if form.axes() > 0 => return Err(a_form_inside(form)),
                Value::Form(_) | Value::List(_) => return Err(ragged(items)),
                other => return Err(foreign(other)),
            }
        }
        Ok(())
    }

    fn push(&mut self, point: &Form<S>) -> Result<(), Failure> {
        let ambient = *self.ambient.get_or_insert(point.ambient());
        if ambient != point.ambient() {
            let received = format!("{ambient}D, {}D", point.ambient());
            let error = Error::shape("list", &received, "points of one dimension");
            let french = format!("liste : reçu {received}, attendu des points de même dimension");
            return Err(Failure::of(error, french));
        }
        self.poles.extend_from_slice(point.homogeneous());
        Ok(())
    }
}

fn ragged<S>(items: &[Value<S>]) -> Failure {
    let length = |item: &Value<S>| match item {
        Value::List(row) => row.len().to_string(),
        _ => "·".to_owned(),
    };
    let mut lengths: Vec<String> = items.iter().take(12).map(length).collect();
    if items.len() > 12 {
        lengths.push("…".to_owned());
    }
    let lengths = lengths.join(", ");
    let error = Error::shape("list", format!("rows of {lengths}"), "rows of one length");
    let french = format!("liste : reçu des rangées de {lengths}, attendu des rangées égales");
    Failure::of(error, french)
}

fn a_form_inside<S: Arithmetic>(form: &Form<S>) -> Failure {
    let kind = form.kind().to_string();
    not_points(&kind, &kind).with_hint("MIR(…) stacks forms into one", "MIR(…) empile des formes")
}

fn foreign<S: Arithmetic>(value: &Value<S>) -> Failure {
    let failure =
        not_points(&value.said(crate::Language::English), &value.said(crate::Language::French));
    match value {
        Value::Number(_) => failure.with_hint(
            "a one-dimensional point is written (x,)",
            "un point à une dimension s'écrit (x,)",
        ),
        _ => failure,
    }
}

fn not_points(en: &str, fr: &str) -> Failure {
    let error = Error::shape("list", en, "points");
    Failure::of(error, format!("liste : reçu {fr}, attendu des points"))
}
