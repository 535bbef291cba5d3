//! Values and styles to parts; cameras.
#![allow(missing_docs, clippy::unwrap_used)]

use pforms_catalogue::Value;
use pforms_kernel::{Form, Rational, Scalar};
use pforms_mesh::vector::{dot, norm, subtract, unit};
use pforms_scene::{
    Bounds, Buffers, Camera, Levels, Mode, Part, Projection, Scene, Shading, Shapes, Style, Up,
    View, draw,
};
use serde_json::{Map, json};

fn settings(value: &serde_json::Value) -> Map<String, serde_json::Value> {
    value.as_object().unwrap().clone()
}

fn cube() -> Form {
    let corners: Vec<f64> =
        (0..8).flat_map(|k| [k >> 2 & 1, k >> 1 & 1, k & 1].map(f64::from)).collect();
    Form::from_points(&[2, 2, 2], 3, &corners, None).unwrap()
}

fn facet() -> Form {
    let points = [0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 0.];
    Form::from_points(&[2, 2], 3, &points, None).unwrap()
}

#[allow(clippy::needless_pass_by_value)]
fn drawn(form: Form, table: serde_json::Value) -> Vec<Part> {
    draw(&Shapes::of(vec![form]), &Style::from_settings(&settings(&table)).unwrap()).unwrap()
}

#[test]
fn a_style_is_read_with_defaults_and_without_surprises() {
    assert_eq!(Style::from_settings(&Map::new()).unwrap(), Style::default());
    let table = json!({
        "draw": ["surface", "net"], "shading": "flat", "color": "#ff0000", "opacity": 0.5,
        "fineness": [0, 6], "radius": 0.1, "count": 3, "axis": 1, "length": -0.2,
    });
    let style = Style::from_settings(&settings(&table)).unwrap();
    assert_eq!(style.shading, Shading::Flat);
    assert_eq!(style.fineness, Levels::Each(vec![0, 6]));
    let again = serde_json::to_value(&style).unwrap();
    assert_eq!(again, table, "written as it was read");
    for (wrong, family) in [
        (json!({"colour": "#ff0000"}), "Format"),
        (json!({"color": "red"}), "Format"),
        (json!({"draw": ["blob"]}), "Format"),
        (json!({"draw": "surface"}), "Format"),
        (json!({"fineness": -1}), "Format"),
        (json!({"fineness": 2.5}), "Format"),
        (json!({"count": 0}), "Domain"),
        (json!({"opacity": 1.5}), "Domain"),
        (json!({"radius": 0}), "Domain"),
    ] {
        let error = Style::from_settings(&settings(&wrong)).unwrap_err();
        assert_eq!(error.family(), family, "{wrong}: {error}");
    }
    let error = Style::from_settings(&settings(&json!({"colour": "x"}))).unwrap_err().to_string();
    assert!(error.contains("`colour`") && error.contains("`color`"), "{error}");
}

#[test]
fn every_way_of_drawing_makes_its_parts() {
    let kinds = |parts: &[Part]| -> Vec<(&str, usize)> {
        parts
            .iter()
            .map(|part| match part {
                Part::Points { positions, .. } => ("points", positions.len()),
                Part::Lines { polylines, .. } => ("lines", polylines.len()),
                Part::Triangles(mesh) => ("triangles", mesh.indices.len()),
            })
            .collect()
    };
    let of = |form: Form, mode: &str| {
        kinds(&drawn(form, json!({"draw": [mode], "fineness": 1, "count": 3})))
    };
    assert_eq!(of(cube(), "points"), [("points", 27)]);
    assert_eq!(of(cube(), "envelope"), [("triangles", 6 * 8)]);
    assert_eq!(of(cube(), "sheets"), [("triangles", 3 * 8)]);
    assert_eq!(of(cube(), "fibres"), [("lines", 9)]);
    assert_eq!(of(cube(), "net"), [("lines", 12), ("points", 8)]);
    assert_eq!(of(cube(), "poles"), [("points", 8)]);
    assert_eq!(of(facet(), "surface"), [("triangles", 8)]);
    assert_eq!(of(facet(), "normals"), [("lines", 9)]);
    assert_eq!(of(facet(), "fibres"), [("lines", 3)]);
    let usual = drawn(facet(), json!({}));
    assert_eq!(kinds(&usual), [("triangles", 512)]);
    let flat = drawn(facet(), json!({"shading": "flat", "fineness": 0}));
    let Part::Triangles(mesh) = &flat[0] else { panic!() };
    assert_eq!(mesh.positions.len(), 6);
}

#[test]
fn fineness_per_axis_follows_the_axes_that_are_left() {
    let table = json!({"draw": ["sheets"], "fineness": [3, 0, 1], "count": 1, "axis": 0});
    let Part::Triangles(mesh) = &drawn(cube(), table)[0] else { panic!() };
    assert_eq!(mesh.indices.len(), 4);
    let table = json!({"draw": ["fibres"], "fineness": [3, 0, 1], "count": 1, "axis": 2});
    let Part::Lines { polylines, .. } = &drawn(cube(), table)[0] else { panic!() };
    assert_eq!(polylines[0].points.len(), 3);
}

#[test]
fn what_does_not_suit_is_refused_with_what_does() {
    let style = Style { draw: vec![Mode::Envelope], ..Style::default() };
    let error = draw(&Shapes::of(vec![facet()]), &style).unwrap_err();
    assert_eq!(error.family(), "Shape");
    let text = error.to_string();
    assert!(
        text.contains("envelope") && text.contains("pS22") && text.contains("surface"),
        "{text}"
    );
}

#[test]
fn values_hold_forms_at_any_depth() {
    let form: Value = facet().into();
    let list = Value::list(vec![Value::Number(1.0), form.clone(), Value::list(vec![form])]);
    assert_eq!(Shapes::in_value(&list).unwrap().as_slice().len(), 2);
    for empty in [Value::Number(1.0), Value::Empty, Value::list(vec![])] {
        assert_eq!(Shapes::in_value::<f64>(&empty).unwrap_err().family(), "Shape");
    }
    let third = Form::point(&[Rational::ratio(1, 3)]).unwrap();
    let shapes = Shapes::in_value(&Value::Form(third)).unwrap();
    assert_eq!(shapes.nets()[0].points().unwrap(), [1.0 / 3.0]);
}

#[test]
fn a_subdivided_form_shows_its_pieces_and_its_refined_net() {
    let arc = Form::from_points(&[3], 2, &[0., 0., 1., 2., 2., 0.], None).unwrap();
    let halves = pforms_operators::subdivide(&arc, &[1]).unwrap();
    let shapes = Shapes::in_value(&Value::Spline(halves)).unwrap();
    assert_eq!((shapes.pieces().unwrap().len(), shapes.nets().len()), (2, 1));
    let style = Style { draw: vec![Mode::Curve, Mode::Poles], ..Style::default() };
    let parts = draw(&shapes, &style).unwrap();
    let Part::Points { positions, .. } = &parts[1] else { panic!() };
    assert_eq!(positions.len(), 5);
}

#[test]
fn buffers_hold_the_same_in_single_precision() {
    let table = json!({"draw": ["curve"], "fineness": 1, "radius": 0.5});
    let line = Form::from_points(&[2], 1, &[0.0, 1.0], None).unwrap();
    let buffers = drawn(line, table).swap_remove(0).into_buffers();
    let positions = vec![0., 0., 0., 0.5, 0., 0., 1., 0., 0.];
    assert_eq!(buffers, Buffers::Lines { positions, starts: vec![0, 3], radius: 0.5 });
    let Buffers::Triangles { positions, normals, indices } =
        drawn(facet(), json!({})).swap_remove(0).into_buffers()
    else {
        panic!()
    };
    assert_eq!((positions.len(), normals.len(), indices.len()), (867, 867, 1536));
}

#[test]
fn a_camera_fits_what_it_leaves_open() {
    let bounds = Bounds::of(&[[0.0; 3], [2.0, 4.0, 4.0]]);
    let views = [View::Ox, View::Oy, View::Oz, View::Axo, View::Perspective];
    for (view, up) in views.into_iter().flat_map(|view| [(view, Up::Y), (view, Up::Z)]) {
        let placement = Camera { view, up, ..Camera::default() }.placed(&bounds);
        assert_eq!(placement.target, [1.0, 2.0, 2.0]);
        let out = subtract(placement.position, placement.target);
        assert!(norm(out) > 3.0, "the eye is outside");
        let (way, expected) = (unit(out).unwrap(), unit(view.direction(up)).unwrap());
        assert!((dot(way, expected) - 1.0).abs() < 1e-12);
        assert!(dot(way, placement.up).abs() < 0.99, "{view:?} has an upright");
    }
    let level = |up| Camera { up, ..Camera::default() }.placed(&bounds).up;
    assert_eq!((level(Up::Y), level(Up::Z)), ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]));
    let zoomed = Camera { zoom: Some(0.75), ..Camera::default() }.placed(&bounds);
    assert_eq!(zoomed.projection, Projection::Parallel { across: 1.0 / 0.75 });
}

#[test]
fn a_camera_is_read_without_surprises() {
    let table = json!({"view": "PERSPECTIVE", "position": [0.7, 1.3, -1.1], "target": [0, 0, 0]});
    let camera = Camera::from_settings(&settings(&table)).unwrap();
    assert_eq!(camera.placed(&Bounds::default()).position, [0.7, 1.3, -1.1]);
    for wrong in [
        json!({"view": "axo"}),
        json!({"position": [1, 2]}),
        json!({"angle": 3}),
        json!({"zoom": 0}),
    ] {
        assert!(Camera::from_settings(&settings(&wrong)).is_err(), "{wrong}");
    }
    assert_eq!(Camera::from_settings(&Map::new()).unwrap(), Camera::default());
}

#[test]
fn an_empty_scene_has_a_camera_too() {
    let placement = Scene::default().placement();
    assert!(placement.position.iter().copied().all(f64::is_finite));
}
