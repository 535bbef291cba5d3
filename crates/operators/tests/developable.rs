//! Tangent developables, the certificate of developability, and unrolling.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};
use std::slice::from_ref;

use pforms_kernel::{Error, Form, Rational, Scalar};
use pforms_operators::{
    Distortion, Spline, derivative, gauss_form, is_developable, stretch, surface_frame,
    tangent_developable, tangent_developable_of_spline, transpose, unroll,
};
use pforms_testkit::{Random, Weights, octant};

/// A quarter of a cone about z: radius 1 at height 0, 0 at height 2.
fn cone() -> Form {
    let arc = [[1., 0., 1.], [FRAC_1_SQRT_2, FRAC_1_SQRT_2, FRAC_1_SQRT_2], [0., 1., 1.]];
    let poles = arc.iter().flat_map(|[x, y, w]| [*x, *y, 0., *w, 0., 0., 2.0 * w, *w]);
    Form::from_homogeneous(&[3, 2], 3, poles.collect()).unwrap()
}

fn helix_like() -> Form {
    Form::from_points(&[4], 3, &[0., 0., 0., 1., 0., 0., 2., 1., 0., 3., 3., 1.], None).unwrap()
}

#[test]
fn a_tangent_developable_is_the_curve_and_its_derivative_exactly() {
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let weights = if seed % 2 == 0 { Weights::One } else { Weights::Positive };
        let orders = [random.size(3, 5)];
        let curve: Form<Rational> = random.form(&orders, 3, weights);
        let length = random.fraction::<Rational>();
        if length.is_zero() {
            continue;
        }
        let surface = tangent_developable(&curve, &length).unwrap();
        let slope = derivative(&curve, &[1]).unwrap();
        for _ in 0..4 {
            let (u, v) = (random.parameter::<Rational>(), random.parameter::<Rational>());
            let (Ok(point), Ok(step)) = (curve.at(from_ref(&v)), slope.at(from_ref(&v))) else {
                continue;
            };
            let wanted: Vec<Rational> =
                point.iter().zip(&step).map(|(x, d)| x + &u * &length * d).collect();
            assert_eq!(surface.at(&[u, v]).unwrap(), wanted);
        }
        if curve.orders()[0] < 5 {
            assert!(gauss_form(&surface).unwrap().homogeneous().chunks(2).all(|p| p[0].is_zero()));
        }
    }
}

#[test]
fn its_orders_are_those_of_the_book_and_of_the_quotient() {
    assert_eq!(tangent_developable(&helix_like(), &1.0).unwrap().kind().to_string(), "pS24");
    let mut random = Random::new(3);
    let rational: Form<Rational> = random.form(&[4], 3, Weights::Positive);
    let surface = tangent_developable(&rational, &Rational::from_integer(2.into())).unwrap();
    assert_eq!(surface.kind().to_string(), "pS27");
}

#[test]
fn a_spline_has_tangents_by_its_own_parameter() {
    let net = Form::from_points(
        &[5],
        3,
        &[0., 0., 0., 1., 2., 0., 2., 0., 1., 4., 1., 0., 5., 0., 0.],
        None,
    );
    let spline =
        Spline::new(net.unwrap(), &[2], vec![vec![0., 0., 0., 1., 3., 4., 4., 4.]]).unwrap();
    let surface = tangent_developable_of_spline(&spline, &0.5).unwrap();
    let slope = spline.derivative(&[1]).unwrap();
    for t in [0.0, 0.7, 1.0, 2.0, 3.5, 4.0] {
        let (p, d) = (spline.at(&[t]).unwrap(), slope.at(&[t]).unwrap());
        let q = surface.at(&[1.0, t]).unwrap();
        assert!(q.iter().zip(p.iter().zip(&d)).all(|(q, (p, d))| (q - p - 0.5 * d).abs() < 1e-14));
    }
    assert!(is_developable(surface).unwrap().developable);
}

#[test]
fn cones_cylinders_and_planes_are_developable_and_others_are_not() {
    let found = is_developable(cone()).unwrap();
    assert!(found.developable && found.gauss == 0.0 && found.parameters.is_empty());
    // In any parametrisation: turned, extended, immersed in itself.
    let turned = stretch(&transpose(&cone(), &[1, 0]).unwrap(), &[0.9, -0.2], &[0.1, 0.7]).unwrap();
    assert!(is_developable(turned).unwrap().developable);
    let skew: Form<Rational> = {
        // The plane z = x + y over a grid bent within it.
        let mut random = Random::new(4);
        let flat: Form<Rational> = random.form(&[3, 3], 2, Weights::Positive);
        let poles = flat.homogeneous().chunks_exact(3);
        let lifted = poles.flat_map(|p| [p[0].clone(), p[1].clone(), &p[0] + &p[1], p[2].clone()]);
        Form::from_homogeneous(&[3, 3], 3, lifted.collect()).unwrap()
    };
    assert!(is_developable(skew).unwrap().exact);
    let sphere = is_developable(octant([1.0; 3])).unwrap();
    assert!(!sphere.developable && !sphere.exact && (sphere.gauss - 1.0).abs() < 1e-12);
    assert_eq!(sphere.parameters.len(), 2);
    let saddle =
        Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 1e-5], None);
    assert!(!is_developable(saddle.unwrap()).unwrap().developable, "a little is not nothing");
}

#[test]
fn the_numerator_is_the_gauss_curvature() {
    for (weights, seed) in [(Weights::One, 11), (Weights::Positive, 12)] {
        let form = Random::new(seed).rough_form(&[3, 4], 3, weights);
        let gauss = gauss_form(&form).unwrap();
        for at in [[0.2, 0.7], [0.5, 0.1]] {
            let frame = surface_frame(&form, at[0], at[1]).unwrap();
            let weight = form.homogeneous_at(&at).unwrap()[3];
            let size = weight.powi(3) * frame.area;
            let value = gauss.at(&at).unwrap()[0] * weight * weight / size.powi(4);
            let wanted = frame.curvature.unwrap().gauss;
            assert!((value / wanted - 1.0).abs() < 1e-9, "{value} {wanted}");
        }
    }
}

#[test]
fn rounding_does_not_hide_a_cone_anywhere() {
    for (scale, offset) in [(1e-3, 1e3), (1e120, 0.0), (1e-120, 0.0)] {
        let poles = cone();
        let moved = poles.homogeneous().chunks_exact(4).flat_map(|p| {
            [p[0] * scale + offset * p[3], p[1] * scale, p[2] * scale - offset * p[3], p[3]]
        });
        let moved = Form::from_homogeneous(&[3, 2], 3, moved.collect()).unwrap();
        let found = is_developable(moved).unwrap();
        assert!(found.developable, "{scale} {found:?}");
    }
}

#[test]
fn true_developables_are_unrolled_without_distortion() {
    let tangents = tangent_developable(&helix_like(), &1.0).unwrap();
    let cylinder = Form::from_points(
        &[4, 2],
        3,
        &[
            0., 0., 0., 0., 0., 1., 1., 2., 0., 1., 2., 1., 2., -1., 0., 2., -1., 1., 3., 1., 0.,
            3., 1., 1.,
        ],
        None,
    )
    .unwrap();
    for surface in [cone(), cylinder, tangents, transpose(&cone(), &[1, 0]).unwrap()] {
        let found = unroll(surface, 1e-12).unwrap();
        let worst = found.distortion;
        assert!(worst.length < 1e-9 && worst.area < 1e-9 && worst.angle < 1e-9, "{worst:?}");
    }
}

#[test]
fn a_cone_becomes_a_sector() {
    let flat = unroll(cone(), 1e-12).unwrap().spline;
    let slant = 5.0_f64.sqrt();
    let apex = flat.at(&[0.0, 1.0]).unwrap();
    let from_apex = |u: f64, v: f64| {
        let p = flat.at(&[u, v]).unwrap();
        [p[0] - apex[0], p[1] - apex[1]]
    };
    for u in [0.0, 0.3, 1.0] {
        let p = from_apex(u, 0.0);
        assert!((p[0].hypot(p[1]) - slant).abs() < 1e-11);
        let q = from_apex(u, 1.0);
        assert!(q[0].hypot(q[1]) < 1e-11, "the apex stays a point");
    }
    let (a, b) = (from_apex(0.0, 0.0), from_apex(1.0, 0.0));
    let angle = (a[0] * b[0] + a[1] * b[1]) / 5.0;
    // An arc of π/2 on a radius √5.
    assert!((angle.acos() - FRAC_PI_2 / slant).abs() < 1e-11);
}

#[test]
fn a_spline_is_unrolled_across_its_knots_and_folds() {
    // A strip folded at a right angle: three units of plane, up, then along.
    let net = [
        0., 0., 0., 0., 2., 0., 1., 0., 0., 1., 2., 0., 1., 0., 1., 1., 2., 1., 2., 0., 1., 2., 2.,
        1.,
    ];
    let net = Form::from_points(&[4, 2], 3, &net, None).unwrap();
    let strip = Spline::joined(net, &[1, 1], &[vec![0., 1., 2., 3.], vec![0., 1.]]).unwrap();
    let found = unroll(strip, 1e-12).unwrap();
    assert!(found.distortion.length < 1e-12, "{:?}", found.distortion);
    let (a, b) = (found.spline.at(&[0.0, 0.0]).unwrap(), found.spline.at(&[3.0, 0.0]).unwrap());
    assert!(((a[0] - b[0]).hypot(a[1] - b[1]) - 3.0).abs() < 1e-12, "a straight strip of length 3");
}

#[test]
fn a_sphere_is_stretched_and_says_so() {
    let found = unroll(octant([1.0; 3]), 1e-9).unwrap();
    let Distortion { length, angle, area } = found.distortion;
    assert!(length > 0.05 && area > 0.05 && angle > 0.01, "{:?}", found.distortion);
    assert!(length < 1.0);
}

#[test]
fn size_does_not_matter() {
    for exponent in [-200, 150] {
        let scale = 2.0_f64.powi(exponent);
        let poles = cone()
            .homogeneous()
            .chunks_exact(4)
            .flat_map(|p| [p[0] * scale, p[1] * scale, p[2] * scale, p[3]])
            .collect();
        let found = unroll(Form::from_homogeneous(&[3, 2], 3, poles).unwrap(), 1e-12).unwrap();
        assert!(found.distortion.length < 1e-9);
        let (a, b) = (found.spline.at(&[0.0, 0.0]).unwrap(), found.spline.at(&[0.0, 1.0]).unwrap());
        assert!(((a[0] - b[0]).hypot(a[1] - b[1]) / scale - 5.0_f64.sqrt()).abs() < 1e-11);
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let line =
        Form::from_points(&[3], 3, &[0., 0., 0., 0.1, 0.1, 0.3, 0.2, 0.2, 0.6], None).unwrap();
    assert!(matches!(tangent_developable(&line, &1.0), Err(Error::Degenerate(_))));
    assert!(matches!(tangent_developable(&helix_like(), &0.0), Err(Error::Degenerate(_))));
    assert!(matches!(tangent_developable(&cone(), &1.0), Err(Error::Shape(_))));
    assert!(matches!(is_developable(helix_like()), Err(Error::Shape(_))));
    let collapsed =
        Form::from_points(&[2, 2], 3, &[0., 0., 0., 1., 1., 1., 2., 2., 2., 3., 3., 3.], None);
    assert!(matches!(is_developable(collapsed.clone().unwrap()), Err(Error::Degenerate(_))));
    assert!(matches!(unroll(collapsed.unwrap(), 1e-9), Err(Error::Degenerate(_))));
    assert!(matches!(unroll(cone(), 0.0), Err(Error::Domain(_))));
    assert!(matches!(unroll(helix_like(), 1e-9), Err(Error::Shape(_))));
}
