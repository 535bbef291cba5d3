//! Surfaces of IGES files against points and areas of OCCT.

use pforms_operators::Spline;
use pforms_testkit::models::{document, iges, text};
use pforms_testkit::numbers;
use serde_json::Value;

use crate::measure::total;
use crate::{gap, laws, scale, spline};

/// The B-spline faces of a file, each with the surface it lies on.
fn faces(file: &str) -> Vec<(Value, Spline)> {
    let expected = document("iges/expected.json");
    let model = expected["models"].as_array().unwrap().iter();
    let path = format!("iges/{file}");
    let model = model.clone().find(|model| model["file"] == path.as_str()).unwrap();
    let faces = model["faces"].as_array().unwrap().iter();
    let faces = faces.filter(|face| face["type"] == "Geom_BSplineSurface").cloned();
    let surfaces: Vec<Spline> =
        iges::read(&text(&path)).iter().map(spline).filter(|s| s.axes() == 2).collect();
    assert_eq!(faces.clone().count(), surfaces.len(), "{file}");
    faces.zip(surfaces).collect()
}

const FILES: [&str; 3] = ["aircraft-wing.igs", "blade-root.iges", "blade-tip.iges"];

#[test]
fn samples_are_those_of_occt() {
    for file in FILES {
        for (face, surface) in faces(file) {
            let whole = |key: &str| -> Vec<usize> {
                numbers(&face[key]).iter().map(|x| *x as usize).collect()
            };
            assert_eq!(surface.degrees(), whole("degrees"), "{file}");
            assert_eq!(surface.net().orders(), whole("poles"), "{file}");
            let range = numbers(&face["range"]);
            for sample in face["samples"].as_array().unwrap() {
                let share = numbers(&sample["frac"]);
                let at = |axis: usize| {
                    range[2 * axis] + share[axis] * (range[2 * axis + 1] - range[2 * axis])
                };
                let point = surface.at(&[at(0), at(1)]).unwrap();
                let gap = gap(&point, &numbers(&sample["point"]));
                assert!(gap <= 1e-14 * scale(&surface), "{file}: {gap}");
            }
        }
    }
}

/// Faces that are trimmed along the borders of their surface only: the area is that of the surface.
#[test]
fn areas_are_those_of_occt() {
    for file in FILES {
        for (face, surface) in faces(file) {
            let area = total(std::slice::from_ref(&surface), 12);
            let expected = face["area"].as_f64().unwrap();
            // OCCT integrates to 1e-7.
            assert!((area - expected).abs() <= 1e-8 * area, "{file}: {area} {expected}");
        }
    }
}

#[test]
fn laws_hold_on_every_surface() {
    for file in FILES {
        for (_, surface) in faces(file) {
            laws::hold(file, &surface);
        }
    }
}
