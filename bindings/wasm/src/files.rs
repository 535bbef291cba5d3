//! Forms read from files into cells, and drawn cells written to files.

use pforms_formats::{Format, Named, obj, write_scene};
use pforms_formula::{Address, Range, decimal};
use pforms_kernel::{Form, Result};
use pforms_operators::Shape;
use pforms_scene::{Camera, Mode, Scene, Shapes, Style};
use pforms_sheet::{Settings, Sheet};

use crate::{Answer, Engine, Problem};

/// A file to be handed out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exported {
    /// Its name.
    pub name: String,
    /// Its contents.
    pub bytes: Vec<u8>,
}

impl Engine {
    /// Replaces the sheet by the forms of a file (`.bpt`, `.json`), each in a cell of its own.
    ///
    /// Several forms are drawn together by one more cell, so that common edges have no cracks.
    pub fn import(&mut self, name: &str, bytes: &[u8]) -> Answer {
        let forms = pforms_formats::read(name, bytes).map_err(|error| self.refusal(error))?;
        if forms.is_empty() {
            let (en, fr) =
                (format!("{name} holds no form"), format!("{name} ne contient aucune forme"));
            return Err(Problem::new(self.language, en, fr));
        }
        let sheet = sheet_of(name, &forms).map_err(|error| self.refusal(error))?;
        Ok(self.replace(sheet))
    }

    /// The drawn cells in a format (`glb`, `obj`, `stl`, `pov`), in files named `stem`.
    pub fn export(&self, format: &str, stem: &str) -> Answer<Vec<Exported>> {
        let files = || {
            let format = Format::of_name(&format!("{stem}.{format}"))?;
            let camera = self.camera.as_ref().unwrap_or(self.sheet.document().camera());
            let scene = scene_of(&self.sheet, camera)?;
            exported(format, stem, &scene)
        };
        files().map_err(|error| self.refusal(error))
    }
}

/// Every drawn cell that has a value, in the order of the sheet.
fn scene_of(sheet: &Sheet, camera: &Settings) -> Result<Scene> {
    let camera = Camera::from_settings(camera)?;
    let mut scene = Scene { camera, ..Scene::default() };
    for (at, settings) in sheet.document().shown() {
        if let Ok(shapes) = Shapes::in_value(sheet.value(at)) {
            scene.add(&at.to_string(), &shapes, Style::from_settings(settings)?)?;
        }
    }
    Ok(scene)
}

fn exported(format: Format, stem: &str, scene: &Scene) -> Result<Vec<Exported>> {
    let file = |ending: &str, bytes| Exported { name: format!("{stem}.{ending}"), bytes };
    if format != Format::Obj {
        return Ok(vec![file(format.extension(), write_scene(format, scene)?)]);
    }
    let library = format!("{stem}.mtl");
    Ok(vec![file("obj", obj::write(scene, Some(&library))?), file("mtl", obj::materials(scene))])
}

/// A sheet with each form in column A, and what draws them all in B1.
fn sheet_of(name: &str, forms: &[Named]) -> Result<Sheet> {
    let mut document: Sheet = Sheet::new();
    let cells: Vec<Address> =
        (1..).map_while(|row| Address::new(1, row)).take(forms.len()).collect();
    for (at, named) in cells.iter().zip(forms) {
        document.set(*at, &literal(&named.shape));
    }
    if Format::of_name(name) == Ok(Format::Bpt) {
        // Patches of this format describe things that stand on the axis z.
        let standing = [("view", "PERSPECTIVE"), ("up", "z")];
        document.set_camera(
            standing.map(|(key, value)| (key.to_owned(), value.into())).into_iter().collect(),
        )?;
    }
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    document.set_title("", stem)?;
    if let ([first, .., last], Some(all)) = (cells.as_slice(), Address::new(2, 1)) {
        document.set(all, &format!("={}", Range { first: (*first).into(), last: (*last).into() }));
        document.set_show(all, Some(Settings::new()))?;
    } else if let ([only], [named]) = (cells.as_slice(), forms) {
        document.set_show(*only, Some(usual(named.net())))?;
    }
    Sheet::open(&document.save())
}

fn usual(form: &Form) -> Settings {
    let style =
        Style { draw: Mode::suiting(form).iter().take(1).copied().collect(), ..Style::default() };
    let mode = serde_json::to_value(&style.draw).unwrap_or_default();
    std::iter::once(("draw".to_owned(), mode)).collect()
}

/// The form as the text of a cell: nested lists of points.
fn literal(shape: &Shape) -> String {
    match shape {
        Shape::Form(form) => net(form),
        Shape::Spline(spline) => {
            let list = |numbers: &[f64]| {
                let numbers: Vec<String> = numbers.iter().map(|x| decimal(*x)).collect();
                format!("[{}]", numbers.join(", "))
            };
            let poles = spline.net();
            let weights = match poles.uniform_weight() {
                Some(weight) => decimal(*weight),
                None => list(&poles.weights()),
            };
            let knots: Vec<String> =
                spline.knots().iter().map(|knots| list(knots.as_slice())).collect();
            format!("=NURBS({}, {weights}, [{}])", nested(poles, coordinates), knots.join(", "))
        }
    }
}

/// The poles as nested lists of points with their weights.
fn net(form: &Form) -> String {
    nested(form, point)
}

fn nested(form: &Form, point: impl Fn(&[f64]) -> String) -> String {
    let mut points: Vec<String> = form.homogeneous().chunks(form.width()).map(point).collect();
    for order in form.orders().iter().rev() {
        points = points.chunks(*order).map(|row| format!("[{}]", row.join(", "))).collect();
    }
    points.concat()
}

fn point(pole: &[f64]) -> String {
    let plain = coordinates(pole);
    match pole.last() {
        None | Some(1.0) => plain,
        Some(weight) => {
            let inside = plain.trim_end_matches(')').trim_end_matches(',');
            format!("{inside}; {})", decimal(*weight))
        }
    }
}

/// The point without its weight; of weight 0 the direction.
fn coordinates(pole: &[f64]) -> String {
    let Some((weight, coordinates)) = pole.split_last() else { return String::new() };
    let divisor = if *weight == 0.0 { 1.0 } else { *weight };
    let numbers: Vec<String> = coordinates.iter().map(|x| decimal(x / divisor)).collect();
    let tail = if numbers.len() == 1 { "," } else { "" };
    format!("({}{tail})", numbers.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_form_is_written_as_it_is_typed() {
        let form = Form::from_points(
            &[2, 2],
            2,
            &[0., 0., 1., 0., 0., 1., 1., 1.5],
            Some(&[1., 1., 0.5, 1.]),
        );
        assert_eq!(net(&form.unwrap()), "[[(0, 0), (1, 0)], [(0, 1; 0.5), (1, 1.5)]]");
        let point = Form::from_homogeneous(&[], 1, vec![2.0, 1.0]).unwrap();
        assert_eq!(net(&point), "(2,)");
    }

    #[test]
    fn patches_come_in_and_a_drawing_goes_out() {
        let bytes = b"2\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n1 1\n1 0 0\n2 0 0\n1 1 0\n2 1 1\n";
        let mut engine = Engine::new();
        let update = engine.import("Two.bpt", bytes).unwrap();
        assert!(update.whole);
        assert_eq!(update.title, "Two");
        assert_eq!(update.camera.unwrap()["up"], "z");
        assert_eq!(update.drawings.len(), 1, "{:?}", update.undrawn);
        let glb = engine.export("glb", "two").unwrap();
        assert_eq!(&glb[0].bytes[..4], b"glTF");
        let obj = engine.export("obj", "two").unwrap();
        assert_eq!(
            obj.iter().map(|file| file.name.as_str()).collect::<Vec<_>>(),
            ["two.obj", "two.mtl"]
        );
        assert!(engine.export("exe", "two").is_err());
    }

    #[test]
    fn exact_forms_come_in_from_json() {
        let form: Named =
            Form::from_points(&[2], 1, &[0.1, 2.0], Some(&[1.0, 0.5])).unwrap().into();
        let bytes = pforms_formats::write_forms(Format::Json, &[form]).unwrap();
        let mut engine = Engine::new();
        let update = engine.import("line.json", &bytes).unwrap();
        assert_eq!(update.cells[0].info.source, "[(0.1,), (2; 0.5)]");
        assert_eq!(update.drawings.len(), 1);
    }

    #[test]
    fn a_damaged_file_changes_nothing() {
        let mut engine = Engine::new();
        engine.set(&[("A1".into(), "1".into())]).unwrap();
        let problem = engine.import("x.bpt", b"32 3 3 0 0").unwrap_err();
        assert!(!problem.message.is_empty());
        assert_eq!(engine.sheet.document().text("A1".parse().unwrap()), "1");
    }
}
