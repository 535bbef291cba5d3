//! Models measured with proved bounds, against what other programs integrate.

use std::f64::consts::PI;

use pforms_operators::{
    Folding, Measure, Shape, Spline, area, bounding_box, folds, measure, signed_area, volume,
};
use pforms_testkit::models::{bembel, document, gismo, mfem, text};

use crate::spline;

const ACCURACY: f64 = 1e-12;

fn shapes(splines: &[Spline]) -> Vec<Shape> {
    splines.iter().map(|spline| spline.clone().into()).collect()
}

/// Within its own bound and what is uncertain about the number it is compared with.
fn assert_is(found: Measure, expected: f64, uncertain: f64, what: &str) {
    let gap = (found.value - expected).abs();
    assert!(gap <= found.error + uncertain, "{what}: {found:?} {expected} ± {uncertain}");
    assert!(found.error <= ACCURACY * found.value, "{what}: {found:?}");
}

#[test]
fn meshes_of_mfem() {
    let expected = document("mfem/expected.json");
    for model in expected["models"].as_array().unwrap() {
        let file = model["file"].as_str().unwrap();
        let splines: Vec<Spline> =
            mfem::read(&text(&format!("mfem/{file}"))).iter().map(spline).collect();
        let found = measure(&shapes(&splines), ACCURACY).unwrap();
        let value = model["measure"].as_f64().unwrap();
        // MFEM's own sum carries some hundred roundings; its rules do not take all digits of the curves.
        let uncertain = model["measure_uncertainty"].as_f64().unwrap() + 2e-14 * value;
        assert_is(found, value, uncertain, file);
    }
}

#[test]
fn closed_forms() {
    let meshes = |file: &str| -> Vec<Shape> {
        let splines: Vec<Spline> =
            mfem::read(&text(&format!("mfem/{file}"))).iter().map(spline).collect();
        shapes(&splines)
    };
    let solid = |file: &str| measure(&meshes(file), ACCURACY).unwrap();
    assert_is(solid("cube-nurbs.mesh"), 1.0, 0.0, "cube");
    assert_is(solid("beam-hex-nurbs.mesh"), 8.0, 0.0, "beam");
    assert_is(solid("nc-nurbs3d.mesh"), 16.0, 0.0, "sixteen");
    // Their weights and points are given to some fourteen digits.
    assert_is(solid("ball-nurbs.mesh"), 4.0 * PI / 3.0, 2e-13, "ball");
    assert_is(solid("disc-nurbs.mesh"), 8.0 * PI, 1e-13, "disc");
    assert_is(solid("pipe-nurbs-2d.mesh"), 0.75 * PI, 1e-14, "pipe");
    // A cube-sphere: six patches of degree 4 × 4, whose points are given to 16 digits.
    let patches = bembel::read(&text("bembel/sphere6-biquartic.dat"));
    let sphere = shapes(&patches.iter().map(spline).collect::<Vec<_>>());
    assert_is(area(&sphere, ACCURACY).unwrap(), 4.0 * PI, 1e-13, "sphere");
    assert_is(volume(&sphere, false, ACCURACY).unwrap(), 4.0 * PI / 3.0, 1e-13, "ball");
    let tight = bounding_box(&sphere, ACCURACY).unwrap();
    assert!(tight.upper.iter().all(|x| (x - 1.0).abs() < 1e-11));
}

#[test]
fn geometries_of_gismo() {
    let expected = document("gismo/expected.json");
    for model in expected["models"].as_array().unwrap() {
        let file = model["file"].as_str().unwrap();
        let patches = gismo::read(&text(&format!("gismo/{file}")));
        for (value, patch) in model["geometries"].as_array().unwrap().iter().zip(&patches) {
            if value.get("skipped").is_some() {
                continue;
            }
            let shape: Shape = spline(patch).into();
            let found = measure(std::slice::from_ref(&shape), ACCURACY);
            let size = value["measure"].as_f64().unwrap();
            let uncertain = value["measure_uncertainty"].as_f64().unwrap() + 1e-13 * size;
            match found {
                // Its determinant changes sign near the border, and the number is the sum with signs.
                Ok(found) if file.ends_with("lake.xml") => {
                    let signed = signed_area(&[shape], ACCURACY).unwrap();
                    assert!((signed.value - size).abs() <= signed.error + uncertain, "{signed:?}");
                    assert!(found.value > signed.value);
                }
                Ok(found) => assert_is(found, size, uncertain, file),
                // Folded or sharp: known less well.
                Err(error) => {
                    assert_eq!(error.family(), "Accuracy", "{file}");
                    let coarse = measure(&[shape], 1e-4).unwrap();
                    let gap = (coarse.value - size).abs();
                    assert!(gap <= coarse.error + uncertain, "{file}: {coarse:?} {size}");
                }
            }
        }
    }
}

/// Volumes and plane surfaces of both programs: those without a fold are proved to have none.
#[test]
fn folds_of_models() {
    let mut proved = 0;
    for file in
        ["ball-nurbs.mesh", "beam-hex-nurbs.mesh", "pipe-nurbs.mesh", "square-disc-nurbs.mesh"]
    {
        for patch in mfem::read(&text(&format!("mfem/{file}"))) {
            let shape: Shape = spline(&patch).into();
            let found = folds(&shape, 1e-9).unwrap();
            assert_eq!(found.answer, Folding::None, "{file}");
            proved += 1;
        }
    }
    assert!(proved > 10);
}

/// The tea set: the areas, to what is certain about the numbers they are compared with.
#[test]
fn the_tea_set() {
    let expected = document("measures.json");
    for model in expected["models"].as_array().unwrap() {
        let file = model["file"].as_str().unwrap();
        let patches = bembel::read_bpt(&text(file));
        let splines: Vec<Spline> = patches.iter().map(spline).collect();
        let found = area(&shapes(&splines), 1e-9).unwrap();
        let value = model["area"].as_f64().unwrap();
        let uncertain = model["area_uncertainty"].as_f64().unwrap() + 1e-13 * value;
        assert!(
            (found.value - value).abs() <= found.error + uncertain,
            "{file}: {found:?} {value}"
        );
        assert!(found.error <= 1e-9 * value);
        // They do not quite close up.
        assert_eq!(volume(&shapes(&splines), false, 1e-9).unwrap_err().family(), "Degenerate");
        let tight = bounding_box(&shapes(&splines), ACCURACY).unwrap();
        let (number, at) = &tight.highest[2];
        let top = splines[*number].at(at).unwrap()[2];
        assert!(tight.upper[2] - top <= tight.error, "{file}");
    }
}
