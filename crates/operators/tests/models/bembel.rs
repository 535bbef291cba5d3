//! The unit sphere as six rational biquartic patches, four bilinear ones, and Newell's tea set.

use std::f64::consts::PI;

use pforms_operators::Spline;
use pforms_testkit::models::{bembel, document, text};
use pforms_testkit::numbers;

use crate::measure::{flux, total};
use crate::{gap, laws, pole_box, spline};

fn read(file: &str) -> Vec<Spline> {
    bembel::read(&text(&format!("bembel/{file}.dat"))).iter().map(spline).collect()
}

#[test]
fn six_patches_make_the_unit_sphere() {
    let patches = read("sphere6-biquartic");
    assert_eq!(patches.len(), 6);
    let steps: Vec<f64> = (0..=32).map(|i| f64::from(i) / 32.0).collect();
    let mut far = 0.0_f64;
    for patch in &patches {
        assert_eq!(patch.degrees(), [4, 4]);
        let points = patch.grid(&[&steps, &steps]).unwrap();
        let radii = points.as_chunks::<3>().0.iter().map(|[x, y, z]| x.hypot(*y).hypot(*z));
        far = radii.map(|r| (r - 1.0).abs()).fold(far, f64::max);
    }
    // The file has 15 digits.
    assert!(far <= 2e-15, "{far}");
    assert!((total(&patches, 24) - 4.0 * PI).abs() <= 1e-13);
    let volume: f64 = patches.iter().map(|patch| flux(patch, 24)).sum();
    assert!((volume.abs() - 4.0 * PI / 3.0).abs() <= 1e-13, "{volume}");
    for patch in &patches {
        laws::hold("sphere6", patch);
    }
}

#[test]
fn four_bilinear_patches() {
    let patches = read("fourpatches-bilinear");
    assert_eq!(patches.len(), 4);
    // Unit squares, not all the same way round.
    for patch in &patches {
        assert_eq!(patch.degrees(), [1, 1]);
        assert!((total(std::slice::from_ref(patch), 4) - 1.0).abs() < 1e-15);
        laws::hold("four patches", patch);
    }
}

/// Boxes, areas and exact fluxes of the tea set, of its patches taken as splines of one piece.
#[test]
fn the_tea_set_measures_what_it_should() {
    let expected = document("measures.json");
    let models = expected["models"].as_array().unwrap();
    assert_eq!(models.len(), 3);
    for model in models {
        let file = model["file"].as_str().unwrap();
        let patches: Vec<Spline> = bembel::read_bpt(&text(file)).iter().map(spline).collect();
        assert_eq!(patches.len() as u64, model["patches"]);
        let boxes = patches.iter().map(pole_box);
        let whole = boxes.reduce(|[a, b], [c, d]| {
            let pick = |a: &[f64], b: &[f64], f: fn(f64, f64) -> f64| -> Vec<f64> {
                a.iter().zip(b).map(|(x, y)| f(*x, *y)).collect()
            };
            [pick(&a, &c, f64::min), pick(&b, &d, f64::max)]
        });
        assert!(gap(&whole.unwrap().concat(), &numbers(&model["pole_box"])) == 0.0, "{file}");
        // Where a patch folds sharply the sum converges slowly.
        let area = total(&patches, 80);
        let uncertain = model["area_uncertainty"].as_f64().unwrap();
        let expected = model["area"].as_f64().unwrap();
        assert!((area - expected).abs() <= uncertain + 1e-13 * area, "{file}: {area}");
        // The integrand has degree 8: five nodes integrate it exactly.
        let enclosed: f64 = patches.iter().map(|patch| flux(patch, 5)).sum();
        let expected = numbers(&model["flux"])[0];
        assert!((enclosed - expected).abs() <= 1e-13 * area, "{file}: {enclosed} {expected}");
    }
}
