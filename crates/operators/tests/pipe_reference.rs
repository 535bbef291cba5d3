//! The tubes of the original system, checked there against exact arithmetic.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::Form;
use pforms_operators::{FrameKind, Law, PipeOptions, pipe, subdivide};
use pforms_testkit::{Case, cases, net, numbers};

/// The poles of the halved section at every pole's parameter of the halved path.
fn check(case: &Case, radius: Law) {
    let path: Form = net(&case.input["path"]);
    let section: Form = net(&case.input["section"]);
    let halvings = |name: &str| case.params[name].as_u64().unwrap() as u32;
    let options = PipeOptions {
        frame: FrameKind::Frenet,
        radius,
        tolerance: Some(1e-10),
        ..PipeOptions::default()
    };
    let tube = pipe(&path.clone().into(), &section.into(), &options).unwrap();
    let wanted: Vec<Vec<f64>> = case.expected.as_array().unwrap().iter().map(numbers).collect();
    assert_eq!(wanted.len(), (path.orders()[0] - 1) * (1 << halvings("path_cuts")) + 1);
    for (i, wanted) in wanted.iter().enumerate() {
        let u = i as f64 / (case.expected.as_array().unwrap().len() - 1) as f64;
        let across = tube.spline.sub(0, &u).unwrap();
        let poles = subdivide(&across.piece(&[0]).unwrap(), &[halvings("section_cuts")]).unwrap();
        let weight = path_weight(&path, u);
        let size = wanted.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
        for (found, wanted) in poles.net().homogeneous().iter().zip(wanted) {
            // Numbers of 15 digits, and what the tube says of itself.
            let off = (found / weight - wanted).abs();
            assert!(off <= tube.error + 1e-12 * size, "{} at {i}: {off}", case.id);
        }
        assert_eq!(poles.net().homogeneous().len(), wanted.len());
    }
    assert!(tube.error <= 1e-10);
}

/// The tube's weights are those of the section times the path's; the cases have the section's.
fn path_weight(path: &Form, u: f64) -> f64 {
    let weights = Form::from_points(path.orders(), 1, &path.weights(), None).unwrap();
    weights.at(&[u]).unwrap()[0]
}

#[test]
fn tubes() {
    for case in cases("pipe") {
        check(&case, Law::Constant(1.0));
    }
}

#[test]
fn waving_tubes() {
    for case in cases("waving_pipe") {
        let number = |name: &str| case.params[name].as_f64().unwrap();
        let (amplitude, periods) = (number("amplitude"), number("periods"));
        check(&case, Law::Wave { mean: 1.0, amplitude, periods });
    }
}
