//! Styles as the page edits them.

use pforms_catalogue::Value;
use pforms_kernel::{Form, Result};
use pforms_scene::{Mode, Style};
use pforms_sheet::Settings;

/// The ways a value can be drawn, the most usual one first; of a list, those of its items together.
pub(crate) fn modes(value: &Value) -> Vec<Mode> {
    let mut found = Vec::new();
    gather(value, &mut found);
    found
}

fn gather(value: &Value, found: &mut Vec<Mode>) {
    match value {
        Value::Form(form) => add(form, found),
        Value::Spline(pieces) => add(pieces.net(), found),
        // An inner form has the axes of the composition.
        Value::Immersed(lazy) => add(lazy.inner(), found),
        Value::Mesh(mesh) => add_all(Mode::suiting_mesh(mesh), found),
        Value::List(items) => items.iter().for_each(|item| gather(item, found)),
        _ => {}
    }
}

fn add(form: &Form, found: &mut Vec<Mode>) {
    add_all(Mode::suiting(form), found);
}

fn add_all(modes: &[Mode], found: &mut Vec<Mode>) {
    for mode in modes {
        if !found.contains(mode) {
            found.push(*mode);
        }
    }
}

/// The style with every key, as a panel shows it; the usual style for settings that are no style.
pub(crate) fn complete(settings: &Settings, value: &Value) -> Settings {
    let mut style = Style::from_settings(settings).unwrap_or_default();
    if style.draw.is_empty() {
        style.draw = modes(value).into_iter().take(1).collect();
    }
    table(&style)
}

/// The settings a file holds of a style: what is usual is left out, the ways of drawing and the colour are not.
pub(crate) fn tidy(settings: &Settings) -> Result<Settings> {
    let style = Style::from_settings(settings)?;
    let usual = table(&Style::default());
    let kept = |key: &str| key == "draw" || key == "color";
    Ok(table(&style)
        .into_iter()
        .filter(|(key, item)| kept(key) || usual.get(key) != Some(item))
        .collect())
}

fn table(style: &Style) -> Settings {
    match serde_json::to_value(style) {
        Ok(serde_json::Value::Object(table)) => table,
        _ => Settings::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_holds_only_what_is_unusual() {
        let table = serde_json::json!({
            "draw": ["curve"], "color": "#f2c14e", "opacity": 1, "fineness": 6, "radius": 0.01, "count": 5,
        });
        let tidied = tidy(table.as_object().unwrap()).unwrap();
        let keys: Vec<&str> = tidied.keys().map(String::as_str).collect();
        assert_eq!(keys.len(), 3, "{keys:?}");
        assert_eq!(tidied["fineness"], 6);
        let full = complete(&tidied, &Value::Empty);
        assert_eq!((full["count"].as_u64(), full["radius"].as_f64()), (Some(5), Some(0.01)));
    }
}
