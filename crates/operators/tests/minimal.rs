//! Surfaces of little area: Enneper's from their boundaries, laws in fractions, descents that only descend.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use std::path::Path;

use pforms_kernel::{Error, Form, Rational, Scalar, Scaled};
use pforms_operators::{
    Functional, Minimal, MinimalOptions, Poles, Shape, Spline, extremal, hodograph, minimal,
    raise_to, sub,
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
        let orders: Vec<usize> = degrees.iter().map(|p| p.as_u64().unwrap() as usize + 1).collect();
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
    inner(form.orders()).iter().fold(form.clone(), |form, place| {
        let mut pole = vec![S::from_integer(7); form.ambient()];
        pole.push(S::one());
        form.with_pole(place, &pole).unwrap()
    })
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
            let found = minimal(&curves(&form), kind, &MinimalOptions::default(), 1e-10).unwrap();
            // Systems of 4 and 16 unknowns, of condition below 1e3.
            assert!(distance(found.surface.net(), &form) < 1e-13, "{kind:?}");
            assert!((found.area - area).abs() <= found.error + 1e-13 * area);
            assert!(found.curvature < 1e-12 && found.slope < 1e-12 && found.laplacian < 1e-12);
            // Parameters that keep angles: energy and area are one.
            assert!((found.energy / area - 1.0).abs() < 1e-13);
        }
    }
}

fn distance(a: &Form, b: &Form) -> f64 {
    let pairs = a.homogeneous().iter().zip(b.homogeneous());
    pairs.fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()))
}

/// Real and imaginary parts of `c·z^n` with `z = (from + length·u) + i·(from + length·v)`, as poles of
/// the form that has them: the blossom of `z^n` is a product of blossoms of `z`.
fn harmonic(random: &mut Random, degree: usize, sides: [i64; 2]) -> Exact {
    let one = |axis: usize| {
        let mut corner = [q(0, 1), q(0, 1)];
        corner[axis] = q(sides[axis], 1);
        corner
    };
    let start = [random.fraction::<Rational>(), random.fraction()];
    // Bilinear z on the box, in homogeneous poles (Re, Im, 1), multiplied with itself.
    let corners: Vec<Rational> = [[0, 0], [0, 1], [1, 0], [1, 1]]
        .iter()
        .flat_map(|at: &[usize; 2]| {
            let mut z = start.clone();
            for (axis, &on) in at.iter().enumerate() {
                for (z, step) in z.iter_mut().zip(one(axis)) {
                    *z = z.clone() + q(on as i64, 1) * step;
                }
            }
            z
        })
        .collect();
    let z = Scaled::from_form(&Form::from_points(&[2, 2], 2, &corners, None).unwrap());
    let (re, im) = (z.component(0), z.component(1));
    let mut power = (re.clone(), im.clone());
    for _ in 1..degree {
        let real = power.0.times(&re).unwrap().minus(&power.1.times(&im).unwrap());
        let imaginary = power
            .0
            .times(&im)
            .unwrap()
            .minus(&power.1.times(&re).unwrap().times(&minus()).unwrap());
        power = (real, imaginary);
    }
    let weight = Scaled::one(power.0.degrees()).unwrap();
    power.0.beside(&power.1).beside(&weight).into_form().unwrap()
}

fn minus() -> Scaled<Rational> {
    Scaled::constant(2, &[q(-1, 1)])
}

#[test]
fn harmonic_forms_are_recovered_on_any_box() {
    let mut random = Random::new(37);
    for (degree, sides) in [(2, [1, 1]), (3, [1, 2]), (4, [3, 1])] {
        let form = harmonic(&mut random, degree, sides);
        let options = MinimalOptions {
            sides: sides.map(|side| q(side, 1)).to_vec(),
            ..MinimalOptions::default()
        };
        for functional in [Functional::Dirichlet, Functional::Harmonic] {
            let found = extremal(&curves(&form), functional, &options).unwrap();
            assert_eq!(*found.net(), form);
            // Higher orders have the same solution.
            let orders = vec![degree + 2, degree + 1];
            let more = MinimalOptions { orders: orders.clone(), ..options.clone() };
            let found = extremal(&curves(&form), functional, &more).unwrap();
            assert_eq!(*found.net(), raise_to(&form, &orders).unwrap());
        }
    }
}

#[test]
fn high_degrees_are_solved_to_rounding() {
    let mut random = Random::new(12);
    for (degree, order) in [(7, 8), (9, 10), (12, 13)] {
        let form = floating(&harmonic(&mut random, degree, [1, 1]));
        let form = raise_to(&form, &[order, order]).unwrap();
        let size = form.homogeneous().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        for functional in [Functional::Dirichlet, Functional::Harmonic] {
            let found = extremal(&curves(&form), functional, &MinimalOptions::default()).unwrap();
            // The border itself is rounded; in plain numbers the loss would be 1e-10 at degree 9.
            assert!(distance(found.net(), &form) < 1e-13 * size, "{degree} {order} {functional:?}");
        }
    }
    // Where rounding would decide, nothing is said.
    let options = MinimalOptions { orders: vec![36, 4], ..MinimalOptions::default() };
    let found = extremal(&[schwarz().into()], Functional::Dirichlet, &options);
    assert!(found.is_ok() || matches!(found, Err(Error::Accuracy { .. })));
}

/// The integral of a polynomial is the mean of its poles: `∫ ∂f·∂g` along one axis.
fn product(f: &Exact, g: &Exact, axis: usize) -> Rational {
    let slope = |form: &Exact| Scaled::from_form(&hodograph(form, axis).unwrap());
    let (f, g) = (slope(f), slope(g));
    let mut sum = q(0, 1);
    for k in 0..f.width() - 1 {
        let product = f.component(k).times(&g.component(k)).unwrap();
        let weight = Scaled::one(product.degrees()).unwrap();
        let poles = product.beside(&weight).into_form().unwrap().points().unwrap();
        let count = q(poles.len() as i64, 1);
        sum += poles.into_iter().fold(q(0, 1), |sum, x| sum + x) / count;
    }
    sum
}

#[test]
fn no_pole_lowers_the_dirichlet_energy() {
    let mut random = Random::new(2004);
    for orders in [vec![3, 3], vec![5, 4], vec![3, 3, 4], vec![6]] {
        let form = random.form(&orders, 2, Weights::One);
        let least = extremal(&[form.into()], Functional::Dirichlet, &MinimalOptions::default());
        let least = least.unwrap().net().clone();
        for index in inner(&orders) {
            let mut other = Form::from_points(
                &orders,
                2,
                &vec![q(0, 1); 2 * orders.iter().product::<usize>()],
                None,
            )
            .unwrap();
            other = other.with_pole(&index, &[q(1, 1), q(2, 1), q(1, 1)]).unwrap();
            let slope =
                (0..orders.len()).fold(q(0, 1), |s, axis| s + product(&least, &other, axis));
            assert_eq!(slope, q(0, 1), "{orders:?} {index:?}");
        }
    }
}

/// Places of inner poles.
fn inner(orders: &[usize]) -> Vec<Vec<usize>> {
    orders.iter().fold(vec![Vec::new()], |places, &order| {
        let longer = |place: Vec<usize>| {
            (1..order - 1).map(move |at| [&place[..], &[at]].concat()).collect::<Vec<_>>()
        };
        places.into_iter().flat_map(longer).collect()
    })
}

#[test]
fn poles_of_the_net_are_means_of_their_neighbours() {
    let mut random = Random::new(233);
    let net: Exact = random.form(&[6, 5], 3, Weights::One);
    let keep = vec![vec![2, 1], vec![4, 3]];
    let options = MinimalOptions { keep: keep.clone(), ..MinimalOptions::default() };
    let film = extremal(&[net.clone().into()], Functional::Laplace, &options).unwrap();
    let film = film.net();
    for place in inner(&[6, 5]) {
        let [i, j] = place[..] else { panic!() };
        if keep.contains(&place) {
            assert_eq!(film.pole(&place).unwrap(), net.pole(&place).unwrap());
            continue;
        }
        let around = [[i - 1, j], [i + 1, j], [i, j - 1], [i, j + 1]];
        for k in 0..3 {
            let sum = around.iter().fold(q(0, 1), |sum, at| sum + &film.pole(at).unwrap()[k]);
            assert_eq!(film.pole(&place).unwrap()[k], sum / q(4, 1));
        }
    }
}

#[test]
fn splines_are_recovered_across_their_knots() {
    let (form, area) = truth("minimal_surface").remove(1);
    let knots = [q(1, 3), q(1, 2)];
    let spline = Spline::from(form).insert_knots(0, &knots).unwrap().insert_knots(1, &knots[1..]);
    let spline = spline.unwrap();
    let empty = spline.with_net(emptied(spline.net())).unwrap();
    for functional in [Functional::Dirichlet, Functional::Harmonic] {
        let found =
            extremal(&[empty.clone().into()], functional, &MinimalOptions::default()).unwrap();
        assert_eq!(found, Shape::Spline(spline.clone()), "{functional:?}");
    }
    let floating = empty.map_scalar(Scalar::to_f64).unwrap();
    let found = minimal(&[floating.into()], None, &MinimalOptions::default(), 1e-9).unwrap();
    assert!((found.area - area).abs() <= found.error + 1e-12 && found.slope < 1e-9);
}

/// `K(m)`, the complete elliptic integral, by the mean of means of Gauss.
fn elliptic(m: f64) -> f64 {
    let (mut a, mut b) = (1.0_f64, (1.0 - m).sqrt());
    for _ in 0..8 {
        (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
    }
    std::f64::consts::PI / (2.0 * a)
}

/// A sixth of the film in a cube whose edge is 1: four straight lines, of which two are edges.
fn schwarz() -> Form {
    let corners = [0.5, 0.5, 0.5, 0.5, 1.0, 0.0, 1.0, 0.5, 0.0, 1.0, 1.0, 0.0];
    let corners = [&corners[..3], &corners[3..6], &corners[6..9], &corners[9..]].concat();
    Form::from_points(&[2, 2], 3, &corners, None).unwrap()
}

#[test]
fn areas_go_down_to_that_of_the_periodic_surface_of_schwarz() {
    let truth = elliptic(0.75) / elliptic(0.25) / 4.0;
    let mut last = f64::INFINITY;
    // Each more order adds digits: the surface is analytic up to its straight border.
    for (order, within) in [(3, 3e-3), (4, 1e-3), (6, 1e-5), (8, 1e-6)] {
        let options = MinimalOptions { orders: vec![order; 2], ..MinimalOptions::default() };
        let found = minimal(&[schwarz().into()], None, &options, 1e-8).unwrap();
        let excess = found.area / truth - 1.0;
        assert!(found.area >= truth * (1.0 - 1e-12), "no surface has less area than the film");
        assert!(found.area <= last && excess < within, "order {order}: {excess:e}");
        assert!(found.slope < 1e-8 && Some(found.area) < found.coons_area);
        last = found.area;
    }
}

#[test]
fn descent_ends_below_everything_it_knows() {
    let mut random = Random::new(5);
    for (ambient, orders) in [(3, [3, 3]), (4, [4, 4]), (2, [3, 3])] {
        let form = floating(&random.form(&orders, ambient, Weights::One));
        let options = MinimalOptions::default();
        let found = minimal(&curves(&form), None, &options, 1e-3).unwrap();
        for functional in LINEAR {
            let other = minimal(&curves(&form), Some(functional), &options, 0.0).unwrap();
            assert!(found.area <= other.area || functional != Functional::Dirichlet);
            assert!(other.energy >= other.area - other.error);
        }
        assert!(Some(found.area) <= found.coons_area);
        assert_eq!(sub(found.surface_form(), 0, &0.0).unwrap(), sub(&form, 0, &0.0).unwrap());
    }
}

trait Surface {
    fn surface_form(&self) -> &Form;
}

impl Surface for Minimal {
    fn surface_form(&self) -> &Form {
        match &self.surface {
            Shape::Form(form) => form,
            Shape::Spline(_) => panic!("a form was given"),
        }
    }
}

#[test]
fn the_unit_of_length_does_not_matter() {
    let form = floating(&truth("minimal_surface").remove(1).0);
    let plain = minimal(&curves(&form), None, &MinimalOptions::default(), 1e-9).unwrap();
    for exponent in [-400, 400] {
        let unit = 2.0_f64.powi(exponent);
        let scaled = form.map_scalar(|x| *x * unit).unwrap();
        let weights = vec![1.0; scaled.pole_count()];
        let points: Vec<f64> = form.points().unwrap().iter().map(|x| x * unit).collect();
        let scaled = Form::from_points(scaled.orders(), 3, &points, Some(&weights)).unwrap();
        let found = minimal(&curves(&scaled), None, &MinimalOptions::default(), 1e-9).unwrap();
        assert_eq!(found.area, plain.area * unit * unit);
        assert_eq!((found.slope, found.steps), (plain.slope, plain.steps));
    }
}

#[test]
fn a_flat_rational_border_has_a_flat_surface() {
    let w = std::f64::consts::FRAC_1_SQRT_2;
    let arc = |r: f64| {
        Form::from_points(&[3], 3, &[r, 0., 0., r, r, 0., 0., r, 0.], Some(&[1., w, 1.])).unwrap()
    };
    let spoke = |x: f64, y: f64| {
        let at = |r: f64| [r * x, r * y, if r == 1.5 { 1.0 } else { 0.0 }];
        Form::from_points(&[3], 3, &[at(1.0), at(1.5), at(2.0)].concat(), None).unwrap()
    };
    let border = [arc(1.0), arc(2.0), spoke(1., 0.), spoke(0., 1.)].map(Shape::from);
    let flat = |z: &Form| z.points().unwrap().chunks(3).all(|p| p[2] == 0.0);
    for kind in [Some(Functional::Dirichlet), None] {
        let found = minimal(&border, kind, &MinimalOptions::default(), 1e-9).unwrap();
        assert!(!flat(found.surface.net()), "the spokes rise");
        assert!(found.area < 2.4 * found.coons_area.unwrap() && found.area > 0.0);
    }
    let level = [arc(1.0), arc(2.0)].into_iter().map(Shape::from);
    let straight = [(1., 0.), (0., 1.)].map(|(x, y): (f64, f64)| {
        Form::from_points(&[2], 3, &[x, y, 0., 2. * x, 2. * y, 0.], None).unwrap().into()
    });
    let level: Vec<Shape> = level.chain(straight).collect();
    let options = MinimalOptions { orders: vec![4, 4], ..MinimalOptions::default() };
    let found = minimal(&level, None, &options, 1e-9).unwrap();
    let ring = 0.75 * std::f64::consts::PI;
    assert!(flat(found.surface.net()) && (found.area - ring).abs() <= found.error + 1e-14);
}

#[test]
fn nothing_to_cover_is_an_answer() {
    let point = [1.0, 2.0, 3.0].repeat(9);
    let line: Vec<f64> = (0..9).flat_map(|k| [f64::from(k * k), 0.0, 0.0]).collect();
    for points in [point, line] {
        let form = Form::from_points(&[3, 3], 3, &points, None).unwrap();
        for kind in [None, Some(Functional::Dirichlet)] {
            let found =
                minimal(&[form.clone().into()], kind, &MinimalOptions::default(), 1e-9).unwrap();
            assert!(found.area <= found.error && found.slope == 0.0 && found.steps == 0);
        }
    }
    // An edge that is a point, and a facet without inner poles.
    let cone = [0., 0., 1., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 1., 0., 0., 1., 0.];
    let cone = Form::from_points(&[2, 3], 3, &cone, None).unwrap();
    let options = MinimalOptions { orders: vec![4, 4], ..MinimalOptions::default() };
    let found = minimal(&[cone.into()], None, &options, 1e-9).unwrap();
    assert!(found.slope < 1e-6 && Some(found.area) <= found.coons_area);
    let found = minimal(&[schwarz().into()], None, &MinimalOptions::default(), 1e-9).unwrap();
    assert_eq!((found.steps, found.surface.net().clone()), (0, schwarz()));
}

#[test]
fn what_cannot_be_is_said() {
    let form = floating(&truth("minimal_surface").remove(0).0);
    let plain = MinimalOptions::default();
    let mut open = curves(&form);
    open.swap(2, 3);
    let error = minimal(&open, None, &plain, 1e-9).unwrap_err();
    assert!(error.to_string().contains("corner"), "{error}");
    let surface = [Shape::from(form.clone())];
    let domain = |options: MinimalOptions, kind| {
        matches!(minimal(&surface, kind, &options, 1e-9), Err(Error::Domain { .. }))
    };
    let sides = MinimalOptions { sides: vec![1.0, 1.0], ..plain.clone() };
    assert!(domain(sides.clone(), None) && domain(sides, Some(Functional::Laplace)));
    for side in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let sides = MinimalOptions { sides: vec![1.0, side], ..plain.clone() };
        assert!(domain(sides, Some(Functional::Dirichlet)));
    }
    assert!(domain(MinimalOptions { orders: vec![3, 4], ..plain.clone() }, None));
    let keep = MinimalOptions { keep: vec![vec![1, 4]], ..plain.clone() };
    assert!(matches!(minimal(&surface, None, &keep, 1e-9), Err(Error::Shape { .. })));
    assert!(matches!(minimal(&surface, None, &plain, f64::NAN), Err(Error::Domain { .. })));
    let curve: Form = Form::from_points(&[3], 3, &[0.0; 9], None).unwrap();
    assert!(matches!(minimal(&[curve.into()], None, &plain, 1e-9), Err(Error::Shape { .. })));
    let function = Form::from_points(&[3, 3], 1, &[0.0; 9], None).unwrap();
    assert!(matches!(minimal(&[function.into()], None, &plain, 1e-9), Err(Error::Shape { .. })));
    let signs: Vec<f64> = (0..16).map(|k| if k == 5 { -1.0 } else { 1.0 }).collect();
    let points = form.points().unwrap();
    let signed = Form::from_points(&[4, 4], 3, &points, Some(&signs)).unwrap();
    let keep = MinimalOptions { keep: vec![vec![1, 1]], ..plain };
    let error = minimal(&[signed.into()], None, &keep, 1e-9).unwrap_err();
    assert!(matches!(error, Error::Domain { .. }), "{error}");
}
