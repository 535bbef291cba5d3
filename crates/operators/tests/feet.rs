//! All feet of a point: closed forms, ends and kinks, feet that fill curves.
#![allow(clippy::unwrap_used)]

use pforms_kernel::Form;
use pforms_operators::{
    Feet, FootKind, Part, Shape, Spline, circle, ellipse, project, project_all, sphere, torus,
};
use pforms_testkit::{Random, Weights};

fn feet(shape: &Shape, point: &[f64]) -> Feet {
    project_all(shape, point, 1e-12).unwrap().remove(0)
}

fn kinds(feet: &Feet) -> Vec<FootKind> {
    feet.feet.iter().map(|foot| foot.kind).collect()
}

#[test]
fn an_ellipse_has_four_feet_inside_its_evolute_and_two_outside() {
    let shape = ellipse(&2.0, &1.0, Part::Pieces).unwrap();
    // The evolute is (a·x)^⅔ + (b·y)^⅔ = (a² − b²)^⅔. The first foot is at the seam and at both ends.
    for (point, count) in [([0.3, 0.2, 0.0], 4), ([1.2, 0.9, 0.0], 2), ([-0.6, 0.5, 0.3], 4)] {
        let found = feet(&shape, &point);
        assert!(found.complete(), "{found:?}");
        assert_eq!(found.feet.len(), count, "{found:?}");
        for foot in &found.feet {
            // A foot (x, y) with (x − p)·y/b² = (y − q)·x/a².
            let [x, y] = [foot.point[0], foot.point[1]];
            assert!((x * x / 4.0 + y * y - 1.0).abs() < 1e-14);
            assert!(((x - point[0]) * y - (y - point[1]) * x / 4.0).abs() < 1e-13, "{foot:?}");
        }
        let minima = found.feet.iter().filter(|foot| foot.kind == FootKind::Minimum).count();
        assert_eq!(minima, count / 2, "{:?}", kinds(&found));
    }
}

#[test]
fn a_torus_has_four_feet() {
    let shape = torus(&2.0, &0.5, Part::Pieces).unwrap();
    let point = [1.1, 0.7, 0.4];
    let found = feet(&shape, &point);
    assert!(found.complete(), "{found:?}");
    // In the plane through the axis, Oy, and the point, in and out on the circles on either side.
    let across = 1.1_f64.hypot(0.4);
    let mut expected: Vec<f64> = [across - 2.0, across + 2.0]
        .iter()
        .flat_map(|d: &f64| [(d.hypot(0.7) - 0.5).abs(), d.hypot(0.7) + 0.5])
        .collect();
    expected.sort_by(f64::total_cmp);
    let mut distances: Vec<f64> = found.feet.iter().map(|foot| foot.distance).collect();
    distances.sort_by(f64::total_cmp);
    assert_eq!(distances.len(), 4, "{found:?}");
    for (a, b) in distances.iter().zip(&expected) {
        assert!((a - b).abs() < 1e-14, "{distances:?} {expected:?}");
    }
    let count = |kind| kinds(&found).iter().filter(|x| **x == kind).count();
    assert_eq!(
        [FootKind::Minimum, FootKind::Maximum, FootKind::Saddle].map(count),
        [1, 1, 2],
        "{found:?}"
    );
}

#[test]
fn the_centre_of_a_circle_and_of_a_sphere_is_a_doubt_about_all_of_it() {
    let round = circle(&3.0, Part::Pieces).unwrap();
    let found = feet(&round, &[0.0, 0.0, 0.0]);
    assert!(!found.complete());
    let length: f64 = found.doubts.iter().map(|doubt| doubt.upper[0] - doubt.lower[0]).sum();
    assert!((length - 4.0).abs() < 1e-12 || (length - 1.0).abs() < 1e-12, "{found:?}");
    let ball = sphere(&1.0, Part::Octant).unwrap();
    let found = feet(&ball, &[0.0, 0.0, 0.0]);
    let doubt = found
        .doubts
        .iter()
        .find(|doubt| (0..2).all(|axis| doubt.lower[axis] == 0.0 && doubt.upper[axis] == 1.0));
    assert!(doubt.is_some(), "{found:?}");
    // From elsewhere there is one foot on the ray.
    let found = feet(&ball, &[0.6, 0.8, 0.3]);
    assert_eq!(found.feet.len(), 1, "{found:?}");
    assert!(found.complete() && found.feet[0].kind == FootKind::Minimum);
}

#[test]
fn the_centre_of_curvature_is_a_doubt_at_its_vertex() {
    // The evolute of the ellipse has a cusp at (0, −3): three feet fall together at (0, 1).
    let found = feet(&ellipse(&2.0, &1.0, Part::Pieces).unwrap(), &[0.0, -3.0, 0.0]);
    assert!(!found.complete());
    for foot in &found.feet {
        let far = foot.point[1] > 0.0;
        assert_eq!((foot.proved, foot.kind == FootKind::Flat), (!far, far), "{found:?}");
    }
    assert!(
        found
            .doubts
            .iter()
            .all(|doubt| (doubt.lower[0] - 0.25).abs() < 1e-2 || doubt.lower[0] > 0.9)
    );
}

#[test]
fn ends_count_where_the_distance_does_not_fall() {
    let line: Form = Form::from_points(&[2], 2, &[0., 0., 4., 0.], None).unwrap();
    for (point, at) in
        [([1.0, 3.0], 0.25), ([-1.0, 3.0], 0.0), ([5.0, 0.0], 1.0), ([4.0, 1.0], 1.0)]
    {
        let found = feet(&line.clone().into(), &point);
        assert_eq!(found.feet.len(), 1, "{found:?}");
        assert_eq!(found.feet[0].parameters, [at]);
        assert!(found.complete());
    }
}

#[test]
fn a_kink_is_a_foot_from_outside_only() {
    let net: Form = Form::from_points(&[3], 2, &[0., 0., 2., 0., 2., 2.], None).unwrap();
    let corner = Spline::new(net, &[1], vec![vec![0., 0., 1., 2., 2.]]).unwrap();
    let outside = feet(&corner.clone().into(), &[3., -1.]);
    assert_eq!(outside.feet.len(), 1, "{outside:?}");
    assert_eq!(outside.feet[0].parameters, [1.0]);
    let inside = feet(&corner.into(), &[1.5, 0.75]);
    let places: Vec<f64> = inside.feet.iter().map(|foot| foot.parameters[0]).collect();
    assert_eq!(places, [0.75, 1.375]);
}

#[test]
fn every_local_minimum_on_a_grid_is_near_a_foot() {
    let mut random = Random::new(7);
    for _ in 0..12 {
        let form: Form = random.rough_form(&[4, 3], 3, Weights::Positive);
        let point: Vec<f64> = (0..3).map(|_| 2.0 * random.unit() - 1.0).collect();
        let found = feet(&form.clone().into(), &point);
        assert!(found.complete(), "{found:?}");
        let nearest = project(&form, &point, 1e-12).unwrap();
        let least = found.feet.iter().map(|foot| foot.distance).fold(f64::INFINITY, f64::min);
        assert!((least - nearest.distances[0]).abs() < 1e-12 * (1.0 + least), "{found:?}");
        let n = 60_usize;
        let at = |i: usize, j: usize| {
            let p = form.at(&[i as f64 / n as f64, j as f64 / n as f64]).unwrap();
            p.iter().zip(&point).map(|(x, y)| (x - y) * (x - y)).sum::<f64>()
        };
        for i in 1..n {
            for j in 1..n {
                let here = at(i, j);
                let lowest = (0..9).all(|k| at(i + k / 3 - 1, j + k % 3 - 1) >= here);
                let near = |foot: &pforms_operators::Foot| {
                    (foot.parameters[0] * n as f64 - i as f64).abs() < 6.0
                        && (foot.parameters[1] * n as f64 - j as f64).abs() < 6.0
                };
                assert!(!lowest || found.feet.iter().any(near), "{i} {j}: {found:?}");
            }
        }
    }
}

#[test]
fn bad_input_is_named() {
    let point: Form = Form::point(&[1.0, 2.0]).unwrap();
    assert_eq!(project_all(&point.into(), &[0., 0.], 1e-12).unwrap_err().family(), "Shape");
    let line: Form = Form::from_points(&[2], 2, &[0., 0., 4., 0.], None).unwrap();
    let line: Shape = line.into();
    assert_eq!(project_all(&line, &[0.], 1e-12).unwrap_err().family(), "Shape");
    assert_eq!(project_all(&line, &[0., f64::NAN], 1e-12).unwrap_err().family(), "Domain");
    assert_eq!(project_all(&line, &[0., 0.], 2.0).unwrap_err().family(), "Domain");
    let through: Form = Form::from_homogeneous(&[2], 1, vec![0., 1., 1., -1.]).unwrap();
    assert_eq!(project_all(&through.into(), &[0.], 1e-12).unwrap_err().family(), "Domain");
    let dot: Form = Form::from_points(&[3], 2, &[1., 1., 1., 1., 1., 1.], None).unwrap();
    let found = feet(&dot.into(), &[0., 0.]);
    assert!(!found.complete() && !found.feet.is_empty(), "{found:?}");
}
