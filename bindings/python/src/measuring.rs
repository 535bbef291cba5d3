//! Frames, normals and curvatures at broadcast parameters.

use numpy::PyArrayDyn;
use pforms_kernel::{Error, Form, Result};
use pforms_operators::{
    self as operators, Curvature, CurveFrame, FrameKind, Spline, SurfaceCurvature, SurfaceFrame,
    VolumeFrame,
};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arguments::{real, require_idle, truth, word};
use crate::columns::Columns;
use crate::errors::fail;
use crate::form::PyForm;
use crate::outputs::filled;
use crate::parameters::Parameters;
use crate::sampling::Grids;
use crate::slices::{SLICE, fill_scattered, in_slices, slice_of};

const KINDS: [&str; 3] = ["frenet", "rotation-minimising", "tangent"];

#[pymethods]
impl PyForm {
    /// Unit normals of a surface in space, along ``du × dv``.
    ///
    /// Where that product vanishes (collapsed edges) the normal is its limit in the window.
    ///
    /// Parameters
    /// ----------
    /// u, v : array_like
    ///     They broadcast; ``u[:, None]`` and ``v`` make a grid, which is quicker than scattered.
    /// out : ndarray, optional
    ///     A C-contiguous float64 array of the result's shape.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (…, 3)
    ///
    /// Raises
    /// ------
    /// ShapeError
    ///     Unless it is a surface in 3D.
    /// DegenerateError, DomainError
    ///     Where there is no normal; where the weight vanishes.
    ///
    /// Examples
    /// --------
    /// >>> floor = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    /// >>> floor.normals(0.5, [0, 1])
    /// array([[0., 0., 1.],
    ///        [0., 0., 1.]])
    #[pyo3(signature = (u, v, *, out=None))]
    fn normals<'py>(
        &self,
        u: &Bound<'py, PyAny>,
        v: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        normals(&self.form, u, v, out)
    }

    /// The moving frame at parameters: a :class:`Frame` of named arrays.
    ///
    /// A curve has ``point``, ``tangent``, ``normal``, ``binormal``, ``speed``, ``curvature`` and
    /// ``torsion``; a surface ``point``, ``tu``, ``tv``, ``normal``, ``area``, the fundamental forms
    /// ``first`` and ``second``, ``gauss``, ``mean`` and ``principal``; a volume ``point``, ``tu``,
    /// ``tv``, ``tw`` and ``jacobian``. What the dimension does not give is left out. Where a
    /// derivative vanishes the next one decides.
    ///
    /// Parameters
    /// ----------
    /// *parameters : array_like
    ///     One for each axis; they broadcast.
    /// kind : "frenet", "rotation-minimising" or "tangent", optional
    ///     The normal of a curve: towards the centre of curvature, or turning as little as
    ///     possible, or none.
    /// unit : bool, optional
    ///     Vectors of length 1; else the derivatives themselves and their products.
    /// accuracy : float, optional
    ///     Largest angle, in radians, by which a rotation-minimising normal may be off.
    ///
    /// Raises
    /// ------
    /// ShapeError, DomainError
    ///     For a point, a wrong count of parameters; where the weight vanishes.
    /// DegenerateError
    ///     Where there is no frame, as for the normal of a straight line.
    ///
    /// Examples
    /// --------
    /// >>> frame = pf.Form([(0, 0, 0), (1, 0, 0), (2, 2, 0)]).frame(0)
    /// >>> frame.normal, frame.binormal
    /// (array([0., 1., 0.]), array([0., 0., 1.]))
    #[pyo3(
        signature = (*parameters, kind=None, unit=None, accuracy=None),
        text_signature = "($self, *parameters, kind='frenet', unit=True, accuracy=1e-10)"
    )]
    fn frame<'py>(
        &self,
        parameters: &Bound<'py, PyTuple>,
        kind: Option<&Bound<'py, PyAny>>,
        unit: Option<&Bound<'py, PyAny>>,
        accuracy: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        frame(&self.form, parameters, kind, unit, accuracy)
    }

    /// The curvature: an array for a curve; ``gauss``, ``mean``, ``principal`` for a surface.
    ///
    /// Signed for a curve in the plane: positive where it turns left. A surface in 3D is answered
    /// by a :class:`Frame`, positive where it bends towards its normal.
    ///
    /// Raises ShapeError for other forms, DegenerateError where there is no curvature.
    ///
    /// >>> pf.Form([(0, 0), (1, 0), (2, 2)]).curvature(0).item()
    /// 1.0
    /// >>> saddle = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
    /// >>> saddle.curvature(0.5, 0.5).gauss.item()
    /// -4.0
    #[pyo3(signature = (*parameters))]
    fn curvature<'py>(&self, parameters: &Bound<'py, PyTuple>) -> PyResult<Bound<'py, PyAny>> {
        curvature(&self.form, parameters)
    }
}

/// The default of rotation-minimising frames: far below what can be seen, far above rounding.
const ACCURACY: f64 = 1e-10;

/// What has frames: a form, or a spline.
pub(crate) trait Bending: Sync {
    /// The poles, by which axes and cost are told.
    fn net(&self) -> &Form;

    fn curve_frames(&self, list: &[f64], kind: FrameKind, accuracy: f64)
    -> Result<Vec<CurveFrame>>;

    fn surface_frame(&self, u: f64, v: f64) -> Result<SurfaceFrame>;

    fn volume_frame(&self, at: &[f64]) -> Result<VolumeFrame>;

    fn curvature(&self, at: &[f64]) -> Result<Curvature>;

    fn normals_into(&self, lists: &[&[f64]], out: &mut [f64]) -> Result<()>;

    fn normal_grid_into(&self, lists: &[&[f64]], out: &mut [f64]) -> Result<()>;
}

impl Bending for Form {
    fn net(&self) -> &Form {
        self
    }

    fn curve_frames(
        &self,
        list: &[f64],
        kind: FrameKind,
        accuracy: f64,
    ) -> Result<Vec<CurveFrame>> {
        operators::curve_frames(self, list, kind, accuracy)
    }

    fn surface_frame(&self, u: f64, v: f64) -> Result<SurfaceFrame> {
        operators::surface_frame(self, u, v)
    }

    fn volume_frame(&self, at: &[f64]) -> Result<VolumeFrame> {
        operators::volume_frame(self, at)
    }

    fn curvature(&self, at: &[f64]) -> Result<Curvature> {
        operators::curvature(self, at)
    }

    fn normals_into(&self, lists: &[&[f64]], out: &mut [f64]) -> Result<()> {
        operators::normals_into(self, lists, out)
    }

    fn normal_grid_into(&self, lists: &[&[f64]], out: &mut [f64]) -> Result<()> {
        operators::normal_grid_into(self, lists, out)
    }
}

impl Bending for Spline {
    fn net(&self) -> &Form {
        Self::net(self)
    }

    fn curve_frames(
        &self,
        list: &[f64],
        kind: FrameKind,
        accuracy: f64,
    ) -> Result<Vec<CurveFrame>> {
        Self::curve_frames(self, list, kind, accuracy)
    }

    fn surface_frame(&self, u: f64, v: f64) -> Result<SurfaceFrame> {
        Self::surface_frame(self, u, v)
    }

    fn volume_frame(&self, at: &[f64]) -> Result<VolumeFrame> {
        Self::volume_frame(self, at)
    }

    fn curvature(&self, at: &[f64]) -> Result<Curvature> {
        Self::curvature(self, at)
    }

    fn normals_into(&self, lists: &[&[f64]], out: &mut [f64]) -> Result<()> {
        Self::normals_into(self, lists, out)
    }

    fn normal_grid_into(&self, lists: &[&[f64]], out: &mut [f64]) -> Result<()> {
        Self::normal_grid_into(self, lists, out)
    }
}

/// Unit normals of a surface at broadcast parameters.
pub(crate) fn normals<'py>(
    subject: &impl Bending,
    u: &Bound<'py, PyAny>,
    v: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let parameters = Parameters::read([u.clone(), v.clone()])?;
    let (py, cost) = (u.py(), 4 * subject.net().homogeneous().len());
    let shape = parameters.shape();
    if let Some(lists) = parameters.grid() {
        let lists: Vec<&[f64]> = lists.iter().map(AsRef::as_ref).collect();
        return filled(py, shape, Some(3), out, |normals| {
            Grids::new(&[subject.net()], &lists, normals)
                .fill(py, cost, &|part| subject.normal_grid_into(&part.lists, part.points))
        });
    }
    let points = parameters.scattered();
    filled(py, shape, Some(3), out, |normals| {
        fill_scattered(py, &points, cost, normals, &|lists: &[&[f64]], part: &mut [f64]| {
            subject.normals_into(lists, part)
        })
    })
}

/// The moving frame at broadcast parameters.
pub(crate) fn frame<'py>(
    subject: &impl Bending,
    parameters: &Bound<'py, PyTuple>,
    kind: Option<&Bound<'py, PyAny>>,
    unit: Option<&Bound<'py, PyAny>>,
    accuracy: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    if subject.net().axes() != 1 {
        require_idle("kind", kind, "only curves have normals of several kinds")?;
    }
    let kind = match kind.map(|kind| word("kind", kind, &KINDS)).transpose()? {
        Some("rotation-minimising") => FrameKind::RotationMinimising,
        Some("tangent") => FrameKind::Tangent,
        _ => FrameKind::Frenet,
    };
    let unit = unit.map_or(Ok(true), |unit| truth("unit", unit))?;
    let accuracy = accuracy.map_or(Ok(ACCURACY), |accuracy| real("accuracy", accuracy))?;
    if accuracy.is_nan() || accuracy <= 0.0 {
        return fail(&Error::domain("accuracy", accuracy, "a positive angle"));
    }
    let carried = kind == FrameKind::RotationMinimising && subject.net().axes() == 1;
    let question = Question { subject, kind, unit, accuracy };
    columns(subject.net(), parameters, carried, |lists, columns| question.answer(lists, columns))?
        .into_frame(parameters.py())
}

/// The curvature at broadcast parameters.
pub(crate) fn curvature<'py>(
    subject: &impl Bending,
    parameters: &Bound<'py, PyTuple>,
) -> PyResult<Bound<'py, PyAny>> {
    let columns = columns(subject.net(), parameters, false, |lists, columns| {
        for i in 0..lists.first().map_or(0, |list| list.len()) {
            let at: Vec<f64> = lists.iter().map(|list| list[i]).collect();
            match subject.curvature(&at)? {
                Curvature::Curve { curvature, .. } => columns.number("curvature", curvature),
                Curvature::Surface(curvature) => bends(&curvature, columns),
            }
        }
        Ok(())
    })?;
    if subject.net().axes() == 1 {
        return Ok(columns.into_numbers(parameters.py())?.into_any());
    }
    columns.into_frame(parameters.py())
}

/// Columns of numbers, filled slice after slice without the lock.
///
/// What is `carried` from one parameter to the next comes in slices that go all the way, each with
/// every n-th parameter.
fn columns(
    form: &Form,
    parameters: &Bound<'_, PyTuple>,
    carried: bool,
    mut fill: impl FnMut(&[&[f64]], &mut Columns) -> Result<()> + Send,
) -> PyResult<Columns> {
    let (py, read) = (parameters.py(), Parameters::read(parameters)?);
    if form.axes() == 0 {
        return fail(&Error::shape("form", "a point", "a form with at least one axis"));
    }
    // Without parameters, the names and widths are those somewhere.
    let (count, given) = (read.count().max(1), read.scattered().whole());
    let list = |list| if read.count() == 0 { &[SOMEWHERE][..] } else { list };
    let lists: Vec<&[f64]> = given.iter().map(|given| list(given)).collect();
    let cost = 100 * form.homogeneous().len();
    let stride = if carried { count.div_ceil(slice_of(cost).max(LONG)) } else { 1 };
    let (slices, cost) = if carried { (stride, SLICE) } else { (count, cost) };
    let mut columns = Columns::new(read.shape());
    in_slices(py, slices, cost, |range| {
        let chosen = if carried { range.start..count } else { range };
        let part = |list: &&[f64]| chosen.clone().step_by(stride).map(|i| list[i]).collect();
        let part: Vec<Vec<f64>> = lists.iter().map(part).collect();
        let part: Vec<&[f64]> = part.iter().map(Vec::as_slice).collect();
        form.require_per_axis("parameters", &part)?;
        fill(&part, &mut columns)
    })?;
    if stride > 1 {
        columns.rearrange(&strided(count, stride));
    }
    if read.count() == 0 {
        columns.clear();
    }
    Ok(columns)
}

/// Parameters that are worth going all the way for.
const LONG: usize = 1 << 12;

/// A parameter like any other.
const SOMEWHERE: f64 = 0.381_966;

/// The numbers below `count`: every `stride`-th from 0, then from 1, and so on.
fn strided(count: usize, stride: usize) -> Vec<usize> {
    (0..stride).flat_map(|start| (start..count).step_by(stride)).collect()
}

/// What is asked about a frame.
struct Question<'a, B> {
    subject: &'a B,
    kind: FrameKind,
    unit: bool,
    accuracy: f64,
}

impl<B: Bending> Question<'_, B> {
    fn answer(&self, lists: &[&[f64]], columns: &mut Columns) -> Result<()> {
        match *lists {
            [list] => self.curve(list, columns),
            [us, vs] => us.iter().zip(vs).try_for_each(|(u, v)| {
                let frame = self.subject.surface_frame(*u, *v)?;
                surface(&if self.unit { frame } else { frame.unnormalised() }, columns);
                Ok(())
            }),
            _ => (0..lists[0].len()).try_for_each(|i| {
                let at: Vec<f64> = lists.iter().map(|list| list[i]).collect();
                let frame = self.subject.volume_frame(&at)?;
                volume(&if self.unit { frame } else { frame.unnormalised() }, columns);
                Ok(())
            }),
        }
    }

    fn curve(&self, list: &[f64], columns: &mut Columns) -> Result<()> {
        for frame in self.subject.curve_frames(list, self.kind, self.accuracy)? {
            let frame = if self.unit { frame } else { frame.unnormalised(self.kind) };
            let CurveFrame { point, tangent, normal, binormal, speed, curvature, torsion, .. } =
                frame;
            columns.vector("point", &point);
            columns.vector("tangent", &tangent);
            columns.maybe_vector("normal", normal.as_deref());
            columns.maybe_vector("binormal", binormal.as_deref());
            columns.number("speed", speed);
            columns.number("curvature", curvature);
            columns.maybe_number("torsion", torsion);
        }
        Ok(())
    }
}

fn surface(frame: &SurfaceFrame, columns: &mut Columns) {
    columns.vector("point", &frame.point);
    columns.vector("tu", &frame.tangents[0]);
    columns.vector("tv", &frame.tangents[1]);
    columns.maybe_vector("normal", frame.normal.as_deref());
    columns.number("area", frame.area);
    columns.vector("first", &frame.first);
    columns.maybe_vector("second", frame.second.as_ref().map(<[f64; 3]>::as_slice));
    if let Some(curvature) = &frame.curvature {
        bends(curvature, columns);
    }
}

fn volume(frame: &VolumeFrame, columns: &mut Columns) {
    const NAMES: [&str; 3] = ["tu", "tv", "tw"];
    columns.vector("point", &frame.point);
    if frame.tangents.len() == NAMES.len() {
        for (name, tangent) in NAMES.into_iter().zip(&frame.tangents) {
            columns.vector(name, tangent);
        }
    }
    columns.vector("tangents", &frame.tangents.concat());
    columns.maybe_number("jacobian", frame.jacobian);
}

fn bends(curvature: &SurfaceCurvature, columns: &mut Columns) {
    columns.number("gauss", curvature.gauss);
    columns.number("mean", curvature.mean);
    columns.vector("principal", &curvature.principal);
}
