//! POV-Ray itself judges its scenes: no warning, and something to be seen.
#![allow(missing_docs, clippy::unwrap_used)]

mod common;

use std::path::PathBuf;
use std::process::Command;

use common::{mixed_scene, style, teapot};
use pforms_formats::pov;
use pforms_scene::{Camera, Mode, Scene, Shapes, Style, View};
use pforms_testkit::octant;

fn installed() -> bool {
    Command::new("povray").arg("--version").output().is_ok()
}

/// Renders a scene; asserts that there is no warning and that the picture is not uniform.
fn render(name: &str, scene: &Scene) {
    if !installed() {
        eprintln!("povray is not installed: {name} was not rendered");
        return;
    }
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let (input, output) = (folder.join(format!("{name}.pov")), folder.join(format!("{name}.ppm")));
    std::fs::write(&input, pov::write(scene).unwrap()).unwrap();
    let told = Command::new("povray")
        .arg(format!("+I{}", input.display()))
        .arg(format!("+O{}", output.display()))
        .args(["+FP", "+W160", "+H160", "-D", "+WT2"])
        .output()
        .unwrap();
    let words = String::from_utf8_lossy(&told.stderr);
    assert!(told.status.success(), "{name}: {words}");
    let warning = words.lines().find(|line| line.contains("Warning:"));
    assert!(warning.is_none(), "{name}: {warning:?}");
    let picture = std::fs::read(&output).unwrap();
    let pixels = &picture[picture.len() - 160 * 160 * 3..];
    let drawn = pixels.chunks(3).filter(|pixel| *pixel != &pixels[..3]).count();
    assert!(drawn > 160 * 160 / 100, "{name}: only {drawn} pixels differ from the corner");
}

#[test]
fn every_part_renders_from_every_view() {
    for view in [View::Ox, View::Oy, View::Oz, View::Axo, View::Perspective] {
        let mut scene = mixed_scene();
        scene.camera = Camera { view, ..Camera::default() };
        render(&format!("mixed_{view:?}"), &scene);
    }
}

#[test]
fn the_teapot_stays_made_of_patches() {
    let mut scene = Scene::default();
    scene.add("teapot", &Shapes::of(teapot()), Style::default()).unwrap();
    let text = String::from_utf8(pov::write(&scene).unwrap()).unwrap();
    let counts = ["bicubic_patch", "mesh2"].map(|object| text.matches(object).count());
    assert_eq!(counts, [28, 4], "the bottom collapses in the middle");
    render("teapot", &scene);
    let flat = Style { shading: pforms_scene::Shading::Flat, ..Style::default() };
    let mut scene = Scene::default();
    scene.add("teapot", &Shapes::of(teapot()), flat).unwrap();
    assert!(String::from_utf8(pov::write(&scene).unwrap()).unwrap().contains("mesh2"));
    render("teapot_flat", &scene);
}

#[test]
fn clear_things_and_odd_names_render() {
    let mut scene = Scene { axes: true, ..Scene::default() };
    let shapes = Shapes::of(vec![octant([1.0; 3])]);
    scene.add("a\nb */ c", &shapes, style(&[Mode::Surface, Mode::Net], "#336699", 0.4)).unwrap();
    scene.add("sphere { }", &shapes, style(&[Mode::Points, Mode::Fibres], "#993366", 0.4)).unwrap();
    render("clear", &scene);
}

#[test]
fn the_smallest_and_the_emptiest_render() {
    let text = pov::write(&Scene::default()).unwrap();
    assert!(text.starts_with(b"// pforms\n#version 3.7;"));
    for exponent in [-12, -3, 3, 12] {
        let size = 10_f64.powi(exponent);
        let mut scene = Scene { axes: true, ..Scene::default() };
        let corners = [0., 0., 0., 0., size, 0., size, 0., 0., size, size, size];
        let facet = pforms_kernel::Form::from_points(&[2, 2], 3, &corners, None).unwrap();
        let mut look = style(&[Mode::Surface, Mode::Net], "#aa5500", 0.7);
        look.radius = 0.05 * size;
        scene.add("facet", &Shapes::of(vec![facet]), look).unwrap();
        render(&format!("size{exponent}"), &scene);
    }
}
