//! Values written in full, for people to read.

use pforms_catalogue::{Arithmetic, Failure, Language, Value};
use pforms_kernel::Form;
use pforms_operators::Knots;

use super::print;

/// The value in lines: short if it has no poles, else one pole a line with its index and weight.
pub(crate) fn lines<S: Arithmetic>(value: &Value<S>, language: Language) -> Vec<String> {
    match value {
        Value::Form(form) if form.axes() > 0 => with_poles(value, form, language),
        Value::Spline(spline) => {
            let mut all = with_poles(value, spline.net(), language);
            all.splice(1..1, spline.knots().iter().map(|knots| in_words(knots, language)));
            all
        }
        Value::Text(text) => text.lines().map(str::to_owned).collect(),
        Value::List(items) => {
            let mut all = vec![value.kind(language)];
            for (index, item) in items.iter().enumerate() {
                let lines = lines(item, language);
                all.extend(lines.into_iter().enumerate().map(|(line, text)| {
                    if line == 0 { format!("[{index}] {text}") } else { format!("    {text}") }
                }));
            }
            all
        }
        Value::Record(entries) => entries
            .iter()
            .map(|(name, value)| format!("{}: {}", name.get(language), value.display(language)))
            .collect(),
        other => vec![other.display(language)],
    }
}

/// The degree and the knots of an axis.
fn in_words<S: Arithmetic>(knots: &Knots<S>, language: Language) -> String {
    let list: Vec<String> = knots.as_slice().iter().map(S::write).collect();
    let (degree, list) = (knots.degree(), list.join(" "));
    match language {
        Language::English => format!("degree {degree}, knots {list}"),
        Language::French => format!("degré {degree}, nœuds {list}"),
    }
}

/// What went wrong, where it started, and what to do.
pub(crate) fn complaint(failure: &Failure, language: Language) -> String {
    let origin = failure.origin().map_or(String::new(), |cell| format!("{cell}: "));
    let hint = failure.hint(language).map_or(String::new(), |hint| format!(" ({hint})"));
    format!("{origin}{}{hint}", failure.message(language))
}

fn with_poles<S: Arithmetic>(value: &Value<S>, form: &Form<S>, language: Language) -> Vec<String> {
    let mut index = vec![0; form.axes()];
    let mut rows = Vec::with_capacity(form.pole_count());
    for pole in form.homogeneous().chunks_exact(form.width()) {
        let (coordinates, weight) = pole.split_at(form.ambient());
        let mut row = vec![format!("{index:?}")];
        row.extend(coordinates.iter().map(|x| {
            if weight[0].is_zero() { x.write() } else { (x.clone() / weight[0].clone()).write() }
        }));
        row.push(format!("; {}", weight[0].write()));
        rows.push(row);
        advance(&mut index, form.orders());
    }
    let mut lines = vec![value.display(language)];
    lines.extend(print::table(&rows));
    lines
}

/// The next index in C order.
fn advance(index: &mut [usize], orders: &[usize]) {
    for (i, order) in index.iter_mut().zip(orders).rev() {
        *i += 1;
        if *i < *order {
            return;
        }
        *i = 0;
    }
}
