//! Surfaces of little area: Enneper's from their boundaries, laws in fractions, descents that only descend.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use std::path::Path;

use pforms_kernel::{Error, Form, Rational, Scalar, Scaled};
use pforms_operators::{
    Functional, Minimal, MinimalOptions, Poles, Shape, Spline, extremal, hodograph, minimal, sub,
};
use pforms_testkit::{Random, Weights};
use serde_json::Value;

type Exact = Form<Rational>;

const LINEAR: [Functional; 3] = [Functional::Dirichlet, Functional::Harmonic, Functional::Laplace];

fn q(n: i64, d: i64) -> Rational {
    Rational::ratio(n, d)
}

/// The forms of `cases/truth` of one kind, with their areas.
fn truth(kind: &str) -> Vec<(Exact, f64)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/truth/closed-forms.json");
    let text = std::fs::read_to_string(path).unwrap();
    let document: Value = serde_json::from_str(&text).unwrap();
    let items = document["items"].as_array().unwrap().iter().filter(|item| item["kind"] == kind);
    let read = |item: &Value| {
        let degrees = item["form"]["degrees"].as_array().unwrap();
        let orders: Vec<usize> =
            degrees.iter().map(|p| p.as_u64().unwrap() as usize + 1).collect();
        let rows = item["form"]["points_exact"].as_array().unwrap();
        let numbers = rows.iter().flat_map(|row| row.as_array().unwrap());
        let points: Vec<Rational> = numbers.map(|x| x.as_str().unwrap().parse().unwrap()).collect();
        let form = Form::from_points(&orders, 3, &points, None).unwrap();
        (form, item["values"]["area"].as_str().unwrap().parse().unwrap())
    };
    let found: Vec<_> = items.map(read).collect();
    assert_eq!(found.len(), 2);
    found
}

fn floating(form: &Exact) -> Form {
    form.map_scalar(Scalar::to_f64).unwrap()
}

/// The same border around poles that are all 7.
fn emptied<S: Scalar>(form: &Form<S>) -> Form<S> {
    let mut result = form.clone();
    let orders = form.orders().to_vec();
    for index in 0..form.pole_count() {
        let mut rest = index;
        let place: Vec<usize> = orders
            .iter()
            .rev()
            .map(|order| {
                let at = rest % order;
                rest /= order;
                at
            })
            .collect();
        let place: Vec<usize> = place.into_iter().rev().collect();
        if place.iter().zip(&orders).all(|(&at, &order)| at > 0 && at + 1 < order) {
            let weight = form.pole(&place).unwrap()[form.ambient()].clone();
            let mut pole = vec![S::from_integer(7); form.ambient()];
            pole.push(weight);
            result = result.with_pole(&place, &pole).unwrap();
        }
    }
    result
}

fn curves<S: Scalar>(form: &Form<S>) -> Vec<Shape<S>> {
    let ends = [(1, S::zero()), (1, S::one()), (0, S::zero()), (0, S::one())];
    ends.iter().map(|(axis, t)| sub(form, *axis, t).unwrap().into()).collect()
}

#[test]
fn enneper_is_recovered_from_its_boundary_exactly() {
    for (form, _) in truth("minimal_surface") {
        for functional in [Functional::Dirichlet, Functional::Harmonic] {
            for boundary in [vec![emptied(&form).into()], curves(&form)] {
                let found = extremal(&boundary, functional, &MinimalOptions::default()).unwrap();
                assert_eq!(*found.net(), form, "{functional:?}");
            }
        }
    }
}

#[test]
fn enneper_is_recovered_in_floating_numbers() {
    for (exact, area) in truth("minimal_surface") {
        let form = floating(&exact);
        for kind in [Some(Functional::Dirichlet), Some(Functional::Harmonic), None] {
            let found =
                minimal(&curves(&form), kind, &MinimalOptions::default(), 1e-10).unwrap();
            let apart = found.surface.net().homogeneous().iter().zip(form.homogeneous());
            let most = apart.fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            println!("{kind:?} {most:e} {found:?}");
            // Systems of 4 and 16 poles whose condition is below 1e3.
            assert!(most < 1e-13, "{kind:?}: {most:e}");
            assert!((found.area / area - 1.0).abs() < 1e-13);
            assert!(found.curvature < 1e-12 && found.slope < 1e-12);
            assert!((found.energy / area - 1.0).abs() < 1e-13);
        }
    }
}

#[test]
fn explore() {
    let mut random = Random::new(5);
    for ambient in [2, 3, 4] {
        for orders in [[3, 3], [4, 4], [4, 6], [6, 6], [8, 8]] {
            let form = floating(&random.form(&orders, ambient, Weights::One));
            let found = minimal(&curves(&form), None, &MinimalOptions::default(), 1e-10).unwrap();
            let d = minimal(&curves(&form), Some(Functional::Dirichlet), &MinimalOptions::default(), 1e-10).unwrap();
            let Minimal { area, error, coons_area, energy, laplacian, curvature, slope, steps, .. } = found;
            println!("{ambient} {orders:?} {area} ±{error:e} coons {coons_area:?} dir {} e {energy} lap {laplacian} H {curvature} slope {slope:e} steps {steps}", d.area);
        }
    }
}
