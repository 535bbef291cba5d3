//! A drawn value as objects of POV-Ray.

use std::fmt::Write;

use pforms_kernel::{Form, Result};
use pforms_mesh::vector::{Vec3, norm, subtract};
use pforms_mesh::{Polyline, Sampling, Triangles, embed, surfaces};
use pforms_scene::{Item, Mode, Part, Shading, Style};

use super::vector;

/// The most halvings of a native patch: 4⁵ pieces, which are smooth in any picture.
const MOST_STEPS: u32 = 5;

/// Writes a value under its name. Writing to a string cannot fail.
pub(super) fn write(text: &mut String, item: &Item) -> Result<()> {
    let name: String = item.name.chars().filter(|c| !c.is_control()).collect();
    let _ = writeln!(text, "\n// {name}");
    let texture = texture(&item.style);
    if let Some(patches) = native(item)? {
        return write_patches(text, &patches, &item.style.sampling(), &texture);
    }
    for part in &item.parts {
        match part {
            Part::Points { positions, radius } => spheres(text, positions, *radius, &texture),
            Part::Lines { polylines, radius } => {
                let clear = item.style.opacity < 1.0;
                for line in polylines {
                    tube(text, line, *radius, clear, &texture);
                }
            }
            Part::Triangles(mesh) => mesh2(text, mesh, &texture),
        }
    }
    Ok(())
}

fn texture(style: &Style) -> String {
    let [red, green, blue] = style.color.encoded();
    let clear = 1.0 - style.opacity;
    format!(
        "texture {{ pigment {{ color srgbt <{red:.4}, {green:.4}, {blue:.4}, {clear:.4}> }} \
         finish {{ ambient 0.25 diffuse 0.75 specular 0.3 roughness 0.02 }} }}"
    )
}

/// The patches of a value that is drawn as bicubic polynomial surfaces and nothing else.
fn native(item: &Item) -> Result<Option<Vec<Form>>> {
    let plain = matches!(item.style.draw.as_slice(), [] | [Mode::Surface]);
    let bicubic = |form: &Form| form.orders() == [4, 4] && !form.is_rational();
    if !plain
        || item.forms.is_empty()
        || item.style.shading == Shading::Flat
        || !item.forms.iter().all(bicubic)
    {
        return Ok(None);
    }
    let patches: Vec<Form> = item.forms.iter().map(embed).collect::<Result<_>>()?;
    Ok(patches.iter().all(|patch| patch.points().is_ok()).then_some(patches))
}

/// Native patches, but for those with a collapsed edge: POV-Ray has no normals there.
fn write_patches(
    text: &mut String,
    patches: &[Form],
    sampling: &Sampling,
    texture: &str,
) -> Result<()> {
    let (collapsed, regular): (Vec<Form>, Vec<Form>) =
        patches.iter().cloned().partition(has_collapsed_edge);
    let mut finest = 1;
    for patch in &regular {
        finest = sampling.segments(patch)?.into_iter().fold(finest, usize::max);
    }
    let steps = finest.next_power_of_two().ilog2().min(MOST_STEPS);
    for patch in &regular {
        bicubic(text, patch, steps, texture)?;
    }
    for mesh in surfaces(&collapsed, sampling)? {
        mesh2(text, &mesh, texture);
    }
    Ok(())
}

fn has_collapsed_edge(patch: &Form) -> bool {
    let (poles, _) = patch.homogeneous().as_chunks::<4>();
    let same = |first: usize, step: usize| (1..4).all(|k| poles[first + k * step] == poles[first]);
    same(0, 1) || same(12, 1) || same(0, 4) || same(3, 4)
}

fn bicubic(text: &mut String, patch: &Form, steps: u32, texture: &str) -> Result<()> {
    let points = patch.points()?;
    let poles: Vec<String> = points.as_chunks::<3>().0.iter().map(|pole| vector(*pole)).collect();
    let rows: Vec<String> = poles.chunks(4).map(|row| row.join(", ")).collect();
    let _ = writeln!(
        text,
        "bicubic_patch {{\n  type 1 flatness 0 u_steps {steps} v_steps {steps}\n  {}\n  {texture}\n}}",
        rows.join(",\n  "),
    );
    Ok(())
}

fn spheres(text: &mut String, centres: &[Vec3], radius: f64, texture: &str) {
    match centres {
        [] => {}
        [only] => {
            let _ = writeln!(text, "sphere {{ {}, {radius:?} {texture} }}", vector(*only));
        }
        several => {
            text.push_str("union {\n");
            for centre in several {
                let _ = writeln!(text, "  sphere {{ {}, {radius:?} }}", vector(*centre));
            }
            let _ = writeln!(text, "  {texture}\n}}");
        }
    }
}

/// Cylinders and spheres at their joints; what one sees through must be a single body.
fn tube(text: &mut String, line: &Polyline, radius: f64, clear: bool, texture: &str) {
    let mut points: Vec<Vec3> = Vec::with_capacity(line.points.len());
    for point in &line.points {
        let apart = points.last().is_none_or(|last| norm(subtract(*point, *last)) > 1e-6 * radius);
        if apart {
            points.push(*point);
        }
    }
    if points.len() < 2 {
        return;
    }
    if clear {
        let spheres: Vec<String> =
            points.iter().map(|point| format!("  {}, {radius:?}", vector(*point))).collect();
        let _ = writeln!(
            text,
            "sphere_sweep {{\n  linear_spline {},\n{}\n  {texture}\n}}",
            points.len(),
            spheres.join(",\n"),
        );
        return;
    }
    text.push_str("union {\n");
    for pair in points.windows(2) {
        let [from, to] = [pair[0], pair[1]].map(vector);
        let _ = writeln!(text, "  cylinder {{ {from}, {to}, {radius:?} }}");
    }
    for point in &points {
        let _ = writeln!(text, "  sphere {{ {}, {radius:?} }}", vector(*point));
    }
    let _ = writeln!(text, "  {texture}\n}}");
}

fn mesh2(text: &mut String, mesh: &Triangles, texture: &str) {
    if mesh.indices.is_empty() {
        return;
    }
    text.push_str("mesh2 {\n");
    for (name, list) in [("vertex", &mesh.positions), ("normal", &mesh.normals)] {
        let _ = write!(text, "  {name}_vectors {{ {}", list.len());
        for triple in list {
            let _ = write!(text, ",\n    {}", vector(*triple));
        }
        text.push_str("\n  }\n");
    }
    let _ = write!(text, "  face_indices {{ {}", mesh.indices.len());
    for [a, b, c] in &mesh.indices {
        let _ = write!(text, ",\n    <{a}, {b}, {c}>");
    }
    let _ = writeln!(text, "\n  }}\n  {texture}\n}}");
}
