//! Projection against dense sampling, exact feet, and forms that are hardly there.
#![allow(clippy::unwrap_used)]

mod common;

use common::{distance, family, moved, octant, torus};
use pforms_kernel::Form;
use pforms_operators::{Projection, project};
use pforms_testkit::{ROUNDS, Random, Weights};

const ACCURACY: f64 = 1e-12;

fn foot(form: &Form, point: &[f64]) -> Projection {
    project(form, point, ACCURACY).unwrap()
}

/// A hidden better point would be found by sampling: the distance less the gap is a lower bound.
fn assert_nearest(form: &Form, points: &[f64], samples: usize) -> Projection {
    let found = project(form, points, ACCURACY).unwrap();
    let line: Vec<f64> = (0..=samples).map(|i| i as f64 / samples as f64).collect();
    let lists: Vec<&[f64]> = form.orders().iter().map(|_| line.as_slice()).collect();
    let grid = form.grid(&lists).unwrap();
    let ambient = form.ambient();
    for (i, point) in points.chunks_exact(ambient).enumerate() {
        let at = &found.parameters[i * form.axes()..][..form.axes()];
        assert!(at.iter().all(|t| (0.0..=1.0).contains(t)));
        let size = 1.0 + grid.iter().chain(point).fold(0.0_f64, |most, x| most.max(x.abs()));
        let foot = form.at(at).unwrap();
        assert!(distance(&foot, &found.points[i * ambient..][..ambient]) < 1e-13 * size);
        assert!((distance(&foot, point) - found.distances[i]).abs() < 1e-13 * size);
        let nearest =
            grid.chunks_exact(ambient).map(|x| distance(x, point)).fold(f64::INFINITY, f64::min);
        let bound = found.distances[i] - found.gaps[i];
        assert!(bound <= nearest, "{form:?} {point:?}: {bound} > {nearest}");
        assert!(found.gaps[i] <= 2e-12 * size, "{form:?} {point:?}: gap {}", found.gaps[i]);
    }
    found
}

#[test]
fn a_plane_is_met_at_right_angles() {
    let plane: Form =
        Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 4., 0., 4., 0., 0., 4., 4., 0.], None)
            .unwrap();
    let found = foot(&plane, &[1.0, 3.0, 2.0, -3.0, 8.0, 0.0]);
    assert_eq!(found.parameters, [0.25, 0.75, 0.0, 1.0]);
    assert_eq!(found.points, [1., 3., 0., 0., 4., 0.]);
    assert_eq!(found.distances, [2.0, 5.0]);
    assert_eq!(found.unique, [true, true]);
    assert!(found.gaps.iter().all(|gap| *gap < 1e-13));
}

#[test]
fn the_nearest_point_of_a_sphere_lies_on_the_ray() {
    let mut random = Random::new(3);
    let sphere = octant(2.0);
    for _ in 0..ROUNDS.max(20) {
        let ray: Vec<f64> = (0..3).map(|_| 0.1 + 0.9 * random.unit()).collect();
        let length = ray.iter().map(|x| x * x).sum::<f64>().sqrt();
        for radius in [0.5_f64, 1.9, 2.0, 2.5, 10.0] {
            let point: Vec<f64> = ray.iter().map(|x| radius * x / length).collect();
            let found = foot(&sphere, &point);
            assert!((found.distances[0] - (radius - 2.0).abs()).abs() < 2e-15 * radius.max(4.0));
            assert!(found.unique[0] && found.gaps[0] < 2e-14 * (2.0 + radius), "{found:?}");
        }
    }
}

#[test]
fn from_the_centre_every_point_is_as_near() {
    let found = foot(&octant(2.0), &[0.0; 3]);
    assert!((found.distances[0] - 2.0).abs() < 1e-14);
    assert!(found.gaps[0] < 1e-11 && !found.unique[0], "{found:?}");
    let quarter: Form =
        Form::from_homogeneous(&[3], 2, vec![1., 0., 1., 1., 1., 1., 0., 2., 2.]).unwrap();
    let found = foot(&quarter, &[0.0, 0.0]);
    assert!((found.distances[0] - 1.0).abs() < 1e-15 && !found.unique[0]);
    assert!(found.gaps[0] < 1e-11);
}

#[test]
fn no_sample_of_a_random_form_is_nearer_than_proved() {
    let mut random = Random::new(7);
    for round in 0..ROUNDS {
        for (axes, highest, samples) in [(1, 6, 400), (2, 4, 40), (3, 3, 12)] {
            let orders = random.orders(axes, highest);
            let ambient = random.size(1, 4);
            let weights = if round % 2 == 0 { Weights::One } else { Weights::Positive };
            let form: Form = random.form(&orders, ambient, weights);
            let points: Vec<f64> = (0..5 * ambient).map(|_| 8.0 * random.unit() - 4.0).collect();
            assert_nearest(&form, &points, samples);
        }
    }
}

#[test]
fn a_point_of_the_form_is_found_again() {
    let mut random = Random::new(11);
    for _ in 0..ROUNDS {
        let form: Form = random.form(&[4, 4], 3, Weights::Positive);
        let at = [random.unit(), random.unit()];
        let found = assert_nearest(&form, &form.at(&at).unwrap(), 30);
        assert!(found.distances[0] < 1e-14, "{found:?}");
        assert!(found.gaps[0] <= found.distances[0]);
    }
}

#[test]
fn collapsed_edges_and_equal_poles_are_answered() {
    let sphere = octant(1.0);
    // Straight above the pole, at which an edge is collapsed.
    let found = assert_nearest(&sphere, &[0., 0., 2., 0., 0., 1., 0., 0., 0.25], 40);
    assert!((found.distances[0] - 1.0).abs() < 1e-15 && !found.unique[0], "{found:?}");
    assert!(found.distances[1] < 1e-15);
    let dot: Form = Form::from_points(&[3, 4], 2, &[1.0; 24], None).unwrap();
    let found = foot(&dot, &[4., 5., 1., 1.]);
    assert_eq!(found.distances, [5.0, 0.0]);
    assert_eq!(found.unique, [false, false]);
    let line: Form = Form::from_points(
        &[3, 3],
        2,
        &[0., 0., 0., 0., 0., 0., 1., 1., 1., 1., 1., 1., 2., 2., 2., 2., 2., 2.],
        None,
    )
    .unwrap();
    let found = assert_nearest(&line, &[0., 2., 3., 3., 0.3, 0.3], 20);
    assert!((found.distances[0] - 2.0_f64.sqrt()).abs() < 1e-14 && !found.unique[0]);
    let cusp: Form = Form::from_points(&[4], 2, &[0., 0., 1., 1., 0., 1., 1., 0.], None).unwrap();
    assert_nearest(&cusp, &[0.5, 2.0, 0.5, 0.75, 0.5, 0.0, 0.5, 0.8], 4000);
}

#[test]
fn centres_of_curvature_are_answered() {
    // The parabola y = x²/2 has radius 1 at its vertex: the square distance from (0, 1) is flat there.
    let parabola: Form = Form::from_points(&[3], 2, &[-2., 2., 0., -2., 2., 2.], None).unwrap();
    let found = assert_nearest(&parabola, &[0., 1., 0., 1.0001, 0., 0.9999, 0., 3.0], 4000);
    assert!((found.distances[0] - 1.0).abs() < 1e-13);
    assert_eq!(found.unique[1..], [false, true, false]);
    assert!(found.parameters[1] < 0.5 && found.parameters[3] < 0.5); // the first of the two
    let torus = torus(3.0, 1.0);
    assert_nearest(&torus, &[0., 0., 0., 0., 0., 1., 2.0, 2.0, 0.1, 3.0, 0.0, 0.0], 60);
}

#[test]
fn scale_and_place_do_not_matter() {
    let mut random = Random::new(5);
    let form: Form = random.form(&[4, 3], 3, Weights::Positive);
    let points: Vec<f64> = (0..30).map(|_| 4.0 * random.unit() - 2.0).collect();
    let found = project(&form, &points, ACCURACY).unwrap();
    for factor in [2.0_f64.powi(500), 2.0_f64.powi(-500)] {
        let scaled = |list: &[f64]| -> Vec<f64> { list.iter().map(|x| x * factor).collect() };
        let mut poles = form.homogeneous().to_vec();
        for (i, x) in poles.iter_mut().enumerate() {
            *x *= if i % 4 < 3 { factor } else { 1.0 };
        }
        let large = Form::from_homogeneous(form.orders(), 3, poles).unwrap();
        let other = project(&large, &scaled(&points), ACCURACY).unwrap();
        assert_eq!(other.parameters, found.parameters);
        assert_eq!(other.distances, scaled(&found.distances));
        assert_eq!(other.gaps, scaled(&found.gaps));
    }
    let far = moved(&form, [1e6, -2e6, 3e6]);
    let away: Vec<f64> =
        points.chunks(3).flat_map(|p| [p[0] + 1e6, p[1] - 2e6, p[2] + 3e6]).collect();
    let other = project(&far, &away, ACCURACY).unwrap();
    for (a, b) in found.distances.iter().zip(&other.distances) {
        assert!((a - b).abs() < 1e-8, "{a} {b}");
    }
}

#[test]
fn points_far_away_are_answered() {
    let mut random = Random::new(9);
    let form: Form = random.form(&[4, 4], 3, Weights::Positive);
    for distance in [1e1, 1e3, 1e6, 1e9, 1e15, 1e30, 1e100] {
        let found = foot(&form, &[distance, -0.3 * distance, 0.5 * distance]);
        assert!(found.gaps[0] <= 1e-11 * distance, "{distance}: {found:?}");
    }
}

#[test]
fn a_point_has_a_distance() {
    let point: Form = Form::point(&[3.0, 4.0]).unwrap();
    let found = foot(&point, &[0.0, 0.0]);
    assert_eq!((found.distances[0], found.points), (5.0, vec![3.0, 4.0]));
    assert_eq!((found.parameters.len(), found.unique[0]), (0, true));
    let still: Form = Form::from_points(&[1, 2], 1, &[0.0, 2.0], None).unwrap();
    let found = foot(&still, &[0.5]);
    assert_eq!((found.parameters, found.unique), (vec![0.0, 0.25], vec![false]));
    assert!(foot(&still, &[]).distances.is_empty());
}

#[test]
fn what_cannot_be_answered_is_refused() {
    let curve: Form = Form::from_points(&[2], 2, &[0., 0., 1., 0.], None).unwrap();
    assert_eq!(family(project(&curve, &[1.0], ACCURACY)), "Shape");
    assert_eq!(family(project(&curve, &[1.0, f64::NAN], ACCURACY)), "Domain");
    assert_eq!(family(project(&curve, &[1.0, f64::INFINITY], ACCURACY)), "Domain");
    assert_eq!(family(project(&curve, &[1.0, 1e300], ACCURACY)), "Domain");
    for accuracy in [-1.0, 2.0, f64::NAN] {
        assert_eq!(family(project(&curve, &[1.0, 1.0], accuracy)), "Domain");
    }
    let through: Form = Form::from_homogeneous(&[2], 1, vec![0., 1., 1., -1.]).unwrap();
    assert_eq!(family(project(&through, &[1.0], ACCURACY)), "Domain");
    let negative: Form =
        Form::from_homogeneous(&[3], 2, vec![-1., 0., -1., 0., 0., 0.5, 0., -1., -1.]).unwrap();
    assert_nearest(&negative, &[0.0, 0.0, 2.0, 2.0], 4000);
}

#[test]
fn equal_weights_of_any_size_change_nothing() {
    for ambient in [2, 3] {
        for orders in [vec![3], vec![4, 3]] {
            let form = Random::new(7).rough_form(&orders, ambient, Weights::One);
            let points: Vec<f64> = (0..30 * ambient).map(|k| 2.0 * (k as f64).sin()).collect();
            let plain = assert_nearest(&form, &points, 40);
            for weight in [3.0, -0.7, 1e3, 1e-10, 1e100, 1e-300] {
                let poles = form.homogeneous().iter().map(|x| x * weight).collect();
                let heavy = Form::from_homogeneous(&orders, ambient, poles).unwrap();
                let found = project(&heavy, &points, ACCURACY).unwrap();
                for (x, y) in found.distances.iter().zip(&plain.distances) {
                    // The poles differ by a rounding each.
                    assert!((x - y).abs() < 1e-14, "weight {weight}: {x} and {y}");
                }
            }
        }
    }
}

#[test]
fn a_gap_is_a_number_and_a_degree_too_high_is_refused_at_once() {
    let thin =
        Form::from_points(&[3], 2, &[0., 0., 1., 1., 2., 0.], Some(&[1e-100, 1., 1.])).unwrap();
    let found = foot(&thin, &[0.0, 0.0]);
    assert!(found.gaps[0] >= 0.0 && found.gaps[0] <= found.distances[0]);
    let long = Random::new(1).rough_form(&[1000], 3, Weights::One);
    assert_eq!(family(project(&long, &[0.0; 3], ACCURACY)), "Accuracy");
}
