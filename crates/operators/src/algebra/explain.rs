//! What an operator does, read off the operator itself.

use num_integer::Integer;
use pforms_kernel::{Form, Kind, Rational, Result, Scalar, limit};

use super::spline::indices;

/// The exact coefficients of each result pole in terms of the input poles, one line for each.
///
/// The operator is run once, in exact arithmetic, on inputs whose poles are the corners of a
/// simplex: the coordinates of the result *are* the coefficients. The poles of a single input
/// are called `p`, those of several inputs `a`, `b`, `c`, …; the result's `q`.
///
/// Errors: those of the operator; `Limit` when there are too many poles.
///
/// ```
/// use pforms_operators::{diagonal, explain};
/// let text = explain(&["pS33".parse()?], |forms| diagonal(&forms[0], 0, 1))?;
/// assert_eq!(text.lines().nth(2), Some("q2 = (p02 + 4·p11 + p20)/6"));
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn explain(
    kinds: &[Kind],
    operator: impl Fn(&[Form<Rational>]) -> Result<Form<Rational>>,
) -> Result<String> {
    let counts: Vec<usize> = kinds.iter().map(|kind| kind.orders().iter().product()).collect();
    let total: usize = counts.iter().sum::<usize>().max(1);
    limit::check::<Rational>("the table of coefficients", &[total, total], 1)?;
    let mut forms = Vec::with_capacity(kinds.len());
    let mut names = Vec::with_capacity(total);
    for (which, kind) in kinds.iter().enumerate() {
        forms.push(simplex_corners(kind, names.len(), total)?);
        names.extend(pole_names(&letter(kinds.len(), which), kind.orders()));
    }
    let result = operator(&forms)?;
    let results = pole_names("q", result.orders());
    let lines: Vec<String> = results
        .iter()
        .zip(result.homogeneous().chunks_exact(result.width()))
        .map(|(name, pole)| format!("{name} = {}", sum(&pole[..total], &names)))
        .collect();
    Ok(lines.join("\n"))
}

/// A form whose pole number `i` is the corner `start + i` of a simplex with `total` corners.
fn simplex_corners(kind: &Kind, start: usize, total: usize) -> Result<Form<Rational>> {
    let count: usize = kind.orders().iter().product();
    let mut points = vec![<Rational as Scalar>::zero(); count * total];
    for i in 0..count {
        points[i * total + start + i] = <Rational as Scalar>::one();
    }
    Form::from_points(kind.orders(), total, &points, None)
}

fn letter(inputs: usize, which: usize) -> String {
    if inputs == 1 {
        return "p".to_owned();
    }
    match u8::try_from(which) {
        Ok(small) if small < 15 => char::from(b'a' + small).to_string(),
        _ => format!("f{which}_"),
    }
}

fn pole_names(letter: &str, orders: &[usize]) -> Vec<String> {
    let digits = orders.iter().all(|&order| order <= 10);
    let name = |index: &Vec<usize>| {
        let parts: Vec<String> = index.iter().map(usize::to_string).collect();
        if digits {
            format!("{letter}{}", parts.concat())
        } else {
            format!("{letter}[{}]", parts.join(","))
        }
    };
    indices(orders).iter().map(name).collect()
}

/// `Σ cᵢ·nameᵢ` over a common denominator, as the book prints it.
fn sum(coefficients: &[Rational], names: &[String]) -> String {
    let denominator = coefficients
        .iter()
        .fold(<Rational as Scalar>::one().to_integer(), |all, c| all.lcm(c.denom()));
    let mut text = String::new();
    let mut terms = 0;
    for (coefficient, name) in coefficients.iter().zip(names) {
        let times = (coefficient * denominator.clone()).to_integer();
        let magnitude = times.magnitude();
        if magnitude.bits() == 0 {
            continue;
        }
        let negative = *coefficient < <Rational as Scalar>::zero();
        text += match (terms, negative) {
            (0, false) => "",
            (0, true) => "−",
            (_, false) => " + ",
            (_, true) => " − ",
        };
        if magnitude.bits() > 1 {
            text += &magnitude.to_string();
            text.push('·');
        }
        text += name;
        terms += 1;
    }
    match (terms, denominator.bits() > 1) {
        (0, _) => "0".to_owned(),
        (_, false) => text,
        (1, true) => format!("{text}/{denominator}"),
        (_, true) => format!("({text})/{denominator}"),
    }
}
