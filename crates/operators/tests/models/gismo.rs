//! Geometries of G+Smo and splinepy against numbers computed apart from pforms.

use pforms_operators::Spline;
use pforms_testkit::models::{document, gismo, text};
use pforms_testkit::numbers;
use serde_json::Value;

use crate::measure::measure;
use crate::{gap, laws, pole_box, scale, spline};

/// Every file, what is expected of it, and what it holds.
fn models() -> Vec<(String, Value, Vec<pforms_testkit::models::Patch>)> {
    let expected = document("gismo/expected.json");
    let list = expected["models"].as_array().unwrap().clone();
    assert_eq!(list.len(), 31);
    list.into_iter()
        .map(|model| {
            let file = model["file"].as_str().unwrap().to_owned();
            let patches = gismo::read(&text(&format!("gismo/{file}")));
            (file, model, patches)
        })
        .collect()
}

/// Each geometry that is whole, with what is expected of it.
fn geometries() -> impl Iterator<Item = (String, Value, Spline)> {
    models().into_iter().flat_map(|(file, model, patches)| {
        let expected = model["geometries"].as_array().unwrap().clone();
        assert_eq!(expected.len(), patches.len(), "{file}");
        let whole = |(value, patch): (Value, _)| {
            let sound = value.get("skipped").is_none();
            sound.then(|| (file.clone(), value, spline(&patch)))
        };
        expected.into_iter().zip(patches).filter_map(whole).collect::<Vec<_>>()
    })
}

#[test]
fn degrees_counts_samples_and_boxes_are_those_expected() {
    let mut count = 0;
    for (file, expected, spline) in geometries() {
        let whole = |key: &str| -> Vec<usize> {
            numbers(&expected[key]).iter().map(|x| *x as usize).collect()
        };
        assert_eq!(spline.degrees(), whole("degrees"), "{file}");
        assert_eq!(spline.net().orders(), whole("counts"), "{file}");
        assert_eq!(spline.ambient(), whole("dim")[0], "{file}");
        assert!(expected["rational"] == true || !spline.net().is_rational(), "{file}");
        let sample = &expected["sample"];
        let point = numbers(&sample["point"]);
        let here = spline.at(&numbers(&sample["u"])).unwrap();
        let bound = 1e-14 * scale(&spline);
        assert!(gap(&here, &point) <= bound, "{file}: {here:?} {point:?}");
        let box_gap = gap(&pole_box(&spline).concat(), &numbers(&expected["control_bbox"]));
        assert!(box_gap <= bound, "{file}");
        count += 1;
    }
    assert_eq!(count, 131);
}

#[test]
fn lengths_areas_and_volumes_are_those_expected() {
    let mut sums = std::collections::BTreeMap::new();
    for (file, expected, spline) in geometries() {
        // The rule with which the expected numbers were computed: the same but for rounding.
        let same = measure(&spline, 12);
        let value = expected["measure"].as_f64().unwrap();
        assert!((same.size - value).abs() <= 1e-13 * value, "{file}: {} {value}", same.size);
        if let Some(signed) = expected["signed"].as_f64() {
            assert!(
                (same.signed - signed).abs() <= 1e-13 * value,
                "{file}: {} {signed}",
                same.signed
            );
        }
        *sums.entry(file).or_insert(0.0) += same.size;
    }
    for (file, model, _) in models() {
        let value = model["total_measure"].as_f64().unwrap();
        let sum = sums.get(&file).copied().unwrap_or(0.0);
        assert!((sum - value).abs() <= 1e-13 * value.max(1.0), "{file}: {sum} {value}");
    }
}

/// What is known of some models without any computation.
#[test]
fn closed_forms() {
    use std::f64::consts::PI;
    let close = |file: &str, value: f64, bound: f64| {
        let patches = gismo::read(&text(&format!("gismo/{file}")));
        let splines: Vec<Spline> = patches.iter().map(spline).collect();
        let sum = crate::measure::total(&splines, 20);
        assert!((sum - value).abs() <= bound * value, "{file}: {sum} {value}");
    };
    close("planar-unitdisk.xml", PI, 1e-14);
    close("planar-square_with_disk.xml", 16.0, 1e-14);
    close("domain2d-ldomain.xml", 3.0, 1e-14);
    close("planar-hexagon_3p.xml", 1.5 * 3.0_f64.sqrt(), 1e-14);
    close("volumes-fichera.xml", 7.0, 1e-14);
    // The roof: radius 25, 80 degrees, length 50.
    close("surfaces-scordelis_lo_roof.xml", 25.0 * 80.0_f64.to_radians() * 50.0, 1e-14);
    // Weights and points of these are rounded to 9, 12 and 5 digits.
    close("curves3d-quarter_circle.xml", PI / 2.0, 1e-9);
    close("volumes-cylinder.xml", 3.0 * PI, 1e-11);
    close("surfaces-quarter_sphere.xml", 100.0 * PI, 1e-3);
}

#[test]
fn poles_that_do_not_fit_their_knots_are_refused() {
    let patches = gismo::read(&text("gismo/curves3d-bspline3d_curve_02.xml"));
    let [patch] = patches.as_slice() else { panic!("one curve") };
    let error = Spline::new(patch.net.clone(), &patch.degrees, patch.knots.clone()).unwrap_err();
    assert_eq!(error.family(), "Shape");
    let message = error.to_string();
    assert!(message.contains("knots") && message.contains("10 + 3 + 1"), "{message}");
}

/// splinepy writes the same splines with and without indentation, labels and base64.
#[test]
fn ways_of_writing_make_no_difference() {
    let read = |file: &str| gismo::read(&text(&format!("gismo/splinepy-gismo_{file}.xml")));
    assert_eq!(read("additional_blocks"), read("indent_labels_ascii_2d"));
    let [dense] = &read("noindent_nolabels_b64_3d")[..] else { panic!("one volume") };
    assert_eq!(dense.net.orders().len(), 3);
    assert_eq!(dense.knots[0][3], 0.223_917_226_353_562_93);
}

/// The four sides of a Coons patch on common knots: the same curves, with poles that correspond.
#[test]
fn sides_come_to_common_knots() {
    let sides: Vec<Spline> =
        gismo::read(&text("gismo/curves3d-curve_boundary.xml")).iter().map(spline).collect();
    let mut uneven = sides.clone();
    uneven[1] = uneven[1].elevate(&[2]).unwrap().insert_knots(0, &[0.25, 0.75, 0.75]).unwrap();
    uneven[3] = uneven[3].insert_knots(0, &[0.125]).unwrap();
    let common = Spline::on_common_knots(&uneven).unwrap();
    assert_eq!(common[0].breaks(), [[0.0, 0.125, 0.25, 0.5, 0.75, 1.0]]);
    for (side, same) in sides.iter().zip(&common) {
        assert_eq!(same.degrees(), [4]);
        assert_eq!(same.knots(), common[0].knots());
        for i in 0..=16 {
            let t = f64::from(i) / 16.0;
            assert!(gap(&side.at(&[t]).unwrap(), &same.at(&[t]).unwrap()) <= 1e-15);
        }
    }
}

#[test]
fn laws_hold_on_every_geometry() {
    let mut seen = std::collections::BTreeMap::new();
    for (file, _, spline) in geometries() {
        // Patches of one file are much alike.
        let count = seen.entry(file.clone()).or_insert(0);
        *count += 1;
        if *count <= 2 {
            laws::hold(&file, &spline);
        }
    }
}
