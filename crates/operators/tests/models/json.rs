//! NURBS data in JSON: `ANurbs`, `compas_nurbs`, and what `openNURBS` reads in Rhino files.

use pforms_operators::Spline;
use pforms_testkit::models::{compas, document, ibra, plain};
use pforms_testkit::numbers;

use crate::measure::total;
use crate::{at_fractions, gap, laws, pole_box, scale, spline};

#[test]
fn rhino_forms_have_the_samples_of_opennurbs() {
    let expected = document("rhino/expected.json");
    let mut count = 0;
    for model in expected["models"].as_array().unwrap() {
        let objects = model["objects"].as_array().unwrap();
        for object in objects.iter().flat_map(|object| {
            let surfaces = object["surfaces"].as_array().cloned();
            surfaces.unwrap_or_else(|| vec![object.clone()])
        }) {
            let spline = spline(&plain::read(&object["form"]));
            for sample in object["samples"].as_array().unwrap() {
                let place = at_fractions(&spline, &numbers(&sample["frac"]));
                let gap = gap(&spline.at(&place).unwrap(), &numbers(&sample["point"]));
                assert!(gap <= 4e-15 * scale(&spline), "{}: {gap}", model["file"]);
            }
            laws::hold("rhino", &spline);
            count += 1;
        }
    }
    assert_eq!(count, 3);
}

/// Knots without their ends, weights apart; the surface is trimmed in the file, not here.
#[test]
fn a_dome_of_anurbs() {
    let patches = ibra::read(&document("json/anurbs-dome.ibra"));
    assert_eq!(patches.len(), 5);
    let splines: Vec<Spline> = patches.iter().map(spline).collect();
    let dome = &splines[4];
    assert_eq!((dome.degrees(), dome.net().orders()), (vec![2, 2], &[13, 7][..]));
    assert_eq!(dome.counts(), [8, 4]);
    // A ball of radius 10 that bulges to a height of 15 over the middle half of its turn.
    let steps: Vec<f64> =
        (0..=24).map(|i| at_fractions(dome, &[0.0, f64::from(i) / 24.0])[1]).collect();
    let turns: Vec<f64> =
        (0..=16).map(|i| f64::from(i) / 64.0).flat_map(|t| [t, 1.0 - t]).collect();
    let turns: Vec<f64> = turns.iter().map(|t| at_fractions(dome, &[*t])[0]).collect();
    let points = dome.grid(&[&turns, &steps]).unwrap();
    let radii = points.as_chunks::<3>().0.iter().map(|[x, y, z]| x.hypot(*y).hypot(*z));
    let far = radii.map(|r| (r - 10.0).abs()).fold(0.0, f64::max);
    assert!(far <= 1e-6, "{far}");
    let top = dome.at(&at_fractions(dome, &[0.5, 0.5])).unwrap();
    assert!(gap(&top, &[0.0, 0.0, 15.0]) <= 1e-6, "{top:?}");
    for (patch, spline) in patches.iter().zip(&splines) {
        laws::hold(&patch.name, spline);
    }
}

/// Points with weights multiplied in: a cylinder of radius 2 and height 7.
#[test]
fn a_cylinder_of_compas() {
    let cylinder = spline(&compas::read(&document("json/compas-cylinder.json")));
    assert!(cylinder.net().is_rational());
    let area = total(std::slice::from_ref(&cylinder), 20);
    assert!((area - 28.0 * std::f64::consts::PI).abs() <= 1e-13 * area, "{area}");
    let steps: Vec<f64> = (0..=20).map(|i| f64::from(i) / 20.0).collect();
    let points = cylinder.grid(&[&steps, &steps]).unwrap();
    assert!(points.as_chunks::<3>().0.iter().all(|[x, y, _]| (x.hypot(*y) - 2.0).abs() < 1e-15));
    laws::hold("compas cylinder", &cylinder);
}

/// A curve of degree 5 with 157 poles.
#[test]
fn a_long_curve_of_compas() {
    let curve = spline(&compas::read(&document("json/compas-bsplines_data.json")));
    assert_eq!((curve.degrees(), curve.counts()), (vec![5], vec![152]));
    // Every piece stays in the box of its six poles; its ends are where the neighbours' are.
    let pieces = curve.pieces().unwrap();
    for pair in pieces.windows(2) {
        let (end, start) = (pair[0].at(&[1.0]).unwrap(), pair[1].at(&[0.0]).unwrap());
        assert!(gap(&end, &start) <= 1e-14 * scale(&curve));
    }
    let [low, high] = pole_box(&curve);
    for i in 0..=1000 {
        let point = curve.at(&at_fractions(&curve, &[f64::from(i) / 1000.0])).unwrap();
        let inside = |k: usize| low[k] - 1e-12 <= point[k] && point[k] <= high[k] + 1e-12;
        assert!((0..point.len()).all(inside), "{point:?}");
    }
    laws::hold("compas curve", &curve);
}
