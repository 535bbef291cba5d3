//! A form of any dimension as one of three-dimensional space, and its homogeneous pieces.

use pforms_kernel::{Error, Form, Matrix, Result, bernstein_row, blossom_row, taylor_rows};

use crate::vector::Vec3;

/// The form in three-dimensional space.
///
/// Missing coordinates are 0; beyond three, the first three are kept, which projects the form
/// along the others.
pub fn embed(form: &Form) -> Result<Form> {
    if form.ambient() == 3 {
        return Ok(form.clone());
    }
    let kept = form.ambient().min(3);
    let mut poles = Vec::with_capacity(form.pole_count() * 4);
    for pole in form.homogeneous().chunks_exact(form.width()) {
        poles.extend_from_slice(&pole[..kept]);
        poles.extend(std::iter::repeat_n(0.0, 3 - kept));
        poles.push(pole[form.ambient()]);
    }
    Form::from_homogeneous(form.orders(), 3, poles)
}

/// Homogeneous poles of a form in space, four numbers each.
pub(crate) fn quadruples(form: &Form) -> &[[f64; 4]] {
    form.homogeneous().as_chunks::<4>().0
}

/// The point of a homogeneous quadruple; its weight must not be 0.
pub(crate) fn project(&[x, y, z, w]: &[f64; 4]) -> Vec3 {
    [x / w, y / w, z / w]
}

/// The finite poles: directions are left out.
pub fn poles(form: &Form) -> Result<Vec<Vec3>> {
    let embedded = embed(form)?;
    let finite = quadruples(&embedded).iter().filter(|pole| pole[3] != 0.0).map(project);
    Ok(finite.filter(|point| point.iter().all(|x| x.is_finite())).collect())
}

/// The form restricted to `[a, b]` along `axis`, which becomes `[0, 1]`.
pub(crate) fn window(form: &Form, axis: usize, a: f64, b: f64) -> Result<Form> {
    let degree = form.orders()[axis] - 1;
    let row = |i: usize| {
        let arguments: Vec<f64> = (0..degree).map(|k| if k < i { b } else { a }).collect();
        blossom_row(&arguments)
    };
    form.along(axis, &Matrix::from_rows((0..=degree).map(row).collect())?)
}

/// The homogeneous derivative along `axis`; nothing if the form is constant there.
pub(crate) fn derivative(form: &Form, axis: usize) -> Result<Option<Form>> {
    let degree = form.orders()[axis] - 1;
    if degree == 0 {
        return Ok(None);
    }
    let entry = |row: usize, column: usize| match column.wrapping_sub(row) {
        0 => -(degree as f64),
        1 => degree as f64,
        _ => 0.0,
    };
    form.along(axis, &Matrix::from_rule(degree, degree + 1, entry)).map(Some)
}

/// The form moved so that `centre` becomes the origin.
pub(crate) fn centred(form: &Form, centre: Vec3) -> Result<Form> {
    let mut poles = form.homogeneous().to_vec();
    for pole in poles.as_chunks_mut::<4>().0 {
        for k in 0..3 {
            pole[k] -= centre[k] * pole[3];
        }
    }
    Form::from_homogeneous(form.orders(), 3, poles)
}

/// Homogeneous values on the grid of `parameters`, derived once along `derived` if given.
///
/// A form whose poles are the values: the grid is a matrix along each axis.
pub(crate) fn tensor(form: &Form, parameters: &[&[f64]], derived: Option<usize>) -> Result<Form> {
    let mut values = form.clone();
    for (axis, list) in parameters.iter().enumerate() {
        let degree = form.orders()[axis] - 1;
        let row = |t: &f64| match derived {
            Some(along) if along == axis => taylor_rows(degree, 1, t).row(1).to_vec(),
            _ => bernstein_row(degree, t),
        };
        values = values.along(axis, &Matrix::from_rows(list.iter().map(row).collect())?)?;
    }
    Ok(values)
}

/// Complains unless the form has one of these numbers of axes.
pub(crate) fn require_axes(form: &Form, axes: usize, expected: &str) -> Result<()> {
    if form.axes() == axes {
        return Ok(());
    }
    Err(Error::shape("form", format!("a {}", form.kind()), expected))
}

/// `segments + 1` parameters from 0 to 1.
pub(crate) fn ticks(segments: usize) -> Vec<f64> {
    (0..=segments).map(|i| i as f64 / segments as f64).collect()
}
