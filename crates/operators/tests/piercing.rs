//! Curves and surfaces: crossings, contacts of every order, arcs in the surface.
#![allow(clippy::unwrap_used)]

use pforms_kernel::Form;
use pforms_operators::{ContactKind, Intersections, Part, Shape, intersect, sphere, translate};

fn curve(points: &[[f64; 3]]) -> Shape {
    Form::from_points(&[points.len()], 3, &points.concat(), None).unwrap().into()
}

/// The square from −1 to 1 in the plane z = 0, as a bilinear form.
fn square() -> Shape {
    let points = [-1., -1., 0., -1., 1., 0., 1., -1., 0., 1., 1., 0.];
    Form::from_points(&[2, 2], 3, &points, None).unwrap().into()
}

/// `z = height + x^order` over `x` from −1 to 1, drawn along `y = x/3`.
fn power(order: usize, height: f64) -> Shape {
    let points: Vec<[f64; 3]> = (0..=order)
        .map(|i| {
            let x = -1.0 + 2.0 * i as f64 / order as f64;
            // The blossom of xⁿ at i ones and n − i minus ones.
            let z = if (order - i).is_multiple_of(2) { 1.0 } else { -1.0 };
            [x, x / 3.0, height + z]
        })
        .collect();
    curve(&points)
}

fn met(a: &Shape, b: &Shape) -> Intersections {
    intersect(a, b, 1e-14).unwrap()
}

#[test]
fn a_line_goes_twice_through_a_sphere() {
    let ball = sphere(&1.0, Part::Pieces).unwrap();
    let found = met(&curve(&[[-2., 0.3, 0.4], [2., 0.3, 0.4]]), &ball);
    assert!(found.complete && found.contacts.len() == 2, "{found:?}");
    for (contact, sign) in found.contacts.iter().zip([-1.0, 1.0]) {
        assert!(contact.proved && contact.kind == ContactKind::Crossing && contact.gap == 0.0);
        let x = sign * 0.75_f64.sqrt();
        assert!((contact.point[0] - x).abs() < 1e-14, "{contact:?}");
        assert!((contact.first[0] - (x + 2.0) / 4.0).abs() <= contact.error, "{contact:?}");
    }
}

#[test]
fn contacts_of_every_order_are_one_place() {
    for order in 2..=7 {
        let found = met(&power(order, 0.0), &square());
        assert!(found.complete, "{order}: {found:?}");
        assert_eq!(found.contacts.len(), 1, "{order}: {found:?}");
        let contact = &found.contacts[0];
        assert_eq!((contact.kind, contact.order), (ContactKind::Tangent, order), "{contact:?}");
        assert!((contact.first[0] - 0.5).abs() <= contact.error, "{contact:?}");
        // Within what rounding lets such a contact be known to.
        let known = f64::EPSILON.powf(1.0 / order as f64);
        assert!(contact.error < 16.0 * known, "{order}: {contact:?}");
    }
}

#[test]
fn close_crossings_are_two_and_a_gap_is_none() {
    for height in [1e-4, 1e-8, 1e-12] {
        let two = met(&power(2, -height), &square());
        assert!(two.complete && two.contacts.len() == 2, "{height}: {two:?}");
        assert!(two.contacts.iter().all(|contact| contact.proved));
        let none = met(&power(2, height), &square());
        assert!(none.complete && none.contacts.is_empty(), "{height}: {none:?}");
    }
    // Three crossings as near to each other as this: z = x³ − x·near².
    for near in [1e-2_f64, 1e-3, 1e-4] {
        let third = near * near / 3.0;
        let points = [
            [-1., 0., -1. + 3. * third],
            [-1. / 3., 0., 1. + third],
            [1. / 3., 0., -1. - third],
            [1., 0., 1. - 3. * third],
        ];
        let three = met(&curve(&points), &square());
        assert!(three.complete && three.contacts.len() == 3, "{near}: {three:?}");
        for (contact, x) in three.contacts.iter().zip([-near, 0.0, near]) {
            // Slopes are near², and heights carry a rounding of 1.
            let known = 16.0 * f64::EPSILON / (near * near);
            assert!((contact.point[0] - x).abs() < known, "{near}: {three:?}");
            assert!(contact.proved || near < 1e-3, "{near}: {three:?}");
        }
    }
}

#[test]
fn arcs_in_the_surface_are_overlaps() {
    // Half of the line is over the square.
    let line = curve(&[[0., 0.5, 0.], [2., 0.5, 0.]]);
    let found = met(&line, &square());
    assert!(found.complete && found.contacts.is_empty(), "{found:?}");
    assert_eq!(found.overlaps.len(), 1);
    let overlap = &found.overlaps[0];
    assert!(overlap.first[0][0] == 0.0 && (overlap.first[1][0] - 0.5).abs() < 1e-13, "{found:?}");
    assert!((overlap.second[1][0] - 1.0).abs() < 1e-13 && overlap.gap < 1e-13);
    // The rulings of a hyperbolic paraboloid lie in it; a line between two of them crosses.
    let saddle: Shape =
        Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 1.], None)
            .unwrap()
            .into();
    let found = met(&curve(&[[0.25, 0., 0.], [0.25, 1., 0.25]]), &saddle);
    assert!(found.overlaps.len() == 1 && found.complete, "{found:?}");
    let found = met(&curve(&[[0., 0., 0.], [1., 1., 1.]]), &saddle);
    assert!(found.overlaps.is_empty() && found.contacts.len() == 2, "{found:?}");
    // A circle of latitude of a sphere.
    let octant = sphere(&1.0, Part::Octant).unwrap();
    let Shape::Form(form) = &octant else { unreachable!() };
    for axis in 0..2 {
        let circle: Shape = pforms_operators::sub(form, axis, &0.5).unwrap().into();
        let found = met(&circle, &octant);
        assert!(found.overlaps.len() == 1 && found.contacts.is_empty(), "{axis} {found:?}");
        let overlap = &found.overlaps[0];
        assert_eq!((overlap.first[0][0], overlap.first[1][0]), (0.0, 1.0), "{found:?}");
    }
}

#[test]
fn a_tangent_of_a_sphere_touches_once() {
    let ball = sphere(&1.0, Part::Pieces).unwrap();
    // At (0.48, 0.6, 0.64), along (0.8, 0, −0.6).
    let line = curve(&[[-0.32, 0.6, 1.24], [1.28, 0.6, 0.04]]);
    let found = met(&line, &ball);
    assert_eq!(found.contacts.len(), 1, "{found:?}");
    let contact = &found.contacts[0];
    assert_eq!((contact.kind, contact.order), (ContactKind::Tangent, 2), "{found:?}");
    assert!((contact.first[0] - 0.5).abs() < 1e-9 && found.complete, "{found:?}");
}

#[test]
fn a_line_through_the_pole_of_a_sphere() {
    let octant = sphere(&1.0, Part::Octant).unwrap();
    let found = met(&curve(&[[0.1, 2., 0.2], [-0.1, 0., -0.2]]), &octant);
    assert_eq!(found.contacts.len(), 1, "{found:?}");
    let contact = &found.contacts[0];
    assert_eq!(contact.kind, ContactKind::Crossing, "{found:?}");
    assert!((contact.first[0] - 0.5).abs() < 1e-12, "{found:?}");
}

#[test]
fn ends_touch_and_miss() {
    let end = met(&curve(&[[0.2, 0.3, 0.], [0.2, 0.3, 1.]]), &square());
    assert!(end.contacts.len() == 1 && end.contacts[0].first == [0.0], "{end:?}");
    let edge = met(&curve(&[[1., 0.3, -1.], [1., 0.3, 1.]]), &square());
    assert!(edge.contacts.len() == 1 && edge.contacts[0].second[0] == 1.0, "{edge:?}");
    let past = met(&curve(&[[1. + 1e-9, 0.3, -1.], [1. + 1e-9, 0.3, 1.]]), &square());
    assert!(past.complete && past.contacts.is_empty(), "{past:?}");
    let far = translate(&square(), &[0., 0., 3.]).unwrap();
    let none = met(&power(2, 0.0), &far);
    assert!(none.complete && none.contacts.is_empty());
}

#[test]
fn bad_input_is_named() {
    let plane: Shape =
        Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., 1., 1.], None).unwrap().into();
    let line: Shape = Form::from_points(&[2], 2, &[0., 0., 1., 1.], None).unwrap().into();
    assert_eq!(intersect(&line, &plane, 1e-14).unwrap_err().family(), "Shape");
    let infinite: Shape =
        Form::from_homogeneous(&[2], 3, vec![0., 0., 0., 1., 1., 0., 0., -1.]).unwrap().into();
    assert_eq!(intersect(&infinite, &square(), 1e-14).unwrap_err().family(), "Domain");
}
