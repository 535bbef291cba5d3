//! Nearest points of splines against those that other libraries find.
#![allow(clippy::unwrap_used)]

use pforms_kernel::Form;
use pforms_operators::project;
use serde_json::Value;

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

/// The value of the polar form of a spline on the span from `knots[span]`, by de Boor's scheme.
fn polar(poles: &[Vec<f64>], knots: &[f64], span: usize, arguments: &[f64]) -> Vec<f64> {
    let degree = arguments.len();
    let mut points = poles[span - degree..=span].to_vec();
    for (r, t) in (1..=degree).zip(arguments) {
        for i in (r..=degree).rev() {
            let (low, high) = (knots[span - degree + i], knots[span + 1 + i - r]);
            let share = (t - low) / (high - low);
            points[i] = points[i - 1]
                .iter()
                .zip(&points[i])
                .map(|(a, b)| (1.0 - share) * a + share * b)
                .collect();
        }
    }
    points.swap_remove(degree)
}

/// The Bézier poles of every span along the leading axis; a pole is a line of numbers.
fn pieces(poles: &[Vec<f64>], knots: &[f64], degree: usize) -> Vec<Vec<Vec<f64>>> {
    let spans = (degree..poles.len()).filter(|span| knots[*span] < knots[span + 1]);
    spans
        .map(|span| {
            let pole = |i: usize| {
                let mut arguments = vec![knots[span]; degree - i];
                arguments.resize(degree, knots[span + 1]);
                polar(poles, knots, span, &arguments)
            };
            (0..=degree).map(pole).collect()
        })
        .collect()
}

/// The pieces of a spline curve or surface.
fn forms(record: &Value) -> Vec<Form> {
    let degrees: Vec<usize> = numbers(&record["degrees"]).iter().map(|x| *x as usize).collect();
    let knots: Vec<Vec<f64>> = record["knots"].as_array().unwrap().iter().map(numbers).collect();
    let points: Vec<Vec<f64>> = record["points"].as_array().unwrap().iter().map(numbers).collect();
    let ambient = points[0].len();
    let weights = record.get("weights").map_or(vec![1.0; points.len()], numbers);
    let homogeneous: Vec<Vec<f64>> = points
        .iter()
        .zip(&weights)
        .map(|(point, w)| point.iter().map(|x| x * w).chain([*w]).collect())
        .collect();
    let orders: Vec<usize> = degrees.iter().map(|degree| degree + 1).collect();
    let of = |poles: Vec<f64>| Form::from_homogeneous(&orders, ambient, poles).unwrap();
    if degrees.len() == 1 {
        let all = pieces(&homogeneous, &knots[0], degrees[0]);
        return all.into_iter().map(|poles| of(poles.concat())).collect();
    }
    let columns = knots[1].len() - degrees[1] - 1;
    let rows: Vec<Vec<f64>> = homogeneous.chunks(columns).map(<[Vec<f64>]>::concat).collect();
    let strips = pieces(&rows, &knots[0], degrees[0]);
    let along_v = strips.iter().flat_map(|strip| {
        let turned: Vec<Vec<Vec<Vec<f64>>>> = strip
            .iter()
            .map(|row| {
                let row: Vec<Vec<f64>> = row.chunks(ambient + 1).map(<[f64]>::to_vec).collect();
                pieces(&row, &knots[1], degrees[1])
            })
            .collect();
        (0..turned[0].len()).map(move |k| turned.iter().flat_map(|row| row[k].concat()).collect())
    });
    along_v.map(of).collect()
}

#[test]
fn no_library_comes_nearer() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/peers/project.json");
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let splines: Vec<Vec<Form>> = file["forms"].as_array().unwrap().iter().map(forms).collect();
    let cases = file["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 111);
    for case in cases {
        let point = numbers(&case["point"]);
        let pieces = &splines[case["form"].as_u64().unwrap() as usize];
        let found = pieces.iter().map(|form| project(form, &point, 1e-12).unwrap());
        let (distance, gap) = found
            .map(|found| (found.distances[0], found.gaps[0]))
            .fold((f64::INFINITY, 0.0_f64), |(d, g), (x, y)| (d.min(x), g.max(y)));
        let expected = case["distance"].as_f64().unwrap();
        let tolerance = case["tolerance"].as_f64().unwrap();
        assert!((distance - expected).abs() <= tolerance, "{case}: {distance}");
        // A few roundings of coordinates up to 60.
        assert!(gap < 1e-11, "{case}: gap {gap}");
    }
}
