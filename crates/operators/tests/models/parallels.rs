//! Parallels, certificates and unrollings of real surfaces.

use pforms_kernel::{Error, Form};
use pforms_operators::{ParallelOptions, Spline, is_developable, parallel, surface_frame, unroll};
use pforms_testkit::models::{bembel, text};

use crate::spline;

#[test]
fn the_sphere_of_bembel_is_parallel_to_spheres_exactly() {
    // Six rational patches of degree 4, 4: nobody says that they are a sphere.
    for patch in bembel::read(&text("bembel/sphere6-biquartic.dat")).iter().map(spline) {
        let inside = surface_frame(&patch.piece(&[0, 0]).unwrap(), 0.5, 0.5).unwrap();
        let outwards: f64 =
            inside.normal.unwrap().iter().zip(&inside.point).map(|(n, x)| n * x).sum();
        let found =
            parallel(patch.clone(), 0.5 * outwards.signum(), &ParallelOptions::new(1e-11)).unwrap();
        assert_eq!(found.spline.counts(), patch.counts(), "no patch is cut");
        for i in 0..=10 {
            for j in 0..=10 {
                let p = found.spline.at(&[f64::from(i) / 10.0, f64::from(j) / 10.0]).unwrap();
                let radius = p.iter().map(|x| x * x).sum::<f64>().sqrt();
                assert!((radius - 1.5).abs() <= found.error + 1e-12, "{radius}");
            }
        }
        let certificate = is_developable(patch.clone()).unwrap();
        assert!((certificate.gauss - 1.0).abs() < 1e-9);
    }
}

#[test]
fn the_tea_set_has_parallels_where_its_normals_allow_it() {
    let (mut found, mut folded, mut bare) = (0, 0, 0);
    for file in ["newell-teapot32.bpt", "newell-teacup26.bpt", "newell-teaspoon16.bpt"] {
        for (index, patch) in bembel::read_bpt(&text(file)).iter().map(spline).enumerate() {
            let form = patch.piece(&[0, 0]).unwrap();
            match parallel(patch, 0.004, &ParallelOptions::new(1e-5)) {
                Ok(near) => {
                    let worst = farthest(&form, &near.spline, 0.004);
                    assert!(worst <= near.error, "{file} {index}: {worst:e} {:e}", near.error);
                    found += 1;
                }
                Err(Error::Degenerate(fault)) if fault.argument == "distance" => folded += 1,
                Err(Error::Degenerate(_)) => bare += 1,
                Err(error) => panic!("{file} {index}: {error}"),
            }
        }
    }
    // The knob of the lid is a loop of a fiftieth of a unit, whose normal turns over on the way round.
    assert_eq!((found, folded, bare), (62, 4, 8));
}

/// How far the parallel is from its true place at a grid of points, where there is a normal.
fn farthest(form: &Form, near: &Spline, distance: f64) -> f64 {
    let mut worst = 0.0_f64;
    for i in 0..=12 {
        for j in 0..=12 {
            let at = [f64::from(i) / 12.0, f64::from(j) / 12.0];
            let frame = surface_frame(form, at[0], at[1]).unwrap();
            let normal = frame.normal.unwrap();
            let wanted = frame.point.iter().zip(&normal).map(|(x, n)| x + distance * n);
            let there = near.at(&at).unwrap();
            let gap = wanted.zip(&there).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt();
            worst = worst.max(gap);
        }
    }
    worst
}

#[test]
fn the_tea_set_does_not_lie_flat_but_for_what_is_flat() {
    for patch in bembel::read_bpt(&text("newell-teapot32.bpt")).iter().map(spline).take(8) {
        let developable = is_developable(patch.clone()).unwrap().developable;
        let distortion = unroll(patch, 1e-6).unwrap().distortion;
        assert_eq!(developable, distortion.length < 1e-6, "{distortion:?}");
    }
}
