//! Random points of a form, spread evenly over it.

mod generator;
mod sampler;

use pforms_kernel::{Error, Result, limit};

use self::generator::Generator;
use self::sampler::Sampler;
use crate::{Poles, Shape};

/// How random points are spread.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Spread {
    /// Evenly by length, area or volume, however the form is parametrised.
    #[default]
    Uniform,
    /// Parameters normal about the middle of the window, a sixth of it the standard deviation, those
    /// outside it drawn again.
    Gaussian,
}

/// `count` random points of a form or spline: their coordinates, one point after the other.
///
/// The same seed gives the same points on every machine. The uniform law is exact up to the
/// rounding of a density: points are drawn by rejection below proved bounds of the element of
/// length, area or volume. Where a form covers a place twice, twice as many points come to lie.
///
/// Errors: `Shape` for a form without axes or with more axes than coordinates; `Domain` where it
/// goes to infinity; `Degenerate` for one without length, area or volume; `Limit`.
///
/// ```
/// use pforms_kernel::Form;
/// use pforms_operators::{Spread, random_points};
/// let line: Form = Form::from_points(&[3], 1, &[0., 0., 1.], None)?;
/// let points = random_points(&line.into(), 1000, Spread::Uniform, 1)?;
/// let mean = points.iter().sum::<f64>() / 1000.0;
/// assert!((mean - 0.5).abs() < 0.03);
/// # Ok::<(), pforms_kernel::Error>(())
/// ```
pub fn random_points(shape: &Shape, count: usize, law: Spread, seed: u64) -> Result<Vec<f64>> {
    let net = shape.net();
    if net.axes() == 0 {
        return Err(Error::shape("form", net.kind(), "a form with an axis"));
    }
    limit::check::<f64>("the cloud", &[count], net.ambient())?;
    let mut random = Generator::new(seed);
    let mut points = Vec::with_capacity(count * net.ambient());
    match law {
        Spread::Uniform => {
            let sampler = Sampler::new(shape)?;
            for _ in 0..count {
                points.extend(sampler.draw(&mut random)?);
            }
        }
        Spread::Gaussian => {
            let windows = match shape {
                Shape::Form(form) => vec![(0.0, 1.0); form.axes()],
                Shape::Spline(spline) => {
                    (0..net.axes()).map(|axis| spline.window(axis)).collect::<Result<Vec<_>>>()?
                }
            };
            for _ in 0..count {
                let place = |(from, to): &(f64, f64)| from + (to - from) * random.middling();
                let at: Vec<f64> = windows.iter().map(place).collect();
                points.extend(match shape {
                    Shape::Form(form) => form.at(&at)?,
                    Shape::Spline(spline) => spline.at(&at)?,
                });
            }
        }
    }
    Ok(points)
}
