//! Scenes and models that several tests use.
#![allow(dead_code, missing_docs, unreachable_pub, clippy::unwrap_used)]

use pforms_formats::bpt;
use pforms_kernel::Form;
use pforms_scene::{Mode, Scene, Shapes, Style};
use pforms_testkit::octant;

pub const TEAPOT: &[u8] = include_bytes!("../../../../cases/models/newell-teapot32.bpt");

pub fn teapot() -> Vec<Form> {
    bpt::read(TEAPOT).unwrap().into_iter().map(|named| named.net().clone()).collect()
}

pub fn style(draw: &[Mode], color: &str, opacity: f64) -> Style {
    Style {
        draw: draw.to_vec(),
        color: color.parse().unwrap(),
        opacity,
        radius: 0.02,
        ..Style::default()
    }
}

/// A cube, half transparent, with a curve, its poles, a fibre bundle and normals: every part.
pub fn mixed_scene() -> Scene {
    let corners: Vec<f64> =
        (0..8).flat_map(|k| [k >> 2 & 1, k >> 1 & 1, k & 1].map(|x| f64::from(x) - 0.5)).collect();
    let cube = Form::from_points(&[2, 2, 2], 3, &corners, None).unwrap();
    let arc = [-0.5, -0.5, -0.5, 0.5, 0.5, -0.5, -0.5, 0.5, 0.5, 0.5, 0.5, 0.5];
    let curve = Form::from_points(&[4], 3, &arc, None).unwrap();
    let mut scene = Scene { axes: true, ..Scene::default() };
    let mut add = |name: &str, form: &Form, style: Style| {
        scene.add(name, &Shapes::of(vec![form.clone()]), style).unwrap();
    };
    add("cube", &cube, style(&[Mode::Envelope], "#ffff00", 0.5));
    add("bundle", &cube, style(&[Mode::Fibres], "#3d5a80", 0.5));
    add("curve", &curve, style(&[Mode::Curve, Mode::Poles], "#ff0000", 1.0));
    add("octant", &octant([0.6; 3]), style(&[Mode::Surface, Mode::Normals], "#00ff00", 1.0));
    add("point", &Form::point(&[0.7, 0.7, -0.7]).unwrap(), style(&[], "#ffffff", 1.0));
    scene
}
