//! Circles, quadrics and tori satisfy their equations to the letter, in fractions and in the field
//! of √2.
#![allow(clippy::unwrap_used, reason = "a test stops at the first surprise")]

use pforms_kernel::{Form, Rational, Scalar, Scaled};
use pforms_operators::{
    Axis, Part, Poles, Shape, arc_by_step, circle, cone, conic, cross, cylinder, diagonal, ellipse,
    hyperbola_by, immerse, immerse_points, parabola, revolve_along, revolve_whole, segment, sphere,
    stretch, torus, viviani,
};
use pforms_testkit::{Random, Root2, Weights};

/// A polynomial of one component.
#[derive(Clone)]
struct Poly<S>(Scaled<S>);

impl<S: Scalar> Poly<S> {
    fn times(&self, other: &Self) -> Self {
        Self(self.0.times(&other.0).unwrap())
    }

    fn squared(&self) -> Self {
        self.times(self)
    }

    /// `self + factor·other`, degrees raised as needed.
    fn plus(&self, factor: i64, other: &Self) -> Self {
        self.plus_scaled(&S::from_integer(factor), other)
    }

    fn plus_scaled(&self, factor: &S, other: &Self) -> Self {
        let mut sum = self.0.clone();
        sum.add_multiple(factor, &other.0);
        Self(sum)
    }

    fn scaled(&self, factor: &S) -> Self {
        Self(Scaled::zero(self.0.degrees(), 1).unwrap()).plus_scaled(factor, self)
    }

    fn is_zero(&self) -> bool {
        self.0.coefficients().iter().all(Scalar::is_zero)
    }
}

/// The homogeneous coordinates of a form in space as polynomials, the weight last.
fn coordinates<S: Scalar>(form: &Form<S>) -> [Poly<S>; 4] {
    let all = Scaled::from_form(form);
    [0, 1, 2, 3].map(|k| Poly(all.component(k)))
}

fn pieces<S: Scalar>(shape: &Shape<S>) -> Vec<Form<S>> {
    shape.pieces().unwrap()
}

fn assert_every<S: Scalar>(shape: &Shape<S>, equation: impl Fn([Poly<S>; 4]) -> Poly<S>) {
    let all = pieces(shape);
    assert!(!all.is_empty());
    for form in all {
        assert!(equation(coordinates(&form)).is_zero(), "{form:?}");
    }
}

/// `x² + y² − r²·w²`.
fn round<S: Scalar>(r: &S) -> impl Fn([Poly<S>; 4]) -> Poly<S> {
    let square = -(r.clone() * r.clone());
    move |[x, y, z, w]| {
        x.squared().plus(1, &y.squared()).plus_scaled(&square, &w.squared()).plus(1, &z.squared())
    }
}

fn sphere_law<S: Scalar>(r: &S) -> impl Fn([Poly<S>; 4]) -> Poly<S> {
    round(r)
}

/// `x² + z² − (r·w + (top − r)/h·y)²`, the cylinder for `top = r`.
fn cone_law<S: Scalar>(r: &S, h: &S, top: &S) -> impl Fn([Poly<S>; 4]) -> Poly<S> {
    let (r, slope) = (r.clone(), (top.clone() - r.clone()) / h.clone());
    move |[x, y, z, w]| {
        let radius = w.scaled(&r).plus_scaled(&slope, &y);
        x.squared().plus(1, &z.squared()).plus(-1, &radius.squared())
    }
}

/// `(x² + y² + z² + (R² − r²)·w²)² − 4·R²·w²·(x² + z²)`.
fn torus_law<S: Scalar>(major: &S, minor: &S) -> impl Fn([Poly<S>; 4]) -> Poly<S> {
    let (big, small) = (major.clone() * major.clone(), minor.clone() * minor.clone());
    move |[x, y, z, w]| {
        let across = x.squared().plus(1, &z.squared());
        let w = w.squared();
        let inner = across.plus(1, &y.squared()).plus_scaled(&(big.clone() - small.clone()), &w);
        let factor = -(S::from_integer(4) * big.clone());
        inner.squared().plus_scaled(&factor, &across.times(&w))
    }
}

const EVERY: [Part; 7] = Part::ALL;

/// Radii that are no powers of two.
fn sizes<S: Scalar>() -> [S; 3] {
    [S::ratio(7, 3), S::ratio(5, 11), S::ratio(13, 10)]
}

#[test]
fn arcs_are_round() {
    let [r, ..] = sizes::<Root2>();
    let k = Root2::half_root().unwrap();
    for order in [3, 4, 5] {
        assert_every(&arc_by_step(&r, &[k.clone(), k.clone()], order).unwrap().into(), round(&r));
        // A Pythagorean step, in fractions.
        let (r, step) = (Rational::ratio(7, 3), [Rational::ratio(-7, 25), Rational::ratio(24, 25)]);
        assert_every(&arc_by_step(&r, &step, order).unwrap().into(), round(&r));
    }
    for part in [Part::Whole, Part::Pieces] {
        assert_every(&circle(&r, part).unwrap(), round(&r));
    }
    let r = Rational::ratio(7, 3);
    assert_every(&circle(&r, Part::Whole).unwrap(), round(&r));
}

#[test]
fn conics_satisfy_their_equations() {
    let [a, b, h] = sizes::<Rational>();
    let square = |x: &Rational| x.power(2);
    assert_every(&ellipse(&a, &b, Part::Whole).unwrap(), |[x, y, _, w]| {
        let sum = x.squared().scaled(&square(&b)).plus_scaled(&square(&a), &y.squared());
        sum.plus_scaled(&-(square(&a) * square(&b)), &w.squared())
    });
    assert_every(&parabola(&a, &h).unwrap().into(), |[x, y, _, w]| {
        y.squared().plus_scaled(&-(Rational::from_integer(4.into()) * &a), &x.times(&w))
    });
    let unit = [Rational::ratio(5, 4), Rational::ratio(3, 4)];
    assert_every(&hyperbola_by(&a, &b, &unit).unwrap().into(), |[x, y, _, w]| {
        let difference = x.squared().scaled(&square(&b)).plus_scaled(&-square(&a), &y.squared());
        difference.plus_scaled(&-(square(&a) * square(&b)), &w.squared())
    });
}

#[test]
fn cylinders_cones_and_spheres_satisfy_their_equations() {
    let [r, h, top] = sizes::<Root2>();
    for part in EVERY {
        if let Ok(shape) = cylinder(&r, &h, part) {
            assert_every(&shape, cone_law(&r, &h, &r));
            assert_every(&cone(&r, &h, &top, part).unwrap(), cone_law(&r, &h, &top));
            let apex = cone(&r, &h, &Root2::zero(), part).unwrap();
            assert_every(&apex, cone_law(&r, &h, &Root2::zero()));
        }
        if let Ok(shape) = sphere(&r, part) {
            assert_every(&shape, sphere_law(&r));
        }
    }
}

#[test]
fn tori_satisfy_their_quartic() {
    let [major, minor, _] = sizes::<Root2>();
    let mut found = 0;
    for part in EVERY {
        if let Ok(shape) = torus(&major, &minor, part) {
            assert_every(&shape, torus_law(&major, &minor));
            // A torus that meets itself satisfies it too.
            assert_every(&torus(&minor, &major, part).unwrap(), torus_law(&minor, &major));
            found += 1;
        }
    }
    assert_eq!(found, 5);
}

#[test]
fn whole_forms_need_no_root() {
    let [r, h, top] = sizes::<Rational>();
    assert_every(&cylinder(&r, &h, Part::Whole).unwrap(), cone_law(&r, &h, &r));
    assert_every(&cone(&r, &h, &top, Part::Whole).unwrap(), cone_law(&r, &h, &top));
    assert_every(&sphere(&r, Part::Whole).unwrap(), sphere_law(&r));
    assert_every(&torus(&r, &h, Part::Whole).unwrap(), torus_law(&r, &h));
    for part in [Part::Pieces, Part::Octant] {
        assert_eq!(sphere(&r, part).unwrap_err().family(), "Domain");
    }
}

#[test]
fn the_whole_circle_is_the_half_circle_on_the_window_of_the_book() {
    let k = Root2::half_root().unwrap();
    let half = arc_by_step(&Root2::one(), &[k.clone(), k.clone()], 5).unwrap();
    let stretched = stretch(&half, &[-k.clone()], &[Root2::one() + k]).unwrap();
    let circle = circle(&Root2::one(), Part::Whole).unwrap();
    let factor = stretched.pole(&[0]).unwrap()[3].clone();
    // The book's begins where y is least: a quarter turn behind.
    for (a, b) in stretched.homogeneous().chunks(4).zip(circle.net().homogeneous().chunks(4)) {
        let times = |x: &Root2| factor.clone() * x.clone();
        assert_eq!(a, [times(&b[1]), -times(&b[0]), Root2::zero(), times(&b[3])]);
    }
}

#[test]
fn three_constructions_of_viviani_agree() {
    let octant = sphere(&Root2::ratio(5, 3), Part::Octant).unwrap();
    let octant = octant.net();
    let curve = viviani(&Root2::ratio(5, 3), Part::Octant).unwrap();
    assert_eq!(curve.net(), &diagonal(octant, 0, 1).unwrap());
    let corner = |x: i64| vec![Root2::from_integer(x); 2];
    assert_eq!(curve.net(), &segment(octant, &corner(0), &corner(1)).unwrap());
    let line = Form::from_points(&[2], 2, &[corner(0), corner(1)].concat(), None).unwrap();
    assert_eq!(curve.net(), &immerse(&line, octant).unwrap());
    // Point by point, as the book's first construction does.
    let points: Vec<Root2> = (0..=8).flat_map(|i| vec![Root2::ratio(i, 8); 2]).collect();
    let points = Form::from_points(&[9], 2, &points, None).unwrap();
    let images = immerse_points(&points, |p| octant.at(p)).unwrap();
    for (i, image) in images.points().unwrap().chunks(3).enumerate() {
        assert_eq!(curve.net().at(&[Root2::ratio(i as i64, 8)]).unwrap(), image);
    }
}

#[test]
fn viviani_lies_on_sphere_and_cylinder_and_closes() {
    let r = Root2::ratio(5, 3);
    for part in [Part::Octant, Part::Whole] {
        let curve = viviani(&r, part).unwrap();
        assert_every(&curve, sphere_law(&r));
        assert_every(&curve, |[x, _, z, w]| {
            x.squared().plus(1, &z.squared()).plus_scaled(&-r.clone(), &x.times(&w))
        });
    }
    let whole = pieces(&viviani(&r, Part::Whole).unwrap());
    let end = |form: &Form<Root2>, t: i64| form.at(&[Root2::from_integer(t)]).unwrap();
    for (i, piece) in whole.iter().enumerate() {
        assert_eq!(end(piece, 1), end(&whole[(i + 1) % 3], 0));
    }
}

/// Poles that turn as the complex numbers of a section do, computed by themselves.
#[test]
fn a_product_is_a_complex_product_of_points() {
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let profile: Form<Rational> = random.form(&[3, 2], 3, Weights::Any);
        let section: Form<Rational> = random.form(&[4], 3, Weights::Positive);
        let surface = cross(&profile.clone().into(), &section.clone().into()).unwrap();
        assert_eq!(surface.net().orders(), [3, 2, 4]);
        let at = random.parameters::<Rational>(3);
        let (Ok(p), Ok(s)) = (profile.at(&at[..2]), section.at(&at[2..])) else { continue };
        let expected =
            [&p[0] * &s[0] - &p[2] * &s[1], &p[1] + &s[2], &p[0] * &s[1] + &p[2] * &s[0]];
        assert_eq!(surface.net().at(&at).unwrap(), expected);
    }
}

#[test]
fn flat_profiles_and_sections_give_the_products_of_the_book() {
    let mut random = Random::new(7);
    let profile: Form<Rational> = random.form(&[3], 2, Weights::Any);
    let section: Form<Rational> = random.form(&[4], 2, Weights::Any);
    let surface = cross(&profile.clone().into(), &section.clone().into()).unwrap();
    for (i, p) in profile.homogeneous().chunks(3).enumerate() {
        for (j, s) in section.homogeneous().chunks(3).enumerate() {
            let expected = [&s[0] * &p[0], &s[2] * &p[1], &s[1] * &p[0], &s[2] * &p[2]];
            assert_eq!(surface.net().pole(&[i, j]).unwrap(), expected);
        }
    }
}

#[test]
fn revolution_keeps_heights_and_distances_from_any_axis() {
    let unit = [Rational::ratio(2, 7), Rational::ratio(-3, 7), Rational::ratio(6, 7)];
    let through = [Rational::ratio(1, 2), Rational::ratio(-4, 3), Rational::ratio(2, 5)];
    let axis = Axis::with_length(through.clone(), unit.clone(), &Scalar::one()).unwrap();
    for seed in 0..10 {
        let mut random = Random::new(seed);
        let profile: Form<Rational> = random.form(&[3, 2], 3, Weights::Positive);
        let turned = revolve_whole(&profile.clone().into(), &axis, Part::Whole).unwrap();
        let at = random.parameters::<Rational>(3);
        let arm = |point: Vec<Rational>| -> Vec<Rational> {
            point.iter().zip(&through).map(|(x, a)| x - a).collect()
        };
        let dot = |a: &[Rational], b: &[Rational]| -> Rational {
            a.iter().zip(b).map(|(x, y)| x * y).sum()
        };
        let (before, after) =
            (arm(profile.at(&at[..2]).unwrap()), arm(turned.net().at(&at).unwrap()));
        assert_eq!(dot(&before, &unit), dot(&after, &unit));
        assert_eq!(dot(&before, &before), dot(&after, &after));
    }
}

#[test]
fn a_product_with_a_circle_is_a_revolution_the_other_way_round() {
    let mut random = Random::new(3);
    let profile: Shape<Rational> = random.form(&[4], 3, Weights::Any).into();
    let [c, s] = [Rational::ratio(3, 5), Rational::ratio(4, 5)];
    let one = Scalar::one();
    let there = arc_by_step(&one, &[c.clone(), s.clone()], 3).unwrap();
    let back = arc_by_step(&one, &[c, -s], 3).unwrap();
    let turned = revolve_along(&profile, &back.into(), &Axis::upright()).unwrap();
    assert_eq!(cross(&profile, &there.into()).unwrap(), turned);
}

#[test]
fn conics_of_forms_are_conics_of_their_points() {
    let mut random = Random::new(11);
    let curves = [0, 1, 2].map(|_| random.form::<Rational>(&[2], 3, Weights::One));
    let w = Rational::ratio(2, 3);
    let surface = conic(&curves[0], &curves[1], &curves[2], &w).unwrap();
    let t = Rational::ratio(1, 3);
    let points =
        curves.each_ref().map(|c| Form::point(&c.at(std::slice::from_ref(&t)).unwrap()).unwrap());
    let curve = conic(&points[0], &points[1], &points[2], &w).unwrap();
    let u = Rational::ratio(3, 4);
    assert_eq!(surface.at(&[u.clone(), t]).unwrap(), curve.at(&[u]).unwrap());
}
