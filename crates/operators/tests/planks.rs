//! Planks against closed forms, and the laws of developable strips.
#![allow(clippy::unwrap_used)]

use std::f64::consts::PI;
use std::slice::from_ref;

use pforms_kernel::{Error, Form};
use pforms_operators::{
    ArcLength, GeodesicOptions, Heading, Part, Plank, PlankOptions, Spline, cone, cylinder,
    geodesic, planks, sphere, surface_frame, torus,
};

fn line(surface: &Spline, start: [f64; 2], heading: &Heading, length: f64) -> Spline {
    geodesic(surface.clone(), start, heading, length, &GeodesicOptions::default())
        .unwrap()
        .parameters
}

/// A start at shares of the window.
fn share(surface: &Spline, at: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|axis| {
        let (from, to) = surface.window(axis).unwrap();
        from + (to - from) * at[axis]
    })
}

fn segment(ends: [[f64; 2]; 2]) -> Spline {
    Form::from_points(&[2], 2, ends.as_flattened(), None).unwrap().into()
}

fn one(surface: &Spline, line: Spline, width: f64) -> Plank {
    planks(surface.clone(), &[line], width, &PlankOptions::default()).unwrap().pop().unwrap()
}

fn refused(surface: &Spline, line: Spline, width: f64) -> Error {
    planks(surface.clone(), &[line], width, &PlankOptions::default()).unwrap_err()
}

fn corners(plank: &Plank) -> Vec<[f64; 2]> {
    (0..4).map(|k| plank.outline.at(&[f64::from(k)]).unwrap()).map(|p| [p[0], p[1]]).collect()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}

fn close(a: f64, b: f64, by: f64) {
    assert!((a - b).abs() <= by, "{a:e} is not {b:e} to {by:e}");
}

/// An edge in space: 0 for the right one.
fn edge(plank: &Plank, side: usize) -> Spline {
    let poles = plank.strip.net().points().unwrap();
    let row: Vec<f64> =
        poles.chunks(6).flat_map(|pair| pair[3 * side..3 * side + 3].to_vec()).collect();
    let net = Form::from_points(&[row.len() / 3], 3, &row, None).unwrap();
    Spline::on(net, vec![plank.strip.knots()[0].clone()]).unwrap()
}

/// Laws of every plank: edges as long as those of the outline, rulings too, a Gauss curvature of 0.
fn check(plank: &Plank, width: f64, flat: f64) {
    let corners = corners(plank);
    close(corners[0][1], -width / 2.0, 1e-15 * width);
    close(corners[2][1], width / 2.0, 1e-15 * width);
    let (from, to) = plank.strip.window(0).unwrap();
    assert_eq!((from, to), (0.0, plank.length));
    for (side, ends) in [(0, [0, 1]), (1, [3, 2])] {
        let long = ArcLength::new(edge(plank, side), 1e-12).unwrap().length();
        close(long, distance(&corners[ends[0]], &corners[ends[1]]), flat * plank.length);
    }
    for (at, ends) in [(from, [0, 3]), (to, [1, 2])] {
        let ruling =
            distance(&plank.strip.at(&[at, 0.0]).unwrap(), &plank.strip.at(&[at, 1.0]).unwrap());
        close(ruling, distance(&corners[ends[0]], &corners[ends[1]]), flat * width);
    }
    for piece in plank.strip.pieces().unwrap() {
        for u in [0.1, 0.5, 0.9] {
            for v in [0.0, 0.3, 1.0] {
                let bend = surface_frame(&piece, u, v).unwrap().curvature.unwrap();
                let most = plank.bend * plank.bend + 1e-3 / (width * width);
                assert!(bend.gauss.abs() <= 1e-4 * most, "{:e} of {most:e}", bend.gauss);
                let sharpest = bend.principal[0].abs().max(bend.principal[1].abs());
                assert!(sharpest <= plank.bend * 1.02 + 1e-6 / width);
            }
        }
    }
}

#[test]
fn on_a_sphere_planks_are_rectangles_on_tangent_cylinders() {
    for part in [Part::Whole, Part::Pieces] {
        let surface = sphere(&2.0, part).unwrap().into_spline();
        // Along nothing special, along a parallel circle, and over both poles of the parametrisation.
        let start = share(&surface, [0.3, 0.4]);
        for heading in [Heading::Angle(0.4), Heading::Angle(0.0), Heading::Angle(PI / 2.0)] {
            let great = line(&surface, start, &heading, 2.0 * PI);
            let plank = one(&surface, great, 0.5);
            close(plank.length, 2.0 * PI, 1e-9);
            for (corner, true_) in corners(&plank).iter().zip([
                [0.0, -0.25],
                [2.0 * PI, -0.25],
                [2.0 * PI, 0.25],
                [0.0, 0.25],
            ]) {
                assert!(distance(corner, &true_) < 1e-7, "{corner:?} {true_:?}");
            }
            close(plank.lift, 2.0_f64.hypot(0.25) - 2.0, 1e-8);
            close(plank.bend, 0.5, 1e-7);
            close(plank.twist, 0.0, 1e-7);
            assert!(plank.error < 2e-8 && plank.overhang == 0.0 && plank.strain == 0.0);
            check(&plank, 0.5, 1e-7);
        }
    }
}

#[test]
fn on_cylinders_and_cones_planks_lie_on_the_surface() {
    let surface = cylinder(&2.0, &8.0, Part::Pieces).unwrap().into_spline();
    let start = share(&surface, [0.0, 0.0]);
    for (angle, width) in [(0.3, 0.5), (0.8, 0.1), (1.2, 0.2)] {
        let inside = share(&surface, [0.1, 0.1]);
        for start in [start, inside] {
            let plank = one(&surface, line(&surface, start, &Heading::Angle(angle), 6.0), width);
            assert!(plank.lift < 1e-7, "{:e}", plank.lift);
            close(plank.bend, 0.5, 1e-6);
            assert!(plank.widest.is_none_or(|widest| widest > 1e4));
            check(&plank, width, 1e-7);
            // Rulings are generators of the cylinder, which is laid out as height × turn.
            close(plank.slant, PI / 2.0 - angle, 1e-7);
        }
    }
    let surface = cone(&2.0, &3.0, &0.0, Part::Pieces).unwrap().into_spline();
    let plank =
        one(&surface, line(&surface, share(&surface, [0.1, 0.3]), &Heading::Angle(0.4), 1.0), 0.2);
    assert!(plank.lift < 1e-7, "{:e}", plank.lift);
    check(&plank, 0.2, 1e-7);
}

/// On a torus, by Clairaut: a plank from the outer equator over the top is as the surface bends it.
#[test]
fn on_a_torus() {
    for part in [Part::Whole, Part::Pieces] {
        let surface = torus(&3.0, &1.5, part).unwrap().into_spline();
        for (angle, length) in [(1.3, 6.0), (-0.9, 9.0)] {
            let start = share(&surface, [0.1, 0.05]);
            let geodesic = line(&surface, start, &Heading::Angle(angle), length);
            let plank = one(&surface, geodesic.clone(), 0.1);
            check(&plank, 0.1, 1e-7);
            assert!(plank.error < 1e-7 && plank.overhang == 0.0 && plank.strain == 0.0);
            // Half the curvature of the surface along the ruling: at most that of the tube, 1/1.5.
            assert!(plank.lift < 0.05 * 0.05 / 1.5 * 0.51 && plank.lift > 1e-5, "{}", plank.lift);
            assert!(plank.twist <= 0.5 * (1.0 / 1.5 + 1.0 / 1.5) && plank.bend > 1.0 / 4.5);
            let widest = plank.widest.unwrap();
            check(&one(&surface, geodesic.clone(), 0.9 * widest), 0.9 * widest, 1e-6);
            let error = refused(&surface, geodesic, 1.001 * widest);
            assert_eq!(error.family(), "Degenerate", "{error}");
            assert!(error.to_string().contains("width: received"), "{error}");
        }
        // Towards the inner equator at a small angle the surface only twists along the line.
        let start = share(&surface, [0.1, 0.05]);
        let asymptotic = line(&surface, start, &Heading::Angle(0.5), 4.0);
        let error = refused(&surface, asymptotic, 0.1);
        assert!(error.family() == "Degenerate" && error.to_string().contains("twists"), "{error}");
    }
}

#[test]
fn about_the_equator_of_a_torus_the_plank_is_a_hoop() {
    // The outer equator, u = 0, is a circle of radius 4; a circle of the tube has radius 1.
    let surface = torus(&3.0, &1.0, Part::Pieces).unwrap().into_spline();
    for (ends, radius) in [([[0.0, 0.0], [0.0, 1.0]], 4.0), ([[0.0, 0.5], [1.0, 0.5]], 1.0)] {
        let plank = one(&surface, segment(ends), 0.2);
        close(plank.length, 2.0 * PI * radius, 1e-9);
        close(plank.bend, 1.0 / radius, 1e-7);
        close(plank.slant, 0.0, 1e-7);
        check(&plank, 0.2, 1e-7);
    }
}

fn saddle() -> Spline {
    Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 1., 0., 1., 0., 0., 1., 1., 1.], None)
        .unwrap()
        .into()
}

#[test]
fn on_a_straight_line_of_a_saddle_the_board_is_twisted() {
    // z = x·y along y = 0: the normal turns by atan x, the torsion is 1/(1 + x²).
    let plank = one(&saddle(), segment([[0.0, 0.0], [1.0, 0.0]]), 0.2);
    close(plank.twist, 1.0, 1e-9);
    close(plank.strain, 0.1_f64.hypot(1.0) - 1.0, 1e-9);
    close(plank.length, 1.0, 1e-12);
    assert!(plank.bend == 0.0 && plank.widest.is_none() && plank.slant == 0.0);
    let long = ArcLength::new(edge(&plank, 0), 1e-12).unwrap().length();
    assert!(long > 1.0 && long < 1.0 + plank.strain);
    assert!(plank.overhang > 0.09); // half of it lies beyond y = 0
}

#[test]
fn on_a_plane_and_over_an_inflection() {
    let plane: Spline =
        Form::from_points(&[2, 2], 3, &[0., 0., 0., 0., 3., 4., 2., 0., 0., 2., 3., 4.], None)
            .unwrap()
            .into();
    let plank = one(&plane, segment([[0.1, 0.2], [0.9, 0.7]]), 0.25);
    let length = (1.6_f64 * 1.6 + 2.5 * 2.5).sqrt();
    close(plank.length, length, 1e-12);
    assert!(
        plank.lift < 1e-12 && plank.bend == 0.0 && plank.strain == 0.0 && plank.widest.is_none()
    );
    check(&plank, 0.25, 1e-12);
    // y = x³ and y = x⁴, extruded: the surface is flat along one generator, and the planks lie on it.
    for degree in [3, 4] {
        let places: Vec<f64> =
            (0..=degree).map(|k| -1.0 + 2.0 * f64::from(k) / f64::from(degree)).collect();
        // Poles of a power, from −1 to 1: the blossom at k ones and the rest minus ones, averaged over products.
        let height = |k: i32| if (degree - k) % 2 == 0 { 1.0 } else { -1.0 };
        let poles: Vec<f64> = (0..=degree)
            .flat_map(|k| {
                let x = places[usize::try_from(k).unwrap()];
                [x, height(k), 0.0, x, height(k), 2.0]
            })
            .collect();
        let orders = [usize::try_from(degree).unwrap() + 1, 2];
        let wave: Spline = Form::from_points(&orders, 3, &poles, None).unwrap().into();
        let across = geodesic(
            wave.clone(),
            [0.0, 0.1],
            &Heading::Vector(vec![1.0, if degree == 3 { 3.0 } else { -4.0 }, 1.5]),
            9.0,
            &GeodesicOptions::default(),
        )
        .unwrap();
        let plank = one(&wave, across.parameters, 0.1);
        assert!(plank.lift < 1e-7, "{degree}: {:e}", plank.lift);
        assert!(plank.widest.is_none_or(|widest| widest > 1e2), "{:?}", plank.widest);
        assert!(plank.error < 1e-7);
    }
}

#[test]
fn marks_are_symmetric_and_complete() {
    let surface = sphere(&1.0, Part::Pieces).unwrap().into_spline();
    let starts = [[0.1, 0.3], [0.4, 0.5], [0.75, 0.6]];
    let lines: Vec<Spline> = starts
        .iter()
        .zip([0.3, 1.2, 2.2])
        .map(|(start, angle)| {
            line(&surface, share(&surface, *start), &Heading::Angle(angle), 1.999 * PI)
        })
        .collect();
    let found = planks(surface, &lines, 0.1, &PlankOptions::default()).unwrap();
    for (number, plank) in found.iter().enumerate() {
        assert!(plank.complete && plank.overlaps.is_empty());
        // Great circles cross twice.
        assert_eq!(plank.marks.len(), 4, "{:?}", plank.marks);
        for mark in &plank.marks {
            let there = &found[mark.other].marks;
            let back =
                there.iter().find(|back| back.other == number && back.at == mark.other_at).unwrap();
            assert_eq!((back.other_at, back.angle), (mark.at, -mark.angle));
            let points = [(plank, mark.at), (&found[mark.other], mark.other_at)]
                .map(|(plank, at)| plank.line.at(&[at]).unwrap());
            assert!(distance(&points[0], &points[1]) < 1e-8);
        }
        let other = (number + 1) % 3;
        let pair: Vec<_> = plank.marks.iter().filter(|mark| mark.other == other).collect();
        close((pair[1].at - pair[0].at).abs(), PI, 1e-8);
        close(pair[0].angle, -pair[1].angle, 1e-7);
    }
}

#[test]
fn meridians_cross_at_the_poles() {
    let surface = sphere(&1.0, Part::Whole).unwrap().into_spline();
    let lines: Vec<Spline> = [0.1, 0.2]
        .map(|turn| {
            line(&surface, share(&surface, [0.5, turn]), &Heading::Vector(vec![0.0, 1.0, 0.0]), 3.0)
        })
        .to_vec();
    let found = planks(surface, &lines, 0.1, &PlankOptions::default()).unwrap();
    assert_eq!(found[0].marks.len(), 1, "{:?}", found[0].marks);
    close(found[0].marks[0].at, found[0].marks[0].other_at, 1e-8);
    let pole = found[0].line.at(&[found[0].marks[0].at]).unwrap();
    close(pole[1].abs(), 1.0, 1e-8);
}

#[test]
fn at_every_scale() {
    let roof = |size: f64| {
        let poles = [
            0., 0., 0., 1., 0., 1., 2., 0., 0., 0., 1., 1., 1., 1., 3., 2., 1., 1., 0., 2., 0., 1.,
            2., 1., 2., 2., 0.,
        ];
        let poles: Vec<f64> = poles.iter().map(|x| x * size).collect();
        Spline::from(Form::from_points(&[3, 3], 3, &poles, None).unwrap())
    };
    let plank = |size: f64| {
        let across = geodesic(
            roof(size),
            [0.0, 0.4],
            &Heading::Parameters([1.0, 0.1]),
            9.0 * size,
            &GeodesicOptions::default(),
        )
        .unwrap();
        one(&roof(size), across.parameters, 0.1 * size)
    };
    let unit = plank(1.0);
    check(&unit, 0.1, 1e-7);
    for size in [1e-100, 1e100, 1e-3] {
        let other = plank(size);
        close(other.length / size, unit.length, 1e-9);
        close(other.bend * size, unit.bend, 1e-6);
        close(other.lift / size, unit.lift, 1e-7);
        close(other.slant, unit.slant, 1e-7);
        assert!(other.error / size < 1e-7);
    }
}

#[test]
fn what_is_refused() {
    let surface = torus(&3.0, &1.0, Part::Pieces).unwrap().into_spline();
    let good = line(&surface, share(&surface, [0.1, 0.1]), &Heading::Angle(1.3), 2.0);
    let ask = |lines: &[Spline], width: f64, accuracy: f64| {
        let options = PlankOptions { accuracy, ..PlankOptions::default() };
        planks(surface.clone(), lines, width, &options).map(|_| ()).map_err(|error| error.family())
    };
    assert_eq!(ask(from_ref(&good), 0.1, 1e-8), Ok(()));
    for width in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300, 1e300] {
        assert_eq!(ask(from_ref(&good), width, 1e-8), Err("Domain"), "{width}");
    }
    for accuracy in [0.0, -1.0, f64::NAN, 1.0] {
        assert_eq!(ask(from_ref(&good), 0.1, accuracy), Err("Domain"));
    }
    assert!(matches!(ask(from_ref(&good), 0.1, 1e-30), Err("Accuracy" | "Domain")));
    assert_eq!(ask(&[], 0.1, 1e-8), Err("Domain"));
    let (a, b) = surface.window(0).unwrap();
    // Not straight on the surface; beyond its window; without length; in space; a surface.
    assert_eq!(ask(&[segment([[a, 0.2], [b, 0.3]])], 0.1, 1e-8), Err("Domain"));
    assert_eq!(ask(&[segment([[a, a], [b + 1.0, a]])], 0.1, 1e-8), Err("Domain"));
    assert_eq!(ask(&[segment([[a, a], [a, a]])], 0.1, 1e-8), Err("Degenerate"));
    let space: Spline = Form::from_points(&[2], 3, &[0., 0., 0., 1., 0., 0.], None).unwrap().into();
    assert_eq!(ask(&[space], 0.1, 1e-8), Err("Shape"));
    assert_eq!(ask(from_ref(&surface), 0.1, 1e-8), Err("Shape"));
    // A line that turns a corner, and one that jumps.
    let bent = Spline::joined(
        Form::from_points(&[3], 2, &[a, a, a, 0.5 * (a + b), b, 0.5 * (a + b)], None).unwrap(),
        &[1],
        &[vec![0.0, 1.0, 2.0]],
    );
    assert_eq!(ask(&[bent.unwrap()], 0.1, 1e-8), Err("Domain"));
    assert!(ask(&vec![good; 1 << 12], 0.1, 1e-8) == Err("Limit"));
    let flat: Spline =
        Form::from_points(&[2, 2], 2, &[0., 0., 0., 1., 1., 0., 1., 1.], None).unwrap().into();
    assert_eq!(refused(&flat, segment([[0.0, 0.0], [1.0, 1.0]]), 0.1).family(), "Shape");
}
