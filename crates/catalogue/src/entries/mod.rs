//! The entries, one file for each chapter.

// Routines share one signature, those that cannot fail too.
#![allow(clippy::unnecessary_wraps)]

mod combining;
mod conditions;
mod conics;
mod deforming;
mod differentiating;
mod evaluating;
mod explaining;
mod folding;
mod forms;
mod framing;
mod geodesics;
mod gestures;
mod harmony;
mod immersing;
mod interpolating;
mod intersecting;
mod iterating;
mod joining;
mod knotting;
mod lengths;
mod lists;
mod measuring;
mod mirroring;
mod numbers;
mod offsetting;
mod pieces;
mod piping;
mod planking;
mod products;
mod projecting;
mod quadrics;
mod relaxing;
mod solids;
mod spanning;
mod splining;
mod spreading;
mod sweeping;
mod through_points;
mod transforming;
mod turning;
mod windows;

use pforms_kernel::Form;
use pforms_operators::{Shape, Spline};

use crate::cost::workable_spline;
use crate::operator::Group;
use crate::words::words;
use crate::{Arithmetic, Failure, Operator, Parameter, Takes, Value, Words};

/// Every entry, in the order of the book.
pub(crate) fn all() -> Vec<Operator> {
    let numbers = numbers::entries();
    let mut all: Vec<Operator> = [
        gestures::ENTRIES,
        explaining::ENTRIES,
        windows::ENTRIES,
        evaluating::ENTRIES,
        framing::ENTRIES,
        interpolating::ENTRIES,
        immersing::ENTRIES,
        sweeping::ENTRIES,
        spanning::ENTRIES,
        conics::ENTRIES,
        quadrics::ENTRIES,
        products::ENTRIES,
        offsetting::ENTRIES,
        piping::ENTRIES,
        projecting::ENTRIES,
        measuring::ENTRIES,
        folding::ENTRIES,
        solids::ENTRIES,
        deforming::ENTRIES,
        intersecting::ENTRIES,
        differentiating::ENTRIES,
        relaxing::ENTRIES,
        geodesics::ENTRIES,
        planking::ENTRIES,
        harmony::ENTRIES,
        iterating::ENTRIES,
        transforming::ENTRIES,
        turning::ENTRIES,
        mirroring::ENTRIES,
        splining::ENTRIES,
        through_points::ENTRIES,
        knotting::ENTRIES,
        joining::ENTRIES,
        lengths::ENTRIES,
        combining::ENTRIES,
        spreading::ENTRIES,
        forms::ENTRIES,
        pieces::ENTRIES,
        &numbers,
        lists::ENTRIES,
        conditions::ENTRIES,
    ]
    .concat();
    all.sort_by_key(|operator| operator.group);
    all
}

/// What a routine answers.
type Outcome<S> = Result<Value<S>, Failure>;

const FORM: Parameter =
    Parameter::new(Takes::Form, words("form", "forme"), words("The form.", "La forme."));

const AXIS: Parameter = Parameter::new(
    Takes::Whole,
    words("axis", "axe"),
    words("The axis: 0 is u, 1 is v, 2 is w.", "L'axe : 0 est u, 1 est v, 2 est w."),
)
.range(0.0, 63.0);

const T: Parameter = Parameter::new(
    Takes::Number,
    words("t", "t"),
    words("The parameter; 0 to 1 is the usual window.", "Le paramètre ; de 0 à 1 d'ordinaire."),
)
.unit("parameter", "paramètre");

/// One entry of a record.
const PART: Parameter = Parameter::new(
    Takes::Text,
    words("part", "partie"),
    words("The name of one entry.", "Le nom d'une entrée."),
)
.or_absent("all of it", "le tout");

/// A text that chooses what an operator gives.
const fn part(default: &'static str, choices: &'static [Words]) -> Parameter {
    Parameter::new(
        Takes::Text,
        words("part", "partie"),
        words("What is wanted.", "Ce qui est demandé."),
    )
    .or(crate::Fallback::Text(default))
    .choices(choices)
}

/// What an entry is when it does not say otherwise.
const PLAIN: Operator = Operator {
    name: "",
    english: &[],
    french: &[],
    group: Group::Forms,
    summary: words("", ""),
    help: words("", ""),
    parameters: &[],
    gives: Takes::Form,
    example: "",
    source: "",
    see: &[],
    takes_errors: false,
    call: crate::operator::call!(floating nothing),
};

/// What an operator makes of the first argument: of a form a form, of a spline a spline.
fn of_either<S: Arithmetic>(
    a: &crate::Bound<S>,
    form: impl FnOnce(Form<S>) -> Result<Form<S>, Failure>,
    spline: impl FnOnce(&Spline<S>) -> Result<Spline<S>, Failure>,
) -> Outcome<S> {
    Ok(match a.shape(0)? {
        Shape::Form(whole) => form(whole)?.into(),
        Shape::Spline(pieces) => spline(&workable_spline(pieces)?)?.into(),
    })
}

fn nothing(_: &crate::Bound<f64>) -> Outcome<f64> {
    Ok(Value::Empty)
}

fn list_of_forms<S: Arithmetic>(forms: Vec<Form<S>>) -> Value<S> {
    Value::list(forms.into_iter().map(Value::Form).collect())
}

fn list_of_numbers<S: Arithmetic>(numbers: impl IntoIterator<Item = S>) -> Value<S> {
    Value::list(numbers.into_iter().map(Value::Number).collect())
}

fn number<S: Arithmetic>(count: usize) -> Value<S> {
    Value::Number(S::from_integer(count as i64))
}
