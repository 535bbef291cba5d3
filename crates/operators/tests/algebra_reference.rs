//! The cases of the original POV-Ray system, checked there against exact arithmetic.
//!
//! Their numbers are kept to 15 digits: 1e-12 of the largest coordinate is the bound.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Form, Matrix};
use pforms_operators::{
    Rotation, Turn, diagonal, elevate, forecast, immerse, immerse_points, rotate, scale, stretch,
    sub, subdivide, transform, translate,
};
use pforms_testkit::{Case, cases, net, numbers};
use serde_json::Value;

fn assert_numbers(case: &Case, computed: &[f64], expected: &Value) {
    let expected = numbers(expected);
    assert_eq!(computed.len(), expected.len(), "{}", case.id);
    let size = expected.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    for (a, b) in computed.iter().zip(&expected) {
        assert!((a - b).abs() <= 1e-12 * size, "{}: {a} for {b}", case.id);
    }
}

fn assert_net(case: &Case, computed: &Form) {
    let expected: Form = net(&case.expected);
    assert_eq!(computed.orders(), expected.orders(), "{}", case.id);
    assert_numbers(case, computed.homogeneous(), &case.expected);
}

fn sizes(value: &Value) -> Vec<usize> {
    numbers(value).iter().map(|x| *x as usize).collect()
}

#[test]
fn diagonals() {
    for case in cases("diagonalisation") {
        let axes = sizes(&case.params["axes"]);
        assert_net(&case, &diagonal(&net(&case.input), axes[0], axes[1]).unwrap());
    }
}

#[test]
fn elevations() {
    for case in [cases("elevation_curve"), cases("elevation_surface")].concat() {
        let by = sizes(&case.params["by"]);
        assert_net(&case, &elevate(&net(&case.input), &by).unwrap());
    }
}

#[test]
fn stretches() {
    for case in cases("stretch") {
        let [a, b] = ["a", "b"].map(|name| numbers(&case.params[name]));
        assert_net(&case, &stretch(&net(&case.input), &a, &b).unwrap());
    }
}

#[test]
fn subdivisions() {
    for case in cases("subdivision") {
        let r: Vec<u32> = sizes(&case.params["r"]).iter().map(|&r| r as u32).collect();
        assert_net(&case, subdivide(&net(&case.input), &r).unwrap().net());
    }
}

#[test]
fn sub_forms() {
    for case in cases("subform") {
        let axis = sizes(&case.params["axis"])[0];
        let t = numbers(&case.params["t"])[0];
        assert_net(&case, &sub(&net(&case.input), axis, &t).unwrap());
    }
}

#[test]
fn points() {
    for case in cases("getpoint") {
        let form: Form = net(&case.input);
        let at = numbers(&case.params["at"]);
        if case.params["compare"] == "euclidean" {
            let mut point = form.at(&at).unwrap();
            point.push(1.0);
            assert_numbers(&case, &point, &case.expected);
        } else {
            assert_numbers(&case, &form.homogeneous_at(&at).unwrap(), &case.expected);
        }
    }
}

#[test]
fn immersions() {
    for case in [cases("immersion_curve_in_surface"), cases("immersion_general")].concat() {
        let result = immerse(&net(&case.input["inner"]), &net(&case.input["host"])).unwrap();
        assert_net(&case, &result);
    }
}

#[test]
fn pointwise_immersions() {
    for case in cases("immersion_pointwise") {
        let host: Form = net(&case.input["host"]);
        let points = &case.input["points"];
        let count = points.as_array().unwrap().len();
        for (index, expected) in case.expected.as_array().unwrap().iter().enumerate().take(count) {
            let at = numbers(&points[index]);
            if at.len() != host.axes() {
                continue;
            }
            let form = Form::point(&at).unwrap();
            let image = immerse_points(&form, |point| host.at(point)).unwrap();
            let point = host.homogeneous_at(&at).unwrap();
            assert_numbers(&case, &point, expected);
            let euclidean: Vec<f64> = point[..3].iter().map(|x| x / point[3]).collect();
            assert_eq!(image.points().unwrap(), euclidean);
        }
    }
}

#[test]
fn table_of_section_2236() {
    for case in cases("degree_table") {
        let [inner, host] = ["inner", "host"].map(|name| sizes(&case.params[name]));
        let orders = forecast::<f64>(&inner, &host, 3).orders;
        assert_eq!(orders, sizes(&case.expected), "{}", case.id);
    }
}

#[test]
fn translations() {
    for case in cases("translate") {
        let by = numbers(&case.params["by"]);
        assert_net(&case, &translate(&net::<f64>(&case.input), &by).unwrap());
    }
}

#[test]
fn scalings() {
    for case in cases("scale") {
        let factors = numbers(&case.params["factors"]);
        assert_net(&case, &scale(&net::<f64>(&case.input), &factors, &[0.0; 3]).unwrap());
    }
}

#[test]
fn rotations() {
    for case in cases("rotate") {
        let angles = numbers(&case.params["degrees"]);
        let book = Rotation::Book([0, 1, 2].map(|k: usize| Turn::degrees(angles[k]).unwrap()));
        assert_net(&case, &rotate(&net::<f64>(&case.input), &book, &[0.0; 3]).unwrap());
    }
}

#[test]
fn transformed_points() {
    for case in cases("transform") {
        let rows = case.params["matrix"].as_array().unwrap().iter().map(numbers).collect();
        let matrix = Matrix::from_rows(rows).unwrap();
        assert_net(&case, &transform(&net::<f64>(&case.input), &matrix).unwrap());
    }
}
