//! Matrices that move a section along.

use pforms_kernel::{Form, Rational};
use pforms_operators::{self as operators, Poles, Shape};

use super::{Outcome, PLAIN};
use crate::cost::{multipliable, require_sweepable};
use crate::operator::{Group, call};
use crate::words::words;
use crate::{Arithmetic, Bound, Operator, Parameter, Takes};

const COMPOSED: Operator = Operator { group: Group::Composed, ..PLAIN };

pub(super) static ENTRIES: &[Operator] = &[
    Operator {
        name: "affine_sweep",
        english: &["SWEEP"],
        french: &["AFFINE"],
        summary: words(
            "What a form of matrices makes of a section: exact.",
            "Ce qu'une forme de matrices fait d'une section : exact.",
        ),
        help: words(
            "Axes of the matrices first, then the section's. A matrix is a pole: its entries row by row, \
             the weight last; MATRIX makes one from its columns. It commutes with MIR and MI on either \
             side. 4 x 4 matrices move forms of space (dimension 15), 4 x 3 matrices carry plane ones into \
             space (dimension 11).",
            "D'abord les axes des matrices, puis ceux de la section. Une matrice est un pôle : ses \
             coefficients ligne par ligne, le poids en dernier ; MATRICE en fait une de ses colonnes. Il \
             commute avec MIR et MI des deux côtés. Les matrices 4 x 4 déplacent des formes de l'espace \
             (dimension 15), les matrices 4 x 3 portent des formes planes dans l'espace (dimension 11).",
        ),
        parameters: &[
            Parameter::new(
                Takes::Form,
                words("matrix", "matrice"),
                words("The form of matrices.", "La forme de matrices."),
            ),
            Parameter::new(
                Takes::Form,
                words("section", "section"),
                words("What they are applied to.", "Ce à quoi on les applique."),
            ),
        ],
        example: "=SWEEP(MATRIX((1, 0, 0), (0, 1, 0), [(0, 0, 0), (1, 0, 2)]), [(0, 0), (1, 1), (2, 0)])",
        source: "book 324",
        see: &["affine_matrix", "stack"],
        call: call!(affine_sweep),
        ..COMPOSED
    },
    Operator {
        name: "affine_matrix",
        english: &["MATRIX"],
        french: &["MATRICE"],
        summary: words(
            "The form of matrices whose columns are vectors and an origin.",
            "La forme de matrices dont les colonnes sont des vecteurs et une origine.",
        ),
        help: words(
            "Swept over (s, t, ...), it gives origin + s·first + t·second + ... The columns are forms: \
             unnormalised frames from NORMAL, BINORMAL and TANGENT make sweeps without a \
             root. A point is the same everywhere; rational columns are brought to one weight.",
            "Balayée sur (s, t, ...), elle donne origine + s·première + t·deuxième + ... Les colonnes sont \
             des formes : les repères non normés de NORMALE, BINORMALE et TANGENTE font \
             des balayages sans racine. Un point est partout le même ; les colonnes rationnelles sont \
             mises au même poids.",
        ),
        parameters: &[Parameter::new(
            Takes::Form,
            words("columns", "colonnes"),
            words("The vectors, and the origin last.", "Les vecteurs, et l'origine en dernier."),
        )
        .variadic()],
        example: "=MATRIX((1, 0), (0, 1), [(0, 0), (1, 2)])",
        source: "book 324, 326",
        see: &["affine_sweep", "tangent_form", "normal_form"],
        call: call!(affine_matrix),
        ..COMPOSED
    },
];

fn affine_sweep<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let (matrix, section) = (a.shape(0)?, a.shape(1)?);
    require_sweepable(matrix.net(), section.net())?;
    Ok(match (matrix, section) {
        (Shape::Form(matrix), Shape::Form(section)) => {
            operators::affine_sweep(&matrix, &section)?.into()
        }
        (matrix, section) => {
            operators::affine_sweep_spline(&matrix.into_spline(), &section.into_spline())?.into()
        }
    })
}

fn affine_matrix<S: Arithmetic>(a: &Bound<S>) -> Outcome<S> {
    let columns: Vec<Form<S>> =
        a.forms(0)?.into_iter().map(multipliable).collect::<Result<_, _>>()?;
    Ok(operators::affine_matrix(&columns.iter().collect::<Vec<_>>())?.into())
}
