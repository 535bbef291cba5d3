//! The net of a patch from the nets of its faces: the Boolean sum, on poles.
//!
//! A linear blend along an axis of order `n` has the poles `i/(n−1)`, so blending the form and blending
//! its net are the same thing; of splines, the poles of the parameter are Greville's abscissae.

use pforms_kernel::{Form, Result, Scalar, limit};

use super::faces::Faces;

/// The patch whose faces agree wherever they meet; `at[k]` are the poles of parameter `k` itself,
/// from 0 to 1.
pub(super) fn filled<S: Scalar>(faces: &Faces<S>, at: &[Vec<S>]) -> Result<Form<S>> {
    let orders: Vec<usize> = at.iter().map(Vec::len).collect();
    let first = &faces.forms()[0];
    let (ambient, width) = (first.ambient(), first.width());
    let count = limit::check::<S>("the patch", &orders, width)?;
    let mut border = vec![S::zero(); count];
    for (index, form) in faces.forms().iter().enumerate().rev() {
        let (axis, side) = faces.place(index);
        let inner = orders[axis + 1..].iter().product::<usize>() * width;
        let start = side * (orders[axis] - 1) * inner;
        let blocks = border.chunks_exact_mut(orders[axis] * inner);
        for (block, line) in blocks.zip(form.homogeneous().chunks_exact(inner)) {
            block[start..start + inner].clone_from_slice(line);
        }
    }
    let mut rest = border.clone();
    for (axis, at) in at.iter().enumerate() {
        let inner = orders[axis + 1..].iter().product::<usize>() * width;
        for block in rest.chunks_exact_mut(at.len() * inner) {
            take_blend_away(block, at, inner);
        }
    }
    // The border less what is left of it is the border, to the bit: along its own axis a face is
    // taken away whole.
    let poles = border.into_iter().zip(rest).map(|(x, left)| x - left).collect();
    let patch = Form::from_homogeneous(&orders, ambient, poles)?;
    let mut weights = faces.forms().iter().map(Form::uniform_weight);
    let weight = first.uniform_weight();
    Ok(match weight {
        Some(weight) if weights.all(|other| other == Some(weight)) => {
            patch.with_uniform_weight(weight)
        }
        _ => patch,
    })
}

/// `lines[i] −= (1 − at[i])·first + at[i]·last`.
fn take_blend_away<S: Scalar>(block: &mut [S], at: &[S], inner: usize) {
    let last = block.len() - inner;
    let (start, end) = (block[..inner].to_vec(), block[last..].to_vec());
    for (line, t) in block.chunks_exact_mut(inner).zip(at) {
        S::add_multiple(line, &(t.clone() - S::one()), &start);
        S::add_multiple(line, &-t.clone(), &end);
    }
}
