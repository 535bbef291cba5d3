//! Curves and surfaces immersed in models, across the knots of their hosts.

use pforms_kernel::Form;
use pforms_operators::{Spline, immerse_spline};
use pforms_testkit::Random;
use pforms_testkit::models::{gismo, iges, mfem, text};

use crate::{at_fractions, gap, scale, spline};

/// The first spline with so many axes in a list of patches.
fn host(patches: &[pforms_testkit::models::Patch], axes: usize) -> Spline {
    patches.iter().map(spline).find(|spline| spline.axes() == axes).unwrap()
}

/// An arbitrary curve of so many poles over the windows of a host.
fn inner(host: &Spline, order: usize, random: &mut Random) -> Form {
    let points: Vec<f64> = (0..order)
        .flat_map(|_| {
            let shares: Vec<f64> = (0..host.axes()).map(|_| random.unit()).collect();
            at_fractions(host, &shares)
        })
        .collect();
    Form::from_points(&[order], host.axes(), &points, None).unwrap()
}

/// The immersed form is the host at the points of the inner one.
fn agrees(name: &str, inner: &Spline, host: &Spline, bound: f64) {
    let immersed = immerse_spline(&inner.clone().into(), &host.clone().into()).unwrap();
    assert_eq!((immersed.axes(), immersed.ambient()), (inner.axes(), host.ambient()), "{name}");
    for i in 0..=200 {
        let shares: Vec<f64> =
            (0..inner.axes()).map(|k| f64::from((i * (2 * k as u32 + 1)) % 201) / 200.0).collect();
        let place = at_fractions(inner, &shares);
        let there = host.at(&inner.at(&place).unwrap()).unwrap();
        let gap = gap(&immersed.at(&place).unwrap(), &there);
        assert!(gap <= bound * scale(host), "{name}: {gap} at {place:?}");
    }
}

#[test]
fn curves_cross_the_knots_of_surfaces_and_volumes() {
    let mut random = Random::new(7);
    let hosts = [
        ("egg", host(&gismo::read(&text("gismo/surfaces-egg.xml")), 2)),
        ("wing", host(&iges::read(&text("iges/aircraft-wing.igs")), 2)),
        ("yeti", host(&gismo::read(&text("gismo/domain2d-yeti_mp2.xml")), 2)),
        ("cylinder", host(&gismo::read(&text("gismo/volumes-cylinder.xml")), 3)),
        ("pipe", host(&mfem::read(&text("mfem/pipe-nurbs.mesh")), 3)),
        ("G", host(&gismo::read(&text("gismo/volumes-GshapedVolume.xml")), 3)),
    ];
    for (name, host) in hosts {
        for order in [2, 3, 4] {
            let inner = Spline::from(inner(&host, order, &mut random));
            // A point in the host's parameters is right to a rounding; the host moves it by its slope.
            agrees(name, &inner, &host, 1e-12);
        }
    }
}

/// A spline immersed in a spline: both kinds of joints.
#[test]
fn splines_in_splines() {
    let mut random = Random::new(11);
    let host = host(&gismo::read(&text("gismo/surfaces-egg.xml")), 2);
    let net = inner(&host, 7, &mut random);
    let knots = vec![0.0, 0.0, 0.0, 0.2, 0.4, 0.6, 0.6, 1.0, 1.0, 1.0];
    agrees("egg", &Spline::new(net, &[2], vec![knots]).unwrap(), &host, 1e-12);
}

/// A facet along the parameter lines of a volume: a leaf of it.
#[test]
fn a_leaf_of_a_volume() {
    let host = host(&gismo::read(&text("gismo/volumes-cylinder.xml")), 3);
    let points = [0.1, 0.2, 0.5, 0.1, 0.9, 0.5, 3.7, 0.2, 0.5, 3.7, 0.9, 0.5];
    let inner = Spline::from(Form::from_points(&[2, 2], 3, &points, None).unwrap());
    agrees("cylinder", &inner, &host, 1e-13);
}
