//! Free-form deformations of `PyGeM` and pyGeo, done again.

use pforms_kernel::Form;
use pforms_operators::{Outside, Rest, Shape, Spline, Standing, deform, embed};
use pforms_testkit::models::{document, iges, text};
use pforms_testkit::numbers;

use crate::{gap, spline};

/// A lattice of points, `[i][j][k]`, as a cage.
fn cage(orders: &[usize], points: &[f64]) -> Shape {
    Form::from_points(orders, 3, points, None).unwrap().into()
}

/// 7200 points of a sphere, some of them in a turned box of which one corner is pulled.
#[test]
fn the_sphere_of_pygem() {
    let case = document("ffd/pygem-sphere.json");
    let orders: Vec<usize> =
        numbers(&case["lattice_shape"]).iter().map(|order| *order as usize).collect();
    let lattice = |key: &str| cage(&orders, &numbers(&case[key]));
    let (rest, bent) = (lattice("lattice_undeformed"), lattice("lattice_deformed"));
    let (points, expected) = (numbers(&case["points"]), numbers(&case["expected"]));
    let embedding = embed(&rest, &points, 1e-12, Outside::Keep).unwrap();
    assert_eq!(embedding.len(), 7200);
    assert!(embedding.complete.iter().all(|complete| *complete));
    let inside = embedding.inside().filter(|inside| *inside).count();
    assert!(inside > 1000 && inside < 7000, "{inside}");
    let moved = embedding.at(&bent).unwrap();
    // Printed to five decimals.
    let tolerance = case["tolerance"].as_f64().unwrap();
    assert!(gap(&moved, &expected) <= tolerance.max(1e-5), "{}", gap(&moved, &expected));
    // Points outside are the same numbers.
    for (i, standing) in embedding.standings.iter().enumerate() {
        if *standing == Standing::Outside {
            assert_eq!(moved[3 * i..3 * i + 3], points[3 * i..3 * i + 3]);
        }
    }
}

/// The rows `i j k displacement` after `parameter x:` and the like.
fn displacements(file: &str, axis: &str) -> Vec<f64> {
    let after = file.split(&format!("parameter {axis}:")).nth(1).unwrap();
    let own = after.split(['#', 'p']).next().unwrap();
    let rows: Vec<f64> = own.split_whitespace().map(|word| word.parse().unwrap()).collect();
    rows.chunks_exact(4).map(|row| row[3]).collect()
}

fn side(file: &str, name: &str, axis: &str) -> f64 {
    let line = file.lines().find(|line| line.starts_with(&format!("box {name} {axis}:"))).unwrap();
    line.rsplit(' ').next().unwrap().parse().unwrap()
}

/// A half cylinder of two quarters, or a square, over the knots of the deformed face.
fn at_rest(face: &Spline, half: Option<f64>, height: f64) -> Spline {
    let knots: Vec<&[f64]> = face.knots().iter().map(pforms_operators::Knots::as_slice).collect();
    let ends = |axis: usize| (knots[axis][0], knots[axis][knots[axis].len() - 1]);
    let Some(sign) = half else {
        let ((a, b), (c, d)) = (ends(0), ends(1));
        let corners = [[a, c], [a, d], [b, c], [b, d]];
        // The lower cap is seen from below: its first parameter runs against x.
        let along = if height > 0.0 { 1.0 } else { -1.0 };
        let points: Vec<f64> = corners.iter().flat_map(|[x, y]| [along * x, *y, height]).collect();
        let flat = Form::from_points(&[2, 2], 3, &points, None).unwrap();
        return Spline::new(flat, &[1, 1], vec![vec![a, a, b, b], vec![c, c, d, d]]).unwrap();
    };
    let ((a, b), (c, d)) = (ends(0), ends(1));
    let middle = knots[0].iter().copied().find(|t| face.knots()[0].multiplicity(t) > 1 && *t > a);
    let circle = [[1., 0.], [1., 1.], [0., 1.], [-1., 1.], [-1., 0.]];
    let (mut points, mut weights) = (Vec::new(), Vec::new());
    for (i, [x, y]) in circle.iter().enumerate() {
        for z in [c, d] {
            points.extend([sign * 1000.0 * x, sign * 1000.0 * y, z]);
            weights.push(if i % 2 == 1 { 0.5_f64.sqrt() } else { 1.0 });
        }
    }
    let net = Form::from_points(&[5, 2], 3, &points, Some(&weights)).unwrap();
    let m = middle.unwrap();
    Spline::new(net, &[2, 1], vec![vec![a, a, a, m, m, b, b, b], vec![c, c, d, d]]).unwrap()
}

/// The poles of the faces follow a box, as `PyGeM` does it after inserting knots.
#[test]
fn the_pipe_of_pygem() {
    let file = text("ffd/pygem-pipe.params.ini");
    let names = ["x", "y", "z"];
    let origin = names.map(|axis| side(&file, "origin", axis));
    let length = names.map(|axis| side(&file, "length", axis));
    let moves = names.map(|axis| displacements(&file, axis));
    let corner = |flat: usize, k: usize| origin[k] + length[k] * (flat >> (2 - k) & 1) as f64;
    let still: Vec<f64> = (0..24).map(|i| corner(i / 3, i % 3)).collect();
    let moved: Vec<f64> = (0..24).map(|i| still[i] + length[i % 3] * moves[i % 3][i / 3]).collect();
    let (rest, bent) = (cage(&[2; 3], &still), cage(&[2; 3], &moved));
    let faces: Vec<Spline> = iges::read(&text("ffd/pygem-pipe-deformed.iges"))
        .iter()
        .map(spline)
        .filter(|face| face.axes() == 2)
        .collect();
    assert_eq!(faces.len(), 4);
    let kinds = [(Some(1.0), 0.0), (Some(-1.0), 0.0), (None, 10_000.0), (None, 0.0)];
    for (face, (half, height)) in faces.iter().zip(kinds) {
        let mut before = at_rest(face, half, height);
        for axis in 0..2 {
            let inner: Vec<f64> = face.knots()[axis]
                .breaks()
                .into_iter()
                .filter(|t| before.knots()[axis].multiplicity(t) == 0)
                .collect();
            before = before.insert_knots(axis, &inner).unwrap();
        }
        assert_eq!(before.net().orders(), face.net().orders());
        let points = before.net().points().unwrap();
        let embedding = embed(&rest, &points, 1e-12, Outside::Keep).unwrap();
        let followed = embedding.at(&bent).unwrap();
        let expected = face.net().points().unwrap();
        // Ten digits of numbers up to 12,000, moved by up to half as much again.
        let far = gap(&followed, &expected);
        assert!(far < 1e-5, "{half:?} {height}: {far}");
        assert!(embedding.inside().any(|inside| inside) == (half.is_some() || height > 0.0));
    }
}

fn section(file: &str) -> Vec<[f64; 2]> {
    let text = text(&format!("ffd/{file}"));
    let row = |line: &str| -> Option<[f64; 2]> {
        let mut words = line.split_whitespace().map(str::parse);
        Some([words.next()?.ok()?, words.next()?.ok()?])
    };
    text.lines().filter_map(row).collect()
}

/// The cage of pyGeo's paper: plot3d, all x, then all y, then all z, the first index fastest.
fn wing_cage() -> Form {
    let text = text("ffd/pygeo-paper-ffd.xyz");
    let all: Vec<f64> = text.split_whitespace().map(|word| word.parse().unwrap()).collect();
    assert_eq!(all[..4], [1., 6., 2., 8.]);
    let at = |c: usize, i: usize, j: usize, k: usize| all[4 + c * 96 + (k * 2 + j) * 6 + i];
    let mut points = Vec::new();
    for i in 0..6 {
        for j in 0..2 {
            for k in 0..8 {
                points.extend([0, 1, 2].map(|c| at(c, i, j, k)));
            }
        }
    }
    Form::from_points(&[6, 2, 8], 3, &points, None).unwrap()
}

/// Wing sections in the cage, as a form and as a B-spline of degrees 3, 1, 3; then it is twisted.
#[test]
fn sections_of_a_wing_in_the_cage_of_pygeo() {
    let form = wing_cage();
    let uniform = |order: usize, degree: usize| -> Vec<f64> {
        let inner = order - degree - 1;
        let ends = |t: f64| vec![t; degree + 1];
        let middle = (1..=inner).map(|i| i as f64 / (inner + 1) as f64).collect();
        [ends(0.0), middle, ends(1.0)].concat()
    };
    let knots = vec![uniform(6, 3), uniform(2, 1), uniform(8, 3)];
    let spline = Spline::new(form.clone(), &[3, 1, 3], knots).unwrap();
    for file in ["naca2412.dat", "rae2822.dat"] {
        let section = section(file);
        assert!(section.len() > 60);
        for cage in [Shape::Form(form.clone()), Shape::Spline(spline.clone())] {
            // Each section stands in the middle of the cage's slices, and is as thick as fits.
            let points: Vec<f64> = [0.2, 0.5, 0.9]
                .iter()
                .flat_map(|span| {
                    section.iter().map(|[x, y]| [0.05 + 0.9 * x, 0.5 + 2.0 * y, *span])
                })
                .flat_map(|at| match &cage {
                    Shape::Form(form) => form.at(&at).unwrap(),
                    Shape::Spline(spline) => spline.at(&at).unwrap(),
                })
                .collect();
            let embedding = embed(&cage, &points, 1e-12, Outside::Refuse).unwrap();
            assert!(embedding.counts.iter().all(|count| *count == 1));
            assert!(embedding.complete.iter().all(|complete| *complete));
            let back = embedding.at(&cage).unwrap();
            assert!(gap(&back, &points) < 1e-13, "{}", gap(&back, &points));
            // A cage moved as a whole carries its points along.
            let lifted: Vec<f64> = form.points().unwrap().iter().map(|x| 2.0 * x + 1.0).collect();
            let net = Form::from_points(&[6, 2, 8], 3, &lifted, None).unwrap();
            let carried = match &cage {
                Shape::Form(_) => net.into(),
                Shape::Spline(spline) => Spline::on(net, spline.knots().to_vec()).unwrap().into(),
            };
            let moved = embedding.at(&carried).unwrap();
            let expected: Vec<f64> = points.iter().map(|x| 2.0 * x + 1.0).collect();
            assert!(gap(&moved, &expected) < 1e-13);
        }
    }
}

/// Points of the deformed form are the deformed points of the form.
#[test]
fn forms_and_their_points_agree() {
    let case = document("ffd/pygem-sphere.json");
    let lattice = |key: &str| cage(&[3, 2, 2], &numbers(&case[key]));
    let (rest, bent) = (lattice("lattice_undeformed"), lattice("lattice_deformed"));
    let points = numbers(&case["lattice_undeformed"]);
    let segment: Vec<f64> = [&points[..3], &points[33..]].concat();
    let object = Form::from_points(&[2], 3, &segment, None).unwrap();
    let t: Vec<f64> = (0..50).map(|i| f64::from(i) / 49.0).collect();
    let embedding = embed(&rest, &object.grid(&[&t]).unwrap(), 1e-12, Outside::Refuse).unwrap();
    let Shape::Form(curve) = deform(&object.into(), &bent, &Rest::Cage(rest)).unwrap() else {
        panic!("a spline")
    };
    assert!(gap(&embedding.at(&bent).unwrap(), &curve.grid(&[&t]).unwrap()) < 1e-12 * 150.0);
}
