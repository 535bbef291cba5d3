//! Tubes: a section carried along a path by a frame that stays at right angles to it.
//!
//! `tube(u, v) = path(u) + r(u)·(N(u)·x(v) + B(u)·y(v) + T(u)·z(v))` (book 323). Lengths of vectors
//! are roots, so a tube is no form in general; here its frame is replaced by polynomials as near to
//! it as is asked, with a bound on what is left over that is proved from their coefficients.

mod circle;
mod frames;
mod law;
mod matrix;
mod path;
mod poly;
mod section;
mod shaped;
mod turning;
mod unit;
mod vector;

use pforms_kernel::{Error, Form, Result};

pub use law::Law;

use crate::measuring::vector::{dot, norm, plus};
use crate::{FrameKind, Spline, affine_sweep_spline};
use frames::{Frame, Wish, frenet, minimising};
use matrix::matrices;
use path::{gap, in_space, parts};
use section::Section;
use shaped::{Laws, Shaped};
use turning::Turning;
use vector::Vector;

/// What a tube is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct PipeOptions {
    /// Frenet, or rotation-minimising from the principal normal at the beginning.
    pub frame: FrameKind,
    /// Factor of the section, at least 0 everywhere.
    pub radius: Law,
    /// Angle by which the section is turned about the tangent, from the normal to the binormal, in
    /// radians.
    pub twist: Law,
    /// Largest distance between the true tube and the result at the same parameters; if absent, a
    /// millionth of the largest radius times the reach of the section.
    pub tolerance: Option<f64>,
    /// Does the path close on itself, so that rotation-minimising frames are turned to close too?
    /// If absent, when its ends and their tangents agree.
    pub closed: Option<bool>,
}

impl Default for PipeOptions {
    /// Rotation-minimising, radius 1, no twist.
    fn default() -> Self {
        Self {
            frame: FrameKind::RotationMinimising,
            radius: Law::Constant(1.0),
            twist: Law::Constant(0.0),
            tolerance: None,
            closed: None,
        }
    }
}

/// A tube and how near it comes to the true one.
#[derive(Clone, Debug, PartialEq)]
pub struct Pipe {
    /// The tube: the path's parameter first, then those of the section.
    pub spline: Spline,
    /// No point of it is further from the point of the true tube at the same parameters: proved,
    /// with room for rounding.
    pub error: f64,
    /// The largest product of the path's curvature and the distance at which a point of the tube
    /// lies on the inside of the bend, at samples: from 1 on the tube runs back into itself.
    pub bending: f64,
    /// The angle, in radians, by which a rotation-minimising frame was turned back evenly along a
    /// closed path, so that the end meets the beginning; 0 for others.
    pub closing: f64,
}

/// The tube that a section describes along a path.
///
/// The path is a curve in space, or in the plane `z = 0`. Coordinate x of the section goes along
/// the normal, y along the binormal and, in three dimensions, z along the tangent; the section may
/// have any axes. The spline keeps the path's parameters and the section's own knots; in the
/// direction of the section, and at its centre line, it is exact. Only the frame is approximated, by
/// polynomials of degree 5 that are cut until the tolerance is met: the degree along the path is the
/// larger of 5 and that of a polynomial path, 5 more than that of a rational one. Straight paths of
/// constant radius are exact. The pieces meet as smoothly as degree 5 allows: tangent planes and
/// curvatures agree.
///
/// Rotation-minimising frames pass through inflections and straight stretches without turning over.
/// The Frenet frame cannot: there it is refused. A tube whose radius exceeds the radius of curvature
/// is made, and said to bend too much by [`Pipe::bending`].
///
/// Errors: `Shape` for a path, section or law of the wrong kind; `Domain` for a radius below 0
/// (wherever it is), numbers that are not finite, weights that vanish and a tolerance not above 0;
/// `Degenerate` for a path that stands still, has a cusp, a corner or a gap, for the Frenet frame
/// where there is none, for a section in a plane along the path, and when an open path is said to
/// be closed; `Accuracy` when the tolerance is out of reach; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{PipeOptions, pipe};
/// // An S whose principal normal changes sides half-way, and a whole circle about it.
/// let path: Form = Form::from_points(&[4], 3, &[0., 0., 0., 2., 0., 0., 1., 2., 1., 3., 2., 1.], None)?;
/// let circle = Form::from_points(
///     &[5], 2, &[-1., 0., 0., -1., 3., 0., 0., 1., -1., 0.], Some(&[1., 0., 1. / 3., 0., 1.]),
/// )?;
/// let options = PipeOptions { radius: 0.1.into(), ..PipeOptions::default() };
/// let tube = pipe(&path.into(), &circle.into(), &options)?;
/// assert!(tube.error < 1e-7 && tube.bending < 1.0);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn pipe(path: &Spline, section: &Spline, options: &PipeOptions) -> Result<Pipe> {
    let path = in_space(path)?;
    options.radius.check("radius")?;
    options.radius.require_positive("radius")?;
    options.twist.check("twist")?;
    check_tolerance(options.tolerance)?;
    let (unit, width) = (unit_of(path.net()), unit_of(section.net()));
    let options = PipeOptions {
        radius: options.radius.scaled(width / unit)?,
        tolerance: options.tolerance.map(|tolerance| tolerance / unit),
        ..options.clone()
    };
    let tube = made(&scaled(&path, 1.0 / unit)?, &scaled(section, 1.0 / width)?, &options, unit)?;
    Ok(Pipe { spline: scaled(&tube.spline, unit)?, error: tube.error * unit, ..tube })
}

/// A power of two about as large as the coordinates: in this unit squares neither vanish nor
/// overflow.
fn unit_of(net: &Form) -> f64 {
    let (mut size, mut heaviest) = (0.0_f64, 0.0_f64);
    for pole in net.homogeneous().chunks_exact(net.width()) {
        size = pole[..net.ambient()].iter().fold(size, |most, x| most.max(x.abs()));
        heaviest = heaviest.max(pole[net.ambient()].abs());
    }
    let size = size / heaviest;
    if size > 0.0 && size.is_finite() {
        libm::ldexp(1.0, libm::ilogb(size).clamp(-1000, 1000))
    } else {
        1.0
    }
}

/// The spline with its coordinates multiplied.
fn scaled(spline: &Spline, factor: f64) -> Result<Spline> {
    let net = spline.net();
    let mut poles = net.homogeneous().to_vec();
    for pole in poles.chunks_exact_mut(net.width()) {
        pole[..net.ambient()].iter_mut().for_each(|x| *x *= factor);
    }
    Spline::on(Form::from_homogeneous(net.orders(), net.ambient(), poles)?, spline.knots().to_vec())
}

/// The tube of a path and a section of about size 1, in a unit that only errors name.
fn made(path: &Spline, section: &Spline, options: &PipeOptions, unit: f64) -> Result<Pipe> {
    let section = Section::new(section)?;
    let reach = section.reach * options.radius.most()?;
    let tolerance = options.tolerance.unwrap_or(if reach > 0.0 { reach * 1e-6 } else { 1.0 });
    let mut cuts = [options.radius.breaks(), options.twist.breaks()].concat();
    cuts.sort_by(f64::total_cmp);
    let parts = parts(path, &cuts)?;
    // As much for the frame as for its radius and twist, the rest for rounding and the seam; three
    // vectors' errors may add up, and a twist mixes two.
    let share = 0.4 * tolerance / 3_f64.sqrt();
    let wish = Wish {
        error: (share / std::f64::consts::SQRT_2 / reach).min(1.0) * 0.99,
        tangent: section.is_solid(),
    };
    let frames = match options.frame {
        FrameKind::RotationMinimising => minimising(parts, wish)?,
        FrameKind::Frenet => frenet(parts, wish)?,
        FrameKind::Tangent => {
            let expected = "frenet or rotation-minimising";
            return Err(Error::domain("frame", "the tangent alone", expected));
        }
    };
    let closed = is_closed(&frames, options.closed)?;
    let closing = match options.frame {
        FrameKind::RotationMinimising if closed => excess(&frames),
        _ => 0.0,
    };
    let laws =
        Laws { radius: &options.radius, twist: &options.twist, closing, window: path.window(0)? };
    let room = if section.reach > 0.0 { share / section.reach } else { f64::INFINITY };
    let shaped = laws.shape(frames, room)?;
    let seam = seam(&shaped, &section);
    let whole = closed && seam <= (tolerance / 8.0).min(SEAM * reach);
    let matrix = matrices(&shaped, path.net().is_rational(), whole)?;
    let spline = affine_sweep_spline(&matrix, section.spline)?;
    let error = error(&shaped, &section) + if whole { seam } else { 0.0 };
    if error > tolerance && reach > 0.0 {
        let least = format!("{:e} at least", error * unit);
        return Err(Error::accuracy("tolerance", tolerance * unit, least));
    }
    Ok(Pipe { spline, error, bending: bending(&shaped, &section), closing })
}

fn check_tolerance(given: Option<f64>) -> Result<()> {
    match given {
        Some(tolerance) if !(tolerance.is_finite() && tolerance > 0.0) => {
            Err(Error::domain("tolerance", tolerance, "a distance above 0"))
        }
        _ => Ok(()),
    }
}

/// Do the ends of the path agree, with their tangents? Points to a billionth of its extent.
fn is_closed(frames: &[Frame], wanted: Option<bool>) -> Result<bool> {
    let (Some(first), Some(last)) = (frames.first(), frames.last()) else {
        return Ok(false);
    };
    if wanted == Some(false) {
        return Ok(false);
    }
    let start = first.part.point(0.0);
    let extent = frames
        .iter()
        .map(|frame| norm(&plus(&frame.part.point(0.5), -1.0, &start)))
        .fold(0.0, f64::max);
    let gap = gap(&last.part, &first.part);
    let [departs, arrives] =
        [first.part.direction.first(), last.part.direction.last()].map(|d| d.map(|x| x / norm(&d)));
    let corner = norm(&plus(&departs, -1.0, &arrives));
    let closed = gap <= 1e-9 * extent && corner <= 1e-6;
    if wanted == Some(true) && !closed {
        let received = format!("ends {gap:e} of its size apart, tangents {corner:e} apart");
        return Err(Error::degenerate("path", received, "a closed path, as closed says"));
    }
    Ok(closed)
}

/// The angle by which the frame at the end is ahead of that at the beginning.
fn excess(frames: &[Frame]) -> f64 {
    let (Some(first), Some(last)) = (frames.first(), frames.last()) else { return 0.0 };
    let (start, end) = ([0, 1].map(|k| first.vectors[k].first()), last.vectors[0].last());
    libm::atan2(dot(&end, &start[1]), dot(&end, &start[0]))
}

/// What the columns are off, at the reach of the section, and room for rounding.
fn error(shaped: &[Shaped], section: &Section) -> f64 {
    let mut worst = 0.0_f64;
    let mut size = 0.0_f64;
    for part in shaped {
        let count = part.columns.len() as f64;
        worst = worst.max(count.sqrt() * section.reach * part.error);
        let reach = part.columns.iter().map(Vector::most).fold(0.0, f64::max);
        size = size.max(norm(&part.part.point(0.0)) + section.reach * reach);
    }
    let gaps = shaped.windows(2).map(|pair| gap(&pair[0].part, &pair[1].part));
    worst + gaps.fold(0.0, f64::max) + 64.0 * f64::EPSILON * size
}

/// A tube whose ends differ by a larger share of its reach is left open.
const SEAM: f64 = 1e-8;

/// By how much the end of a closed tube is moved to meet the beginning.
fn seam(shaped: &[Shaped], section: &Section) -> f64 {
    let (Some(first), Some(last)) = (shaped.first(), shaped.last()) else { return 0.0 };
    let apart = |a: [f64; 3], b: [f64; 3]| norm(&plus(&a, -1.0, &b));
    let columns = first.columns.iter().zip(&last.columns);
    let turned: f64 = columns.map(|(a, b)| apart(a.first(), b.last())).sum();
    gap(&last.part, &first.part) + section.reach * turned
}

/// Parameters of each piece at which bending is measured.
const STATIONS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Curvature times the offset towards its centre, at its largest among samples.
fn bending(shaped: &[Shaped], section: &Section) -> f64 {
    let mut most = 0.0_f64;
    for part in shaped {
        let Some(turning) = Turning::of(&part.part.direction) else { continue };
        for t in STATIONS {
            let speed = part.part.speed(t);
            let bend = turning.bend(t).map(|x| x / speed);
            let [normal, binormal] = [0, 1].map(|k| dot(&part.columns[k].at(t), &bend));
            let inside = section.samples.iter().map(|s| s[0] * normal + s[1] * binormal);
            most = inside.filter(|x| x.is_finite()).fold(most, f64::max);
        }
    }
    most
}
