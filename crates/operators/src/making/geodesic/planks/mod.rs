//! Thin straight boards laid on a surface along its geodesics (book, section 36).
//!
//! A board bends and does not stretch, so it lies as a developable strip: the one that touches the surface all along
//! the line, whose rulings are conjugate to the line (`rulings`). Unrolled, a geodesic is straight; so are the edges
//! of the strip, and the ends, cut along rulings (`board`). A line is followed by its length (`axis`), with the
//! frame of Darboux at each place (`spot`). Where boards cross they are marked (`marks`).

mod axis;
mod board;
mod cut;
mod fall;
mod lift;
mod marks;
mod nodes;
mod rulings;
mod spot;

use pforms_kernel::{Error, Form, Result};

use super::atlas::Atlas;
use crate::{Shape, Spline};
use axis::Axis;
use board::Board;
use nodes::Rule;

/// How planks are to be laid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlankOptions {
    /// Error of the strips, in sizes of the surface; lines count as straight that are so to within it.
    pub accuracy: f64,
    /// Are the crossings wanted?
    pub marks: bool,
}

impl Default for PlankOptions {
    /// An accuracy of 10⁻⁸, with marks.
    fn default() -> Self {
        Self { accuracy: 1e-8, marks: true }
    }
}

/// A thin straight board on a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Plank {
    /// The board in space: along it by the length of its axis, across it from 0 on the right to 1 on the left.
    pub strip: Spline,
    /// Its axis in space, by its length.
    pub line: Spline,
    /// Its axis laid flat: from the origin along x.
    pub axis: Form,
    /// Its outline laid flat: a closed line round the four corners, from the right one at the beginning.
    pub outline: Spline,
    /// How long its axis is.
    pub length: f64,
    /// Where other planks cross it, in the order of the distance.
    pub marks: Vec<Mark>,
    /// Is it sure that no other crossing is missing?
    pub complete: bool,
    /// Other planks that lie along a part of the same line.
    pub overlaps: Vec<usize>,
    /// The largest curvature it is bent to, one over the least radius, at places along its pieces.
    pub bend: f64,
    /// The largest geodesic torsion of its axis, in radians for each length: how much its normal turns.
    pub twist: f64,
    /// The largest angle between a ruling and the square across the board.
    pub slant: f64,
    /// How much its edges are stretched, as a share of their length: 0 but on a straight line of a surface that
    /// twists about it, where no developable strip lies.
    pub strain: f64,
    /// How far an edge stands off the surface, at most, measured at places along it.
    pub lift: f64,
    /// How far an edge goes beyond the border of the surface, at most, measured at the same places.
    pub overhang: f64,
    /// The width at which its rulings begin to cross; none where they never do.
    pub widest: Option<f64>,
    /// How far the strip is from the true one, and its axis laid flat from straight: the sum of what was measured
    /// between the nodes of the polynomials.
    pub error: f64,
}

/// A place where another plank crosses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Which of the lines it is that of.
    pub other: usize,
    /// The distance along the axis.
    pub at: f64,
    /// The distance along that of the other.
    pub other_at: f64,
    /// From this axis to that of the other, counterclockwise seen from the side of the normal, between −π and π.
    pub angle: f64,
    /// By how much the distance may be off, for the lines given.
    pub error: f64,
}

/// Boards of a width along lines of a surface, which are given in its parameters.
///
/// The lines are geodesics: the `parameters` of [`super::geodesic`], or straight ones known otherwise, such as
/// meridians. The strip of each touches the surface along its line, is developable to within the error, and laid
/// flat a board with two parallel straight edges and ends cut along rulings. It may hang over the border.
///
/// A straight line of the surface about which the tangent plane turns, a generator of a hyperboloid, has no such
/// strip: there the board is square across the line and twisted, and `strain` is how much its edges are stretched.
///
/// Errors: `Shape` unless the surface is one in space and the lines are curves in the plane of its parameters;
/// `Domain` without lines, for lines that leave the window, that have gaps, or are not straight on the surface to
/// within the accuracy, and for a width that is not above 0 or beyond a million sizes of the surface; `Degenerate`
/// for lines without length, where the surface has a kink or its curvature jumps, where a line goes
/// in an asymptotic direction, and for a width at which rulings cross (it says which would do); `Accuracy` when
/// the one asked for takes too many pieces; `Limit` for too many lines.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{PlankOptions, Spline, cylinder, Part, planks};
/// // Round a cylinder of radius 2 and square to its axis: the plank lies on it.
/// let surface = cylinder(&2.0, &1.0, Part::Quarter)?.into_spline();
/// let [u, v] = [0, 1].map(|axis| surface.window(axis));
/// let ((a, b), (c, d)) = (u?, v?);
/// let round = Form::from_points(&[2], 2, &[0.5 * (a + b), c, 0.5 * (a + b), d], None)?;
/// let boards = planks(surface, &[round.into()], 0.25, &PlankOptions::default())?;
/// assert!((boards[0].length - std::f64::consts::PI).abs() < 1e-9 && boards[0].lift < 1e-8);
/// assert!((boards[0].bend - 0.5).abs() < 1e-9);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn planks(
    surface: impl Into<Spline>,
    lines: &[Spline],
    width: f64,
    options: &PlankOptions,
) -> Result<Vec<Plank>> {
    let surface = surface.into();
    checked(&surface, lines, width, options)?;
    let atlas = Atlas::new(&surface, true)?;
    let half = atlas.in_units(width) / 2.0;
    if !(NARROWEST..=WIDEST).contains(&half) {
        let expected = format!(
            "a width between {:e} and {:e}",
            atlas.length(2.0 * NARROWEST),
            atlas.length(2.0 * WIDEST)
        );
        return Err(Error::domain("width", width, expected));
    }
    let rule = Rule::new()?;
    let axes: Vec<Axis> =
        lines.iter().map(|line| Axis::new(&atlas, &rule, line)).collect::<Result<_>>()?;
    let mut boards = Vec::with_capacity(axes.len());
    for (number, axis) in axes.iter().enumerate() {
        boards.push(Board::new(axis, &rule, half, options.accuracy, number)?);
    }
    let mut planks: Vec<Plank> =
        boards.iter().map(|board| board.plank(&atlas)).collect::<Result<_>>()?;
    lift::measured(&surface, &atlas, &boards, &mut planks)?;
    if options.marks {
        marks::marked(&atlas, lines, &boards, &mut planks)?;
    }
    Ok(planks)
}

/// The lines of a shape: the rows of a net of points in the plane, which is a list of lines; itself otherwise.
///
/// Errors: `Domain` for a row without a weight.
pub fn plank_lines(shape: Shape) -> Result<(Vec<Spline>, bool)> {
    match shape {
        Shape::Form(net) if net.axes() == 2 && net.ambient() == 2 => {
            let row = net.orders()[1];
            let rows = net.homogeneous().chunks_exact(3 * row);
            let line = |poles: &[f64]| Form::from_homogeneous(&[row], 2, poles.to_vec());
            Ok((rows.map(|poles| Ok(line(poles)?.into())).collect::<Result<_>>()?, true))
        }
        other => Ok((vec![other.into_spline()], false)),
    }
}

/// Half widths in sizes of the surface: narrower ones are lost in rounding, wider ones lie nowhere near it.
const NARROWEST: f64 = 1e-9;
const WIDEST: f64 = 1e6;

/// Lines of one call at most, and of one in which each is compared with every other.
const MOST: usize = 1 << 14;
const MOST_MARKED: usize = 1 << 10;

fn checked(surface: &Spline, lines: &[Spline], width: f64, options: &PlankOptions) -> Result<()> {
    if surface.axes() != 2 || surface.ambient() != 3 {
        return Err(Error::shape(
            "surface",
            format!("a form of {} axes in dimension {}", surface.axes(), surface.ambient()),
            "a surface in dimension 3",
        ));
    }
    if lines.is_empty() {
        return Err(Error::domain("lines", "none", "a line or more"));
    }
    let most = if options.marks { MOST_MARKED } else { MOST };
    if lines.len() > most {
        return Err(Error::Limit {
            what: format!(
                "planks along {} lines, of which each may cross every other",
                lines.len()
            ),
            bytes: lines.len() as u128 * lines.len() as u128 * size_of::<Mark>() as u128,
            cap: (most * most * size_of::<Mark>()) as u128,
        });
    }
    if !(width > 0.0 && width.is_finite()) {
        return Err(Error::domain("width", width, "a number above 0"));
    }
    if !(options.accuracy > 0.0 && options.accuracy < 1.0) {
        return Err(Error::domain("accuracy", options.accuracy, "a number between 0 and 1"));
    }
    Ok(())
}
