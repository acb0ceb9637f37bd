//! Scans of instruments, heights of arrays, and the composite spectra that are made of them.

use std::collections::BTreeMap;
use std::io;
use std::sync::{Mutex, PoisonError};

use measurements::{
    Channels, CompositeOfFiles, Files, Loaded, RequestError, RoughnessOfFiles, RoughnessSettings, ScanInput,
    ScanProblem, ScanRequest, TipRadius, TopographyError, read_channels,
};
use numpy::ndarray::ArrayD;
use numpy::{PyArrayDyn, PyReadonlyArrayDyn, PyUntypedArrayMethods, ToPyArray};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::{PyDict, PyString};
use questions::NotePlace;
use report::heights_picture::{HeightsPicture, of_heights};
use report::scan_words;
use report::scans_table::scans_columns;
use roughness::Evaluation;
use scans::{MissingPoints, ScanFile, ScanOption, ScanSize};
use study::surface::{Surface, SurfaceError};
use topography::Recipe;
use units::{Length, SignedLength};

use crate::answer::{Told, columns, in_text};
use crate::arguments::{Arguments, Given, number, quantity, text};
use crate::errors::{input, of_argument};
use crate::picture::{Map, map};
use crate::surface::PySurface;
use crate::work::{carry_out, light};

/// Files that were read already, under their names.
#[derive(FromPyObject)]
pub struct HeldFiles(BTreeMap<String, PyBackedBytes>);

impl Files for HeldFiles {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        let bytes = self.0.get(name).ok_or_else(|| io::Error::from(io::ErrorKind::NotFound))?;
        Ok(bytes.to_vec())
    }

    fn read_beside(&self, name: &str, sibling: &str) -> io::Result<Option<Vec<u8>>> {
        let folder = name.rfind(['/', '\\']).map_or("", |end| &name[..=end]);
        Ok(self.0.get(&format!("{folder}{sibling}")).map(|bytes| bytes.to_vec()))
    }
}

/// A scan, with what is known of it besides its file.
#[pyclass(frozen, name = "Scan", module = "truearea._native")]
pub struct PyScan {
    request: ScanRequest,
    scan: ScanFile,
    #[pyo3(get)]
    sha256: String,
    #[pyo3(get)]
    name: String,
    #[pyo3(get)]
    format: String,
    #[pyo3(get)]
    channel: Option<String>,
    #[pyo3(get)]
    channels: Vec<String>,
    #[pyo3(get)]
    notes: Vec<String>,
    #[pyo3(get)]
    is_periodic: bool,
    #[pyo3(get)]
    tip_radius_m: Option<f64>,
    /// Along x, and of a map along y.
    #[pyo3(get)]
    size_m: Vec<f64>,
    #[pyo3(get)]
    spacing_m: Vec<f64>,
    #[pyo3(get)]
    positions_m: Option<Vec<f64>>,
}

impl PyScan {
    fn of(request: ScanRequest, scan: ScanFile, sha256: String) -> Self {
        let along = |(x_m, y_m): (f64, Option<f64>)| std::iter::once(x_m).chain(y_m).collect();
        PyScan {
            name: scan.name.clone(),
            format: scan.format.to_string(),
            channel: scan.channel.clone(),
            channels: scan.channels.clone(),
            notes: scan.notes.clone(),
            is_periodic: scan.is_periodic,
            tip_radius_m: scan.tip_radius_m,
            size_m: along(scan.scan.size_m()),
            spacing_m: along(scan.scan.spacing_m()),
            positions_m: scan.scan.positions_m().map(<[f64]>::to_vec),
            request,
            scan,
            sha256,
        }
    }
}

#[pymethods]
impl PyScan {
    /// The scan in a file among some that were read.
    #[staticmethod]
    fn of_file(py: Python<'_>, name: &str, files: HeldFiles, options: &Bound<'_, PyDict>) -> PyResult<Self> {
        let request = request(name, options)?;
        let mut loaded = light(py, || Loaded::read(&request, &files)).map_err(|error| refused(&error, ""))?;
        match (loaded.scans.pop(), &loaded.scans[..]) {
            (Some(scan), []) => Ok(PyScan::of(request, scan, loaded.sha256)),
            (last, others) => {
                let names: Vec<&str> = others.iter().chain(&last).map(|scan| scan.name.as_str()).collect();
                let count = names.len();
                let names = names.join(", ");
                Err(input(format!("{name}: it holds {count} scans ({names}); choose one with measurement")))
            }
        }
    }

    /// Heights of an array; `gaps` tells which of them do not count.
    #[staticmethod]
    fn of_heights(
        py: Python<'_>,
        argument: &str,
        name: &str,
        heights_m: PyReadonlyArrayDyn<'_, f64>,
        gaps: Option<PyReadonlyArrayDyn<'_, bool>>,
        size: (String, Vec<Given<'_>>),
        is_periodic: bool,
    ) -> PyResult<Self> {
        let mut scan = scan_of_array(argument, name, &heights_m, gaps.as_ref(), size)?;
        scan.is_periodic = is_periodic;
        let request = ScanRequest { path: name.to_owned(), ..ScanRequest::default() };
        let sha256 = light(py, || Loaded::from_heights(scan.clone())).sha256;
        Ok(PyScan::of(request, scan, sha256))
    }

    /// Roughness parameters by the standards: columns, and notes in words.
    fn roughness<'py>(
        &self,
        py: Python<'py>,
        arguments: Arguments<'py>,
    ) -> PyResult<(Bound<'py, PyDict>, Vec<Told>)> {
        let settings = RoughnessSettings {
            evaluation: Evaluation {
                form: arguments.named("form")?.unwrap_or_default(),
                longest_m: arguments.length_m("filter")?,
                shortest_m: arguments.length_m("short_filter")?,
            },
            ratio_height_m: arguments
                .quantity::<SignedLength>("ratio_height")?
                .map_or(0.0, |height| height.m),
            conventions: arguments.named("convention")?.unwrap_or_default(),
        };
        let found = light(py, || RoughnessOfFiles::of_scan(&self.request, &self.scan, &settings));
        let found = found.map_err(|error| refused(&error, ""))?;
        let notes = found.notes().into_iter().map(|text| {
            let files = vec![self.request.path.clone()];
            in_text(text, "missing-points", NotePlace { files, ..NotePlace::default() })
        });
        Ok((columns(py, &found.table())?, notes.collect()))
    }

    /// Heights, 0 in gaps, and which points are gaps, where there are any.
    #[allow(clippy::type_complexity, reason = "two arrays of Python")]
    fn heights<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyArrayDyn<f64>>, Option<Bound<'py, PyArrayDyn<bool>>>)> {
        let measured = &self.scan.scan;
        let (points, rows) = measured.points();
        let shape: Vec<usize> = rows.into_iter().chain([points]).collect();
        let heights_m = measured.heights_m().map(|height_m| height_m.unwrap_or(0.0)).collect();
        let heights_m = ArrayD::from_shape_vec(shape.clone(), heights_m).map_err(input)?;
        let gaps = measured.missing_points();
        let mask = (!gaps.is_empty()).then(|| {
            let is_gap = (0..heights_m.len()).map(|index| gaps.contains(index)).collect();
            ArrayD::from_shape_vec(shape, is_gap).map_err(input)
        });
        Ok((heights_m.to_pyarray(py), mask.transpose()?.map(|mask| mask.to_pyarray(py))))
    }

    /// The row of the program's command `scan` for this scan.
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let table = light(py, || Channels::from_scan(&self.request, &self.scan).table());
        columns(py, &table)
    }

    /// The heights drawn, a line or a map; none where no point has one.
    fn picture<'py>(&self, py: Python<'py>) -> Option<(String, Option<Map<'py>>)> {
        match light(py, || of_heights(&self.scan))? {
            HeightsPicture::Line(svg) => Some((svg, None)),
            HeightsPicture::Map(picture) => Some((String::new(), Some(map(py, picture)))),
        }
    }
}

/// A part of a composite, until it is made.
#[pyclass(frozen, name = "AskedScan", module = "truearea._native")]
pub struct PyAskedScan(Mutex<Option<ScanInput>>);

#[pymethods]
impl PyAskedScan {
    /// A file, with what it does not say itself.
    #[staticmethod]
    fn of_file(name: &str, options: &Bound<'_, PyDict>) -> PyResult<Self> {
        Ok(Self::of(ScanInput::File(request(name, options)?)))
    }

    /// A scan that was read; what is said of it here counts before what was said then.
    #[staticmethod]
    fn of_scan(scan: &PyScan, options: &Bound<'_, PyDict>) -> PyResult<Self> {
        let request = with_options(scan.request.clone(), options)?;
        let loaded = Loaded { scans: vec![scan.scan.clone()], sha256: scan.sha256.clone() };
        Ok(Self::of(ScanInput::InMemory(request, loaded)))
    }

    /// Heights of an array; `gaps` tells which of them do not count.
    #[staticmethod]
    #[allow(clippy::too_many_arguments, reason = "the arguments of a call from Python, by name")]
    fn of_heights(
        py: Python<'_>,
        argument: &str,
        name: &str,
        heights_m: PyReadonlyArrayDyn<'_, f64>,
        gaps: Option<PyReadonlyArrayDyn<'_, bool>>,
        size: (String, Vec<Given<'_>>),
        is_periodic: bool,
        options: &Bound<'_, PyDict>,
    ) -> PyResult<Self> {
        let request = request(name, options)?;
        let mut scan = scan_of_array(argument, name, &heights_m, gaps.as_ref(), size)?;
        scan.is_periodic = is_periodic;
        Ok(Self::of(ScanInput::InMemory(request, light(py, || Loaded::from_heights(scan)))))
    }
}

impl PyAskedScan {
    fn of(asked: ScanInput) -> Self {
        PyAskedScan(Mutex::new(Some(asked)))
    }

    fn taken(&self) -> PyResult<ScanInput> {
        let taken = self.0.lock().unwrap_or_else(PoisonError::into_inner).take();
        taken.ok_or_else(|| input("this scan is part of a composite already"))
    }
}

/// The one copy that is made of an array: what it holds becomes the scan's.
fn scan_of_array(
    argument: &str,
    name: &str,
    heights_m: &PyReadonlyArrayDyn<'_, f64>,
    gaps: Option<&PyReadonlyArrayDyn<'_, bool>>,
    (of_size, size): (String, Vec<Given<'_>>),
) -> PyResult<ScanFile> {
    let shape = heights_m.shape();
    let length = |(at, length): (usize, &Given<'_>)| {
        quantity::<Length>(&format!("{of_size}[{at}]"), length).map(|length| length.m)
    };
    let lengths_m: Vec<f64> = size.iter().enumerate().map(length).collect::<PyResult<_>>()?;
    let [x_m, ..] = lengths_m[..] else { return Err(of_argument(&of_size, "it is empty")) };
    let size = ScanSize { x_m, y_m: lengths_m.get(1).copied() };
    let found: MissingPoints = match gaps {
        Some(gaps) => gaps.as_array().iter().enumerate().filter(|(_, gap)| **gap).map(|(at, _)| at).collect(),
        None => MissingPoints::default(),
    };
    // In C order alone the memory is row after row.
    let given = heights_m.as_array();
    let mut heights: Vec<f64> =
        given.to_slice().map_or_else(|| given.iter().copied().collect(), <[f64]>::to_vec);
    found.indices().for_each(|index| heights[index] = 0.0);
    if let Some(at) = heights.iter().position(|height_m| !height_m.is_finite()) {
        let place = match shape {
            [_, columns] => format!("{}, {}", at / columns, at % columns),
            _ => at.to_string(),
        };
        return Err(input(format!(
            "{argument}[{place}] is {}; heights are finite: mask points without one, numpy.ma.masked_invalid({argument})",
            heights[at]
        )));
    }
    let scan = match shape {
        [_, columns] => ScanFile::of_map(name.to_owned(), size, *columns, heights, found),
        _ => ScanFile::of_line(name.to_owned(), size, heights, found),
    };
    scan.map_err(|error| of_argument(argument, error))
}

/// The composite spectrum of scans, under a name.
#[pyfunction]
pub fn composite(
    py: Python<'_>,
    name: String,
    asked: Vec<Py<PyAskedScan>>,
    files: HeldFiles,
    recipe: Arguments<'_>,
    argument: &str,
) -> PyResult<PySurface> {
    let recipe = recipe_of(&recipe)?;
    let asked = asked.iter().map(|asked| asked.get().taken()).collect::<PyResult<Vec<_>>>()?;
    let made = carry_out(py, None, |progress| {
        Surface::of_composite(CompositeOfFiles::from_scans(asked, &files, &recipe, progress)?, name)
    })?;
    let surface = made.map_err(|error| match &error {
        SurfaceError::Scans(error) => refused(error, argument),
        error => input(error),
    })?;
    Ok(PySurface { surface })
}

/// The scans that a surface is made of, a row for each; none of a surface that is made of none.
#[pyfunction]
pub fn scans_of<'py>(py: Python<'py>, surface: &PySurface) -> PyResult<Option<Bound<'py, PyDict>>> {
    let made_from = surface.surface.made_from.as_ref();
    made_from.map(|scans| columns(py, &scans_columns(&scans.spectrum))).transpose()
}

/// Every channel of a file among some that were read: the columns of the program's command for scans.
#[pyfunction]
pub fn channels_of<'py>(
    py: Python<'py>,
    name: &str,
    files: HeldFiles,
    options: &Bound<'_, PyDict>,
    all_channels: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let request = request(name, options)?;
    let Ok(found) = light(py, || {
        read_channels::<std::convert::Infallible>(&[request], &files, all_channels, |_, _| Ok(()))
    });
    match found.unreadable.first() {
        Some(error) => Err(refused(error, "")),
        None => columns(py, &found.table()),
    }
}

/// Builds the request for a scan from options by their names, each under the name of its argument.
fn request(name: &str, options: &Bound<'_, PyDict>) -> PyResult<ScanRequest> {
    with_options(ScanRequest { path: name.to_owned(), ..ScanRequest::default() }, options)
}

fn with_options(mut request: ScanRequest, options: &Bound<'_, PyDict>) -> PyResult<ScanRequest> {
    for (key, given) in options {
        let (argument, value): (String, Given<'_>) = given.extract()?;
        let key: String = key.extract()?;
        if key == "measurement" {
            request.measurement = Some(text(&argument, &value)?);
            continue;
        }
        let typed = match (value.cast::<PyString>(), key.as_str()) {
            (Ok(text), _) => text.to_string(),
            (Err(_), "size" | "shortest" | "tip_radius") => {
                format!("{} m", quantity::<Length>(&argument, &value)?.m)
            }
            (Err(_), "z_calibration" | "slope_uncertainty") => number(&argument, &value)?.to_string(),
            (Err(_), _) => text(&argument, &value)?,
        };
        request = request.with_option(&key, &typed).map_err(|error| match error {
            RequestError::BadValue { problem, .. } => of_argument(&argument, problem),
            error => input(error),
        })?;
    }
    Ok(request)
}

/// Builds the recipe for the spectra of all scans.
fn recipe_of(arguments: &Arguments<'_>) -> PyResult<Recipe> {
    let (usual, tip_radius) = (Recipe::default(), arguments.convert("tip_radius", tip_radius)?);
    Ok(Recipe {
        detrend: arguments.named("detrend")?,
        window: arguments.named("window")?,
        average: arguments.named("average")?.unwrap_or(usual.average),
        bins_per_decade: arguments.count("bins_per_decade")?.unwrap_or(usual.bins_per_decade),
        tip_radius_m: tip_radius.and_then(TipRadius::known_m),
        tip_radius_auto: tip_radius == Some(TipRadius::Auto),
        ..usual
    })
}

fn tip_radius(argument: &str, value: &Given<'_>) -> PyResult<TipRadius> {
    match value.cast::<PyString>() {
        Ok(text) => text.to_str()?.parse().map_err(|error| of_argument(argument, error)),
        Err(_) => quantity::<Length>(argument, value).map(|length| TipRadius::Known(length.m)),
    }
}

/// Converts an error of scans, with the argument that mends it; `argument` is the list that holds the scans.
fn refused(error: &TopographyError, argument: &str) -> PyErr {
    let place = match error.request {
        Some(at) if !argument.is_empty() => format!("{argument}[{at}]: "),
        _ => String::new(),
    };
    let argument_of = |option| match option {
        ScanOption::Unit => Some("unit"),
        ScanOption::Size => Some("size"),
        ScanOption::Channel => Some("channel"),
        ScanOption::Measurement => Some("measurement"),
        _ => None,
    };
    let mend = match &error.problem {
        ScanProblem::HoldsASpectrum => "; use read_psd".to_owned(),
        _ => error.mend().map_or_else(String::new, |mend| scan_words::mend(mend, argument_of)),
    };
    input(format!("{place}{error}{mend}"))
}
