//! The class `Sheet`: cells that recalculate, in floating or in exact arithmetic.

use std::sync::{Mutex, MutexGuard, PoisonError};

use numpy::PyArray1;
use pforms_catalogue::Value;
use pforms_kernel::{Error, Rational, Result, Sparse};
use pforms_scene::Scene;
use pforms_sheet::{Address, Document, Sensitivities, Sheet, Target, pfs};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList, PyString, PyType};

use crate::arrays::Numbers;
use crate::drawing::{picture, scene_of};
use crate::errors::{done, mistyped, raised};
use crate::form::PyForm;
use crate::values::{Shown, literal, shown};

/// Cells that recalculate: the text of a ``.pfs`` file, computed.
///
/// ``sheet["A4"]`` is the value of a cell, of a range as nested lists, or of a name: a number, a
/// text, a :class:`Form`, a list, a dict for a record, or None for an empty cell. A cell whose
/// value is an error raises it; the message names the cell where it began. Setting a cell takes a
/// text as typed (a formula begins with ``=``), a number or a form, and recalculates.
///
/// Parameters
/// ----------
/// text : str, optional
///     The text of a ``.pfs`` file; an empty sheet without.
/// exact : bool, optional
///     Compute with fractions: numbers are then ``fractions.Fraction``, and forms object arrays of
///     homogeneous poles.
///
/// Raises
/// ------
/// FormatError
///     For a damaged text, with line and column; for an address that is none.
///
/// Examples
/// --------
/// >>> sheet = pf.Sheet()
/// >>> sheet["A1"] = "[(0, 0), (1, 2), (2, 0)]"
/// >>> sheet["A2"] = "=POINT(A1, 1/2)"
/// >>> sheet["A2"].poles
/// array([1., 1.])
/// >>> sheet["A1"] = pf.Form([(0, 0), (1, 4), (2, 0)])
/// >>> sheet["A2"].poles
/// array([1., 2.])
#[pyclass(frozen, module = "pforms", name = "Sheet", weakref)]
pub(crate) struct PySheet {
    cells: Mutex<Cells>,
}

enum Cells {
    Floating(Sheet),
    Exact(Sheet<Rational>),
}

/// The same for a sheet of either arithmetic.
macro_rules! either {
    ($cells:expr, $sheet:ident => $answer:expr) => {
        match $cells {
            Cells::Floating($sheet) => $answer,
            Cells::Exact($sheet) => $answer,
        }
    };
}

impl Cells {
    fn of(document: Document, exact: bool) -> Self {
        let mut cells = match exact {
            true => Self::Exact(Sheet::from(document)),
            false => Self::Floating(Sheet::from(document)),
        };
        either!(&mut cells, sheet => drop(sheet.recalculate_all()));
        cells
    }

    fn document(&self) -> &Document {
        either!(self, sheet => sheet.document())
    }

    /// The cell an address or a name stands for.
    fn cell(&self, place: &str) -> Result<Address> {
        match either!(self, sheet => sheet.locate(place))? {
            Target::Cell(at) => Ok(at),
            Target::Cells(range) => {
                Err(Error::format("sheet", None, format!("{range} is not a single cell")))
            }
        }
    }

    fn set(&mut self, place: &str, text: &str) -> Result<()> {
        let at = self.cell(place)?;
        either!(self, sheet => {
            sheet.set(at, text);
            sheet.recalculate_all();
        });
        Ok(())
    }
}

#[pymethods]
impl PySheet {
    #[new]
    #[pyo3(signature = (text="", *, exact=false))]
    fn new(py: Python<'_>, text: &str, exact: bool) -> PyResult<Self> {
        let read = || match text.is_empty() {
            true => Ok(Document::default()),
            false => pfs::read(text),
        };
        Self::computed(py, exact, read)
    }

    /// Reads and computes a ``.pfs`` file.
    ///
    /// Raises FormatError with line and column when it is damaged, OSError when it cannot be read.
    ///
    /// >>> pf.Sheet("pfs = 1\n").save("empty.pfs")
    /// >>> list(pf.Sheet.load("empty.pfs"))
    /// []
    #[classmethod]
    #[pyo3(signature = (path, *, exact=false))]
    fn load(class: &Bound<'_, PyType>, path: &Bound<'_, PyAny>, exact: bool) -> PyResult<Self> {
        let bytes = crate::files::read(path)?;
        Self::computed(class.py(), exact, || pfs::read_bytes(&bytes))
    }

    /// Writes the sheet as a ``.pfs`` file. Raises OSError when that fails.
    ///
    /// >>> pf.Sheet().save("empty.pfs")
    fn save(&self, path: &Bound<'_, PyAny>) -> PyResult<()> {
        let text = self.__str__(path.py())?;
        crate::files::write(path, text.as_bytes())
    }

    /// Does it compute with fractions?
    ///
    /// >>> sheet = pf.Sheet(exact=True)
    /// >>> sheet["A1"] = "=1/3 + 1/6"
    /// >>> sheet.exact, sheet["A1"]
    /// (True, Fraction(1, 2))
    #[getter]
    fn exact(&self, py: Python<'_>) -> bool {
        matches!(*self.locked(py), Cells::Exact(_))
    }

    /// The cells that are not empty: a dict of addresses and their texts as typed.
    ///
    /// >>> sheet = pf.Sheet()
    /// >>> sheet["B1"] = "=1/4"
    /// >>> sheet.cells()
    /// {'B1': '=1/4'}
    fn cells<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let cells = PyDict::new(py);
        for (at, text) in self.locked(py).document().cells() {
            cells.set_item(at.to_string(), text)?;
        }
        Ok(cells)
    }

    /// The names: a dict of what each stands for. Change them with :meth:`set_name`.
    ///
    /// >>> sheet = pf.Sheet()
    /// >>> sheet.set_name("ball", "A4")
    /// >>> sheet.names
    /// {'ball': 'A4'}
    #[getter]
    fn names<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let names = PyDict::new(py);
        for (name, target) in self.locked(py).document().names() {
            names.set_item(name, target.to_string())?;
        }
        Ok(names)
    }

    /// Gives a name to a cell or a range; an empty target takes the name away.
    ///
    /// Raises FormatError for a name no formula could use, or a target that is no place.
    ///
    /// >>> sheet = pf.Sheet()
    /// >>> sheet["A1"] = 7
    /// >>> sheet.set_name("seven", "A1")
    /// >>> sheet["seven"]
    /// 7.0
    fn set_name(&self, py: Python<'_>, name: &str, target: &str) -> PyResult<()> {
        self.changed(py, |cells| {
            either!(cells, sheet => {
                sheet.set_name(name, target)?;
                sheet.recalculate_all();
            });
            Ok(())
        })
    }

    /// The cells whose value is an error: a dict of addresses and messages.
    ///
    /// >>> sheet = pf.Sheet()
    /// >>> sheet["A1"] = "=A2"
    /// >>> sheet["A2"] = "=A1"
    /// >>> sorted(sheet.errors())
    /// ['A1', 'A2']
    fn errors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let errors = PyDict::new(py);
        let cells = self.locked(py);
        either!(&*cells, sheet => {
            for at in sheet.addresses() {
                if let Some(failure) = sheet.value(at).failure() {
                    errors.set_item(at.to_string(), failure.to_string())?;
                }
            }
        });
        Ok(errors)
    }

    /// Takes back the last change; says whether there was one.
    ///
    /// >>> sheet = pf.Sheet()
    /// >>> sheet["A1"] = 1
    /// >>> sheet.undo(), sheet["A1"], sheet.redo(), sheet["A1"]
    /// (True, None, True, 1.0)
    fn undo(&self, py: Python<'_>) -> PyResult<bool> {
        self.changed(py, |cells| {
            Ok(either!(cells, sheet => {
                let done = sheet.undo();
                sheet.recalculate_all();
                done
            }))
        })
    }

    /// Makes the last change again that was taken back; says whether there was one.
    ///
    /// >>> pf.Sheet().redo()
    /// False
    fn redo(&self, py: Python<'_>) -> PyResult<bool> {
        self.changed(py, |cells| {
            Ok(either!(cells, sheet => {
                let done = sheet.redo();
                sheet.recalculate_all();
                done
            }))
        })
    }

    /// How a formula follows a cell: the exact derivatives of all its numbers, as a sparse matrix.
    ///
    /// ``result`` is a formula without its ``=``, an address or a name; ``source`` an address, a range
    /// or a name. The numbers of a form are the coordinates and the weight of each pole, in the order
    /// of the poles. Returns a :class:`Sparse` with a row for each number of the result and a column
    /// for each of the source.
    ///
    /// Raises ShapeError for values that hold no numbers; DomainError when an operator in between
    /// measures or approximates, for a derivative that is infinite, and for a sheet in exact mode.
    ///
    /// >>> sheet = pf.Sheet()
    /// >>> sheet["A1"], sheet["A2"] = 3, "=A1^2"
    /// >>> sheet.sensitivities("2*A2", "A1").toarray()
    /// array([[12.]])
    fn sensitivities<'py>(
        &self,
        py: Python<'py>,
        result: &str,
        source: &str,
    ) -> PyResult<Bound<'py, PyAny>> {
        let matrix = done(py, usize::MAX, || self.traced(result, source)?.matrix())?;
        sparse(py, &matrix)
    }

    /// The derivatives of a weighted sum of the numbers of a formula in all numbers of a cell.
    ///
    /// One sweep back from the result to the source, whatever the size of the source. ``weights``
    /// has a number for each number of the result; without, all count once. Otherwise as
    /// :meth:`sensitivities`.
    ///
    /// >>> sheet = pf.Sheet()
    /// >>> sheet["A1"], sheet["A2"] = 3, "=[A1^2, 5*A1]"
    /// >>> sheet.gradient("A2", "A1", [1, 10])
    /// array([56.])
    #[pyo3(signature = (result, source, weights=None))]
    fn gradient<'py>(
        &self,
        py: Python<'py>,
        result: &str,
        source: &str,
        weights: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let weights =
            weights.map(|weights| PyResult::Ok(Numbers::read("weights", weights)?.into_values()));
        let weights: Option<Vec<f64>> = weights.transpose()?;
        let gradient = done(py, usize::MAX, || {
            let found = self.traced(result, source)?;
            let weights = weights.unwrap_or_else(|| vec![1.0; found.results()]);
            found.gradient(&weights)
        })?;
        Ok(PyArray1::from_vec(py, gradient).into_any())
    }

    fn __getitem__<'py>(&self, place: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let (py, place) = (place.py(), read_place(place)?);
        let cells = self.locked(py);
        match &*cells {
            Cells::Floating(sheet) => value_at(py, sheet, &place),
            Cells::Exact(sheet) => value_at(py, sheet, &place),
        }
    }

    fn __setitem__(&self, place: &Bound<'_, PyAny>, value: &Bound<'_, PyAny>) -> PyResult<()> {
        let (name, text) = (read_place(place)?, read_text(value)?);
        self.changed(place.py(), |cells| cells.set(&name, &text))
    }

    fn __delitem__(&self, place: &Bound<'_, PyAny>) -> PyResult<()> {
        let name = read_place(place)?;
        self.changed(place.py(), |cells| cells.set(&name, ""))
    }

    fn __contains__(&self, py: Python<'_>, place: &Bound<'_, PyAny>) -> bool {
        let cells = self.locked(py);
        let at = read_place(place).ok().and_then(|place| cells.cell(&place).ok());
        at.is_some_and(|at| !cells.document().text(at).is_empty())
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let names = self.locked(py).document().cells().map(|(at, _)| at.to_string()).collect();
        let list: Vec<String> = names;
        Ok(PyList::new(py, list)?.try_iter()?.into_any())
    }

    fn __len__(&self, py: Python<'_>) -> usize {
        self.locked(py).document().cells().count()
    }

    fn __str__(&self, py: Python<'_>) -> PyResult<String> {
        self.changed(py, |cells| Ok(pfs::write(cells.document())))
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        let cells = self.locked(py);
        let count = cells.document().cells().count();
        let exact = if matches!(*cells, Cells::Exact(_)) { ", exact" } else { "" };
        format!("<pforms.Sheet of {count} cells{exact}>")
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (String, bool))> {
        let restore = py.get_type::<Self>().getattr("_restore")?;
        Ok((restore, (self.__str__(py)?, self.exact(py))))
    }

    #[staticmethod]
    fn _restore(py: Python<'_>, text: &str, exact: bool) -> PyResult<Self> {
        Self::new(py, text, exact)
    }

    /// The picture of what the sheet shows, as the bytes of files: see `pforms.files.draw`.
    fn _draw<'py>(&self, look: &Bound<'py, PyAny>) -> PyResult<Vec<Bound<'py, PyBytes>>> {
        picture(look, |look| {
            let cells = self.lock();
            let mut scene =
                Scene { camera: look.camera(cells.document().camera())?, ..Scene::default() };
            either!(&*cells, sheet => scene_of(sheet, look, &mut scene))?;
            Ok(scene)
        })
    }
}

impl PySheet {
    fn computed(
        py: Python<'_>,
        exact: bool,
        read: impl FnOnce() -> Result<Document> + Send,
    ) -> PyResult<Self> {
        done(py, usize::MAX, || Ok(Self { cells: Mutex::new(Cells::of(read()?, exact)) }))
    }

    fn traced(&self, result: &str, source: &str) -> Result<Sensitivities> {
        let found = either!(&*self.lock(), sheet => sheet.sensitivities(result, source));
        found.map_err(|failure| failure.to_error())
    }

    /// The cells; Python's lock is given away while another thread has them.
    fn locked(&self, py: Python<'_>) -> MutexGuard<'_, Cells> {
        use pyo3::sync::MutexExt;
        self.cells.lock_py_attached(py).unwrap_or_else(PoisonError::into_inner)
    }

    fn lock(&self) -> MutexGuard<'_, Cells> {
        self.cells.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn changed<T: Send>(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&mut Cells) -> Result<T> + Send,
    ) -> PyResult<T> {
        done(py, usize::MAX, || change(&mut self.lock()))
    }
}

fn value_at<'py, S: Shown>(
    py: Python<'py>,
    sheet: &Sheet<S>,
    place: &str,
) -> PyResult<Bound<'py, PyAny>> {
    let value: Value<S> = sheet.get(place).map_err(|error| raised(&error))?;
    shown(py, value)
}

/// A `pforms.sparse.Sparse`.
pub(crate) fn sparse<'py>(py: Python<'py>, matrix: &Sparse) -> PyResult<Bound<'py, PyAny>> {
    let whole = |numbers: &[usize]| {
        PyArray1::from_iter(py, numbers.iter().map(|number| *number as i64)).into_any()
    };
    let fields = (
        PyArray1::from_slice(py, matrix.entries()).into_any(),
        whole(matrix.places()),
        whole(matrix.starts()),
        (matrix.rows(), matrix.columns()),
    );
    py.import(intern!(py, "pforms.sparse"))?.getattr(intern!(py, "Sparse"))?.call1(fields)
}

fn read_place(place: &Bound<'_, PyAny>) -> PyResult<String> {
    match place.cast::<PyString>() {
        Ok(text) => Ok(text.to_string_lossy().into_owned()),
        Err(_) => Err(mistyped("cell", place, "an address such as \"A1\", or a name")),
    }
}

/// The text of a cell: as typed, or what would be typed for a number or a form.
fn read_text(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(text.to_string_lossy().into_owned());
    }
    if let Ok(form) = value.cast::<PyForm>() {
        return Ok(literal(&form.get().form));
    }
    if value.is_none() {
        return Ok(String::new());
    }
    let number = crate::arguments::real("value", value)?;
    if !number.is_finite() {
        return Err(raised(&Error::domain("value", number, "a text, a form or a finite number")));
    }
    Ok(pforms_catalogue::Arithmetic::write(&number))
}
