//! A few copies of a form, copies of these, and so on: the sets of Cantor and Sierpinski.

use pforms_kernel::{Error, Form, Result, Scalar, limit};

use super::split;

/// What becomes of a form in one generation.
#[derive(Clone, Debug, PartialEq)]
pub enum Rule<S = f64> {
    /// The first and the last third along every axis: 2 of 3 parts of a curve (Cantor 1883), 4 of 9
    /// of a surface, 8 of 27 of a volume.
    Cantor,
    /// All thirds but those that are in the middle along two axes or more, along the only one of a
    /// curve: 8 of 9 parts of a surface (Sierpinski 1916), 20 of 27 of a volume (Menger 1926).
    Sponge,
    /// The homotheties of this ratio whose centres are the poles: of a triangle of poles and the ratio
    /// 1/2 Sierpinski's gasket, of two poles and the ratio 1/3 Cantor's set.
    Sierpinski(S),
}

/// The forms of generation `n`: each form of the one before is replaced by its copies, in order.
///
/// Exact: parts of a form are the form itself, copies are its images. With `m` copies in a
/// generation there are `mⁿ`. Book 37, remark 1.
///
/// Errors: `Shape` for a point, unless its pole is a centre; `Domain` for a centre at infinity; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Rule, iterate};
/// let unit: Form = Form::from_points(&[2], 1, &[0., 9.], None)?;
/// let ends: Vec<f64> = iterate(&unit, 2, &Rule::Cantor)?
///     .iter().flat_map(|part| part.points().unwrap()).map(f64::round).collect();
/// assert_eq!(ends, [0., 1., 2., 3., 6., 7., 8., 9.]);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn iterate<S: Scalar>(form: &Form<S>, n: usize, rule: &Rule<S>) -> Result<Vec<Form<S>>> {
    if form.axes() == 0 && !matches!(rule, Rule::Sierpinski(_)) {
        return Err(Error::shape("form", form.kind(), "a form with an axis"));
    }
    let copies = copies(form, rule);
    let counts = vec![copies; n.min(256)];
    limit::check::<S>(
        "the generation",
        &[&counts[..], &[form.pole_count()]].concat(),
        form.width(),
    )?;
    let mut generation = vec![form.clone()];
    // A single copy is a generation like any other, but no more than a few are ever different.
    for _ in 0..if copies == 1 { n.min(4096) } else { n } {
        let mut next = Vec::with_capacity(generation.len() * copies);
        for form in &generation {
            next.extend(match rule {
                Rule::Sierpinski(ratio) => images(form, ratio)?,
                _ => parts(form, rule)?,
            });
        }
        generation = next;
    }
    Ok(generation)
}

/// How many copies a rule makes of a form.
fn copies<S: Scalar>(form: &Form<S>, rule: &Rule<S>) -> usize {
    let axes = form.axes() as u32;
    match rule {
        Rule::Cantor => 2_usize.saturating_pow(axes),
        Rule::Sponge if axes == 1 => 2,
        Rule::Sponge => {
            let corners = 2_usize.saturating_pow(axes - 1);
            corners.saturating_mul(2 + axes as usize)
        }
        Rule::Sierpinski(_) => form.pole_count(),
    }
}

/// Thirds along every axis, those that the rule keeps, the last axis fastest.
fn parts<S: Scalar>(form: &Form<S>, rule: &Rule<S>) -> Result<Vec<Form<S>>> {
    let most = usize::from(matches!(rule, Rule::Sponge) && form.axes() > 1);
    let mut kept = vec![(form.clone(), 0)];
    for axis in 0..form.axes() {
        let mut finer = Vec::with_capacity(3 * kept.len());
        for (part, middles) in kept {
            let (first, rest) = split(&part, axis, &S::ratio(1, 3))?;
            let (middle, last) = split(&rest, axis, &S::ratio(1, 2))?;
            finer.push((first, middles));
            if middles < most {
                finer.push((middle, middles + 1));
            }
            finer.push((last, middles));
        }
        kept = finer;
    }
    Ok(kept.into_iter().map(|(part, _)| part).collect())
}

/// The images under the homotheties centred at the poles, in their order.
fn images<S: Scalar>(form: &Form<S>, ratio: &S) -> Result<Vec<Form<S>>> {
    let width = form.width();
    let rest = S::one() - ratio.clone();
    let image = |centre: &[S]| -> Result<Form<S>> {
        let weight = &centre[width - 1];
        if weight.is_zero() {
            return Err(Error::domain("form", "a pole at infinity", "poles that can be centres"));
        }
        let mut poles = Vec::with_capacity(form.homogeneous().len());
        for pole in form.homogeneous().chunks_exact(width) {
            for (x, c) in pole[..width - 1].iter().zip(centre) {
                let fixed = c.clone() / weight.clone() * pole[width - 1].clone();
                poles.push(ratio.clone() * x.clone() + rest.clone() * fixed);
            }
            poles.push(pole[width - 1].clone());
        }
        Form::from_homogeneous(form.orders(), form.ambient(), poles)
    };
    form.homogeneous().chunks_exact(width).map(image).collect()
}
