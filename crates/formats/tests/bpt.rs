//! Bézier patches as text: Newell's tea set, and damaged files.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use common::{TEAPOT, teapot};
use pforms_formats::{Named, bpt};
use pforms_kernel::{Error, Form};
use pforms_mesh::{Sampling, Triangles, surfaces};
use proptest::prelude::*;

fn fails(text: &str) -> (usize, usize, String) {
    match bpt::read(text.as_bytes()).unwrap_err() {
        Error::Format { place: Some(place), message, .. } => (place.line, place.column, message),
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_teapot_has_the_area_it_is_known_for() {
    let forms = teapot();
    assert_eq!(forms.len(), 32);
    assert!(forms.iter().all(|form| form.orders() == [4, 4] && !form.is_rational()));
    let meshes = surfaces(&forms, &Sampling::Tolerance(0.0004)).unwrap();
    let area: f64 = meshes.iter().map(Triangles::area).sum();
    assert!((area - 52.884_054_820_4).abs() < 0.05, "{area}");
    assert!(meshes.iter().flat_map(|mesh| mesh.normals.as_flattened()).all(|x| x.is_finite()));
}

#[test]
fn the_whole_tea_set_loads() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/models/");
    for (file, patches) in [("newell-teacup26.bpt", 26), ("newell-teaspoon16.bpt", 16)] {
        let bytes = std::fs::read(format!("{folder}{file}")).unwrap();
        assert_eq!(bpt::read(&bytes).unwrap().len(), patches);
    }
}

#[test]
fn what_is_written_reads_back_the_same() {
    let mut forms: Vec<Named> = teapot().into_iter().map(Named::from).collect();
    let flat = Form::from_points(&[1, 3], 2, &[0.1, 1e-7, -3e20, 0.5, 7.0, 1.0], None).unwrap();
    forms.push(flat.into());
    let again = bpt::read(&bpt::write(&forms).unwrap()).unwrap();
    assert_eq!(again[..32], forms[..32]);
    assert_eq!(again[32].net().orders(), [1, 3]);
    assert_eq!(again[32].net().points().unwrap()[..3], [0.1, 1e-7, 0.0]);
    assert!(bpt::read(&bpt::write(&[]).unwrap()).unwrap().is_empty());
}

#[test]
fn what_it_cannot_hold_is_refused() {
    let curve = Form::from_points(&[2], 3, &[0.0; 6], None).unwrap();
    assert_eq!(bpt::write(&[curve.into()]).unwrap_err().family(), "Shape");
    let rational = pforms_testkit::octant([1.0; 3]);
    assert_eq!(bpt::write(&[rational.into()]).unwrap_err().family(), "Domain");
}

#[test]
fn damage_is_told_with_its_place() {
    for (text, line, column, part) in [
        ("", 1, 1, "number of patches"),
        ("x", 1, 1, "\"x\" where the number of patches"),
        ("-1", 1, 1, "\"-1\""),
        ("99999999999999999999", 1, 1, "whole number"),
        ("9999999999\n3 3\n", 1, 1, "too short for 9999999999 patches"),
        ("1\n9999999 9999999\n1 2 3\n", 2, 9, "too short"),
        ("1\n18446744073709551615 3\n1 2 3\n", 2, 22, "too short"),
        ("1\n0 0\n1 2\n", 4, 1, "the file ends where a coordinate of patch 1"),
        ("1\n0 0\n1 nan 3\n", 3, 3, "NaN"),
        ("1\n0 0\n1 2 1e999\n", 3, 5, "inf"),
        ("1\n0 0\n1 two 3\n", 3, 3, "\"two\""),
        ("1\n0 0\n1 2 3\n4\n", 4, 1, "\"4\" after 1 patches"),
    ] {
        let (at, across, message) = fails(text);
        assert_eq!((at, across), (line, column), "{text:?}: {message}");
        assert!(message.contains(part), "{message} lacks {part}");
    }
    assert_eq!(bpt::read(b"1\n0 0\n1 \xff 3").unwrap_err().family(), "Format");
}

#[test]
fn a_file_cut_anywhere_is_refused() {
    let start = TEAPOT.len().min(700);
    for cut in (0..start).chain(TEAPOT.len() - 40..TEAPOT.len() - 4) {
        assert!(bpt::read(&TEAPOT[..cut]).is_err(), "{cut}");
    }
}

proptest! {
    #[test]
    fn a_changed_byte_never_panics(at in 0usize..300, byte in any::<u8>()) {
        let mut bytes = b"2\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 1\n0 0\n7 8 9\n".to_vec();
        let at = at % bytes.len();
        bytes[at] = byte;
        let _ = bpt::read(&bytes);
    }
}
