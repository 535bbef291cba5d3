//! Parameters of points, and nearest points, against those that other libraries find.

use pforms_operators::{ContactKind, Inverter, Shape, Spline, SplineProjector, intersect};
use pforms_testkit::models::{document, plain};
use pforms_testkit::numbers;
use serde_json::Value;

use crate::{gap, spline};

/// The cases of a kind, and the splines they name by number.
fn cases(kind: &str, count: usize) -> (Vec<Value>, Vec<Spline>) {
    let mut all = document("../peers/inversion.json");
    let points = all["volume_points"].clone();
    for form in all["forms"].as_array_mut().unwrap() {
        if form["points_ref"] == "volume_points" {
            form["points"] = points.clone();
        }
    }
    let forms = all["forms"].as_array().unwrap().iter();
    let forms = forms.map(|form| spline(&plain::read(form))).collect();
    let mut list = all["cases"].as_array().unwrap().clone();
    list.retain(|case| case["kind"] == kind);
    assert_eq!(list.len(), count, "{kind}");
    (list, forms)
}

fn number(value: &Value) -> usize {
    usize::try_from(value.as_u64().unwrap()).unwrap()
}

#[test]
fn every_point_of_the_volume_has_its_parameters() {
    let (cases, forms) = cases("volume_inverse", 249);
    // Points are given to ten digits or more: those on the border may be so far outside.
    let hosts: Vec<Option<Inverter>> =
        forms.iter().map(|form| Inverter::new(&Shape::Spline(form.clone()), 1e-9).ok()).collect();
    for case in &cases {
        let host = hosts[number(&case["input"]["form"])].as_ref().unwrap();
        let found = &host.invert(&numbers(&case["input"]["point"])).unwrap()[0];
        let expected = numbers(&case["expected"]["u"]);
        let tolerance = case["tolerance"].as_f64().unwrap();
        assert_eq!(found.solutions.len(), 1, "{case}: {found:?}");
        let (here, solution) = (&found.solutions[0].parameters, &found.solutions[0]);
        assert!(found.complete() && solution.proved, "{case}: {found:?}");
        assert!(gap(here, &expected) <= tolerance, "{case}: {found:?}");
    }
}

#[test]
fn no_library_comes_nearer_to_a_volume() {
    let (cases, forms) = cases("volume_closest", 48);
    for case in &cases {
        let mut host = forms[number(&case["input"]["form"])].clone();
        for (axis, bounds) in case["input"]["bounds"].as_array().unwrap().iter().enumerate() {
            let bounds = numbers(bounds);
            host = host.restrict(axis, &bounds[0], &bounds[1]).unwrap();
        }
        let projector = SplineProjector::new(&host, 1e-12).unwrap();
        let found = projector.project(&numbers(&case["input"]["point"])).unwrap();
        let expected = case["expected"]["distance"].as_f64().unwrap();
        let tolerance = case["tolerance"].as_f64().unwrap();
        assert!(found.distances[0] <= expected + tolerance, "{case}: {found:?}");
        assert!((found.distances[0] - expected).abs() <= tolerance, "{case}: {found:?}");
    }
}

#[test]
fn a_hundred_points_of_a_wild_surface() {
    let (cases, forms) = cases("surface_inverse", 1);
    let case = &cases[0];
    let host = Shape::Spline(forms[number(&case["input"]["form"])].clone());
    let inverter = Inverter::new(&host, 1e-9).unwrap();
    let points = case["input"]["points"].as_array().unwrap();
    let expected = case["expected"]["u"].as_array().unwrap();
    let all: Vec<f64> = points.iter().flat_map(numbers).collect();
    for (found, expected) in inverter.invert(&all).unwrap().iter().zip(expected) {
        let expected = numbers(expected);
        let tolerance = case["tolerance"].as_f64().unwrap();
        let near = |s: &&pforms_operators::Preimage| gap(&s.parameters, &expected) <= tolerance;
        assert!(found.solutions.iter().filter(near).count() == 1, "{expected:?}: {found:?}");
        assert!(found.complete(), "{expected:?}: {found:?}");
    }
}

#[test]
fn curves_pierce_surfaces() {
    let (cases, forms) = cases("curve_surface", 4);
    for case in &cases {
        let of = |name: &str| Shape::Spline(forms[number(&case["input"][name])].clone());
        let found = intersect(&of("curve"), &of("surface"), 1e-14).unwrap();
        assert!(found.complete, "{case}: {found:?}");
        let expected = case["expected"]["intersections"].as_array().unwrap();
        assert_eq!(found.contacts.len(), expected.len(), "{case}: {found:?}");
        let tolerance = case["tolerance"].as_f64().unwrap();
        for (contact, place) in found.contacts.iter().zip(expected) {
            assert!(contact.proved && contact.kind == ContactKind::Crossing);
            assert!((contact.first[0] - place["u"].as_f64().unwrap()).abs() <= tolerance);
            assert!(gap(&contact.second, &numbers(&place["uv"])) <= tolerance, "{case}");
            assert!(gap(&contact.point, &numbers(&place["point"])) <= tolerance, "{case}");
        }
    }
}
