//! Forms and a style to parts.

use pforms_kernel::{Error, Form, Result};
use pforms_mesh::{
    Mesh, Polyline, Sampling, chain, curve, envelope, fibres, leaves, net, normals, patches,
    points, poles, require_room, surfaces,
};
use pforms_operators::{Poles, Shape};

use crate::{Mode, Part, Shading, Shapes, Style};

/// Draws forms in a style: for each way of drawing, what it makes of all forms it suits.
///
/// Patches with a common edge are meshed together, without cracks.
///
/// Errors: `Shape` when a way of drawing suits none of the forms; those of [`Style::check`], of
/// sampling and meshing.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_scene::{Part, Shapes, Style, draw};
/// let parabola = Form::from_points(&[3], 2, &[0., 0., 1., 2., 2., 0.], None)?;
/// let parts = draw(&Shapes::of(vec![parabola]), &Style::default())?;
/// let [Part::Lines { polylines, .. }] = parts.as_slice() else { panic!() };
/// assert_eq!(polylines[0].points.len(), 17);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn draw(shapes: &Shapes, style: &Style) -> Result<Vec<Part>> {
    style.check()?;
    if style.draw.is_empty() {
        return usual(shapes, style);
    }
    let mut parts = Vec::new();
    for mode in &style.draw {
        let suits = |shape: &&Shape| Mode::suiting(shape.net()).contains(mode);
        let suited: Vec<&Shape> = shapes.as_slice().iter().filter(suits).collect();
        let suits = |mesh: &&Mesh| Mode::suiting_mesh(mesh).contains(mode);
        let meshes: Vec<&Mesh> = shapes.meshes().iter().filter(suits).collect();
        if suited.is_empty() && meshes.is_empty() {
            return Err(unsuited(*mode, shapes));
        }
        if !suited.is_empty() {
            parts.extend(in_mode(*mode, &suited, &shapes.nets(), style)?);
        }
        parts.extend(meshes.into_iter().flat_map(|mesh| of_mesh(*mode, mesh, style)));
    }
    Ok(parts)
}

/// Each form in its most usual way, forms of one way together.
fn usual(shapes: &Shapes, style: &Style) -> Result<Vec<Part>> {
    let mut parts = Vec::new();
    for mode in [Mode::Surface, Mode::Envelope, Mode::Curve, Mode::Points] {
        let suits = |shape: &&Shape| Mode::suiting(shape.net()).first() == Some(&mode);
        let suited: Vec<&Shape> = shapes.as_slice().iter().filter(suits).collect();
        if !suited.is_empty() {
            parts.extend(in_mode(mode, &suited, &[], style)?);
        }
    }
    for mesh in shapes.meshes() {
        let usual = Mode::suiting_mesh(mesh).iter().take(1);
        parts.extend(usual.flat_map(|mode| of_mesh(*mode, mesh, style)));
    }
    Ok(parts)
}

fn in_mode(mode: Mode, shapes: &[&Shape], nets: &[&Form], style: &Style) -> Result<Vec<Part>> {
    let sampling = &style.sampling();
    let (count, axis) = (style.count, style.axis);
    let pieces = gathered(shapes, |shape| shape.pieces())?;
    let forms: &[&Form] = &pieces.iter().collect::<Vec<_>>();
    forecast(mode, forms, sampling)?;
    Ok(match mode {
        Mode::Points => vec![spheres(gathered(forms, |form| points(form, sampling))?, style)],
        Mode::Curve => vec![tubes(gathered(shapes, |shape| lines(shape, sampling))?, style)],
        Mode::Surface => triangles(&pieces, sampling, style)?,
        Mode::Envelope => triangles(&gathered(shapes, |shape| outside(shape))?, sampling, style)?,
        Mode::Sheets => {
            let across = |shape: &&Shape| leaves(shape, axis, count);
            let sheets = gathered(shapes, across)?;
            let sheets = gathered(&sheets, Shape::pieces)?;
            triangles(&sheets, &without(sampling, axis), style)?
        }
        Mode::Fibres => {
            let bundle = gathered(shapes, |shape| fibres(shape, axis, count))?;
            let along = only(sampling, axis);
            let pieces = gathered(&bundle, Shape::pieces)?;
            forecast(Mode::Curve, &pieces.iter().collect::<Vec<_>>(), &along)?;
            vec![tubes(gathered(&bundle, |fibre| lines(fibre, &along))?, style)]
        }
        Mode::Net => {
            let wires = tubes_of(gathered(nets, |form| net(form))?, style.radius / 3.0);
            vec![wires, spheres(gathered(nets, |form| poles(form))?, style)]
        }
        Mode::Poles => vec![spheres(gathered(nets, |form| poles(form))?, style)],
        Mode::Normals => {
            let needles = |form: &&Form| normals(form, sampling, style.length);
            vec![tubes(gathered(forms, needles)?, style)]
        }
    })
}

/// A mesh in a way that suits it: its triangles, its edges, its vertices.
fn of_mesh(mode: Mode, mesh: &Mesh, style: &Style) -> Vec<Part> {
    match mode {
        Mode::Points => vec![spheres(mesh.places(), style)],
        Mode::Net => vec![tubes_of(mesh.wires(), style.radius / 3.0)],
        _ => {
            let shaded = mesh.shaded();
            let flat = style.shading == Shading::Flat;
            vec![Part::Triangles(if flat { shaded.flat() } else { shaded })]
        }
    }
}

/// Refuses clouds and bundles that would be too large, before any of them is made.
///
/// What cannot be counted (a curve through infinity within a tolerance) is left to the meshing.
fn forecast(mode: Mode, forms: &[&Form], sampling: &Sampling) -> Result<()> {
    if !matches!(mode, Mode::Points | Mode::Curve) {
        return Ok(());
    }
    let samples = |form: &&Form| -> usize {
        let segments = sampling.segments(form).unwrap_or_default();
        segments.iter().map(|count| count + 1).product()
    };
    let total = forms.iter().map(samples).fold(0, usize::saturating_add);
    require_room("the drawing", &[total])
}

fn triangles(forms: &[Form], sampling: &Sampling, style: &Style) -> Result<Vec<Part>> {
    let mut meshes = surfaces(forms, sampling)?.into_iter();
    let mut all = meshes.next().unwrap_or_default();
    for mesh in meshes {
        all.append(&mesh);
    }
    let shaded = if style.shading == Shading::Flat { all.flat() } else { all };
    Ok(vec![Part::Triangles(shaded)])
}

fn spheres(positions: Vec<pforms_mesh::vector::Vec3>, style: &Style) -> Part {
    Part::Points { positions, radius: style.radius }
}

fn tubes(polylines: Vec<Polyline>, style: &Style) -> Part {
    tubes_of(polylines, style.radius)
}

fn tubes_of(polylines: Vec<Polyline>, radius: f64) -> Part {
    Part::Lines { polylines, radius }
}

fn lines(shape: &Shape, sampling: &Sampling) -> Result<Vec<Polyline>> {
    let drawn = match shape {
        Shape::Form(form) => curve(form, sampling)?,
        Shape::Spline(spline) => chain(spline, sampling)?,
    };
    Ok(drawn.polylines)
}

/// The faces of a volume.
fn outside(shape: &Shape) -> Result<Vec<Form>> {
    match shape {
        Shape::Form(form) => envelope(form),
        Shape::Spline(spline) => patches(spline),
    }
}

fn gathered<A, T>(list: &[A], of: impl Fn(&A) -> Result<Vec<T>>) -> Result<Vec<T>> {
    let mut all = Vec::new();
    for item in list {
        all.extend(of(item)?);
    }
    Ok(all)
}

/// The sampling of a leaf, which lacks `axis`.
fn without(sampling: &Sampling, axis: usize) -> Sampling {
    match sampling {
        Sampling::Fineness(levels) if levels.len() > 1 && axis < levels.len() => {
            let mut levels = levels.clone();
            levels.remove(axis);
            Sampling::Fineness(levels)
        }
        other => other.clone(),
    }
}

/// The sampling of a fibre, which has nothing but `axis`.
fn only(sampling: &Sampling, axis: usize) -> Sampling {
    match sampling {
        Sampling::Fineness(levels) if levels.len() > 1 => {
            Sampling::Fineness(levels.get(axis).into_iter().copied().collect())
        }
        other => other.clone(),
    }
}

fn unsuited(mode: Mode, shapes: &Shapes) -> Error {
    let forms = shapes.nets();
    let kinds = forms.iter().map(|form| form.kind().to_string());
    let word = |mesh: &Mesh| if mesh.is_cloud() { "a cloud" } else { "a mesh" }.to_owned();
    let kinds: Vec<String> = kinds.chain(shapes.meshes().iter().map(word)).take(3).collect();
    let first = forms.first().map(|form| Mode::suiting(form));
    let ways: Vec<String> = first
        .or(shapes.meshes().first().map(Mode::suiting_mesh))
        .unwrap_or_default()
        .iter()
        .map(|mode| format!("{mode:?}").to_lowercase())
        .collect();
    Error::shape(
        "draw",
        format!("{:?} for {}", format!("{mode:?}").to_lowercase(), kinds.join(", ")),
        format!("one of {}", ways.join(", ")),
    )
}
