//! What a form accepts, refuses and tells.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Error, Form, Kind, Matrix, limit};

fn family<T: std::fmt::Debug>(result: Result<T, Error>) -> (&'static str, String) {
    let error = result.unwrap_err();
    (error.family(), error.to_string())
}

#[test]
fn bad_poles_are_refused_by_name() {
    let shape = family(Form::from_homogeneous(&[2], 1, vec![0.0; 3]));
    assert_eq!(
        shape,
        (
            "Shape",
            "poles: received 3 numbers, expected 4 for orders [2] and 2 coordinates a pole".into()
        )
    );
    assert_eq!(family(Form::from_homogeneous(&[0, 2], 1, Vec::<f64>::new())).0, "Shape");
    assert_eq!(family(Form::from_homogeneous(&[], 0, vec![1.0])).0, "Shape");
    let nan = family(Form::from_homogeneous(&[2], 1, vec![0.0, 1.0, f64::NAN, 1.0]));
    assert_eq!(nan.0, "Domain");
    assert!(nan.1.contains("NaN in pole 1, coordinate 0"), "{}", nan.1);
    let infinite = Form::from_points(&[1], 1, &[f64::INFINITY], None);
    assert_eq!(family(infinite).0, "Domain");
    let weights = Form::from_points(&[2], 1, &[0.0, 1.0], Some(&[1.0]));
    assert!(family(weights).1.starts_with("weights: received 1 weights, expected 2"));
    // A product that overflows is caught too: no form holds an infinity.
    let overflow = Form::from_points(&[1], 1, &[1e200], Some(&[1e200]));
    assert_eq!(family(overflow).0, "Domain");
}

#[test]
fn absurd_orders_are_refused_before_anything_is_allocated() {
    let huge = Form::from_homogeneous(&[usize::MAX, usize::MAX], 3, Vec::<f64>::new());
    assert_eq!(family(huge).0, "Limit");
    let (_, text) = family(limit::check::<f64>("the grid", &[100_000, 100_000], 3));
    assert_eq!(text, "the grid would have 100000×100000 poles, 240 GB: refused, the cap is 1.1 GB");
}

#[test]
fn weights_may_be_zero_or_negative() {
    let f = Form::from_points(&[3], 2, &[1., 0., 0., 1., -1., 0.], Some(&[1., 0., -1.])).unwrap();
    assert_eq!(f.homogeneous(), [1., 0., 1., 0., 1., 0., 1., 0., -1.]);
    assert!(f.is_rational());
    assert_eq!(family(f.points()).0, "Domain");
    assert!(family(f.points()).1.contains("weight 0 at pole [1]"));
    // The weight (1 − t)² − t² vanishes at ½.
    assert_eq!(family(f.at(&[0.5])).0, "Domain");
    assert!(f.at(&[0.25]).is_ok());
    assert_eq!(family(f.grid(&[&[0.0, 0.5]])).0, "Domain");
}

#[test]
fn a_form_may_have_no_axis_or_eight_in_any_dimension() {
    let point = Form::point(&[1.0, 2.0, 3.0]).unwrap();
    assert_eq!((point.axes(), point.pole_count()), (0, 1));
    assert_eq!(point.at(&[]).unwrap(), [1.0, 2.0, 3.0]);
    assert_eq!(point.grid(&[]).unwrap(), [1.0, 2.0, 3.0]);
    let orders = [2; 8];
    let poles: Vec<f64> = (0..256 * 9).map(f64::from).collect();
    let hyper = Form::from_homogeneous(&orders, 8, poles).unwrap();
    assert_eq!(hyper.kind().to_string(), "pF[2,2,2,2,2,2,2,2]");
    assert_eq!(hyper.homogeneous_at(&[0.5; 8]).unwrap()[0], 255.0 * 9.0 / 2.0);
    assert_eq!(hyper.pole(&[0, 0, 0, 0, 0, 0, 0, 1]).unwrap()[0], 9.0);
}

#[test]
fn one_pole_an_axis_is_a_constant_axis() {
    let f = Form::from_points(&[1, 2], 1, &[3.0, 5.0], None).unwrap();
    assert_eq!(f.at(&[0.7, 0.5]).unwrap(), [4.0]);
    assert_eq!(f.derivative_at(&[0.7, 0.5], &[1, 0]).unwrap(), [0.0]);
}

#[test]
fn moved_poles_make_a_new_form() {
    let f = Form::from_points(&[2, 2], 1, &[0., 1., 2., 3.], None).unwrap();
    let g = f.with_pole(&[1, 0], &[7.0, 1.0]).unwrap();
    assert_eq!(g.points().unwrap(), [0., 1., 7., 3.]);
    assert_eq!(f.points().unwrap(), [0., 1., 2., 3.]);
    assert_eq!(family(f.with_pole(&[2, 0], &[7.0, 1.0])).0, "Shape");
    assert_eq!(family(f.with_pole(&[1], &[7.0, 1.0])).0, "Shape");
    assert_eq!(family(f.with_pole(&[1, 0], &[7.0])).0, "Shape");
    assert_eq!(family(f.with_pole(&[1, 0], &[f64::NAN, 1.0])).0, "Domain");
}

#[test]
fn kinds_are_read_as_they_are_written() {
    for text in ["pP", "pL4", "pL12", "pS34", "pS[12,3]", "pV222", "pH2222", "pF[2,2,2,2,2]"] {
        assert_eq!(text.parse::<Kind>().unwrap().to_string(), text);
    }
    assert_eq!("pL[4]".parse::<Kind>().unwrap(), Kind::new(&[4]));
    for text in ["", "p", "S33", "pS3", "pS333", "pL0", "pX22", "pS[3,", "pP2", "pL-1", "pS３３"]
    {
        assert_eq!(family(text.parse::<Kind>()).0, "Shape", "{text}");
    }
}

#[test]
fn acting_along_an_axis_checks_its_matrix() {
    let f = Form::from_points(&[2, 3], 1, &[0., 1., 2., 3., 4., 5.], None).unwrap();
    let sum = Matrix::from_rows(vec![vec![1.0, 1.0]]).unwrap();
    assert_eq!(f.along(0, &sum).unwrap().homogeneous(), [3., 2., 5., 2., 7., 2.]);
    assert_eq!(family(f.along(1, &sum)).0, "Shape");
    assert_eq!(family(f.along(2, &sum)).0, "Shape");
    assert_eq!(family(Matrix::from_rows(vec![vec![1.0], vec![]])).0, "Shape");
    assert_eq!(family(Matrix::<f64>::from_rows(vec![])).0, "Shape");
}
