//! Scans of instruments, heights of arrays, and the composite spectra that are made of them.

use std::collections::BTreeMap;
use std::convert::Infallible;

use findings::doubts::of_spacing;
use measurements::{
    Channels, CompositeOfFiles, Loaded, RequestError, RoughnessOfFiles, RoughnessSettings, ScalesOfFiles,
    ScanInput, ScanProblem, ScanRequest, TipRadius, TopographyError, read_channels,
};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::{PyDict, PyString, PyTuple};
use report::chart::maps::HeightsPicture;
use report::scan_words;
use report::scans_table::scans_columns;
use roughness::Evaluation;
use scans::{MissingPoints, ScanFile, ScanOption, ScanSize};
use study::surface::{Surface, SurfaceError};
use topography::Recipe;
use units::{RemarkLevel, RemarkPlace, SignedLength};

use crate::answer::{Keywords, Told, columns, in_text};
use crate::arguments::{Arguments, Given, choice, choice_or, count, length_m, number, quantity, text};
use crate::errors::{input, of_argument};
use crate::surface::PySurface;
use crate::work::{carry_out, light};

/// Files that were read already, under their names.
pub type HeldFiles = BTreeMap<String, PyBackedBytes>;

/// Options of a scan by their names, each with its argument and its value.
pub type Options<'py> = BTreeMap<String, (String, Given<'py>)>;

/// Heights of an array, and which of them do not count.
#[derive(FromPyObject)]
pub struct Heights<'py> {
    argument: String,
    name: String,
    heights_m: PyReadonlyArrayDyn<'py, f64>,
    gaps: Option<PyReadonlyArrayDyn<'py, bool>>,
    /// The argument of the size, and the lengths along x and y.
    size: (String, Vec<Given<'py>>),
    is_periodic: bool,
}

/// Part of a composite.
#[derive(FromPyObject)]
pub enum Part<'py> {
    Heights(Heights<'py>),
    Scan {
        #[pyo3(attribute("_native"))]
        scan: Py<PyScan>,
    },
    File {
        name: String,
        files: HeldFiles,
    },
}

/// A scan, with what is known of it besides its file.
#[pyclass(frozen, name = "Scan", module = "truearea._native")]
pub struct PyScan {
    request: ScanRequest,
    scan: ScanFile,
    sha256: String,
}

#[pymethods]
impl PyScan {
    /// The scan in a file among some that were read.
    #[staticmethod]
    fn of_file(py: Python<'_>, name: String, files: HeldFiles, options: Options<'_>) -> PyResult<Self> {
        let request = request(name, options)?;
        let Loaded { mut scans, sha256 } =
            light(py, || Loaded::read(&request, &files)).map_err(|error| refused(&error, ""))?;
        if scans.len() == 1 {
            return Ok(PyScan { request, scan: scans.remove(0), sha256 });
        }
        let (name, count) = (request.path, scans.len());
        let names = scans.iter().map(|scan| scan.name.as_str()).collect::<Vec<_>>().join(", ");
        Err(input(format!("{name}: it holds {count} scans ({names}); choose one with measurement")))
    }

    /// Heights of an array.
    #[staticmethod]
    fn of_heights(py: Python<'_>, heights: Heights<'_>) -> PyResult<Self> {
        let request = ScanRequest { path: heights.name.clone(), ..ScanRequest::default() };
        let Loaded { mut scans, sha256 } = heights.loaded(py)?;
        Ok(PyScan { request, scan: scans.remove(0), sha256 })
    }

    /// Facts that the file tells by their names; lengths are along x, and of a map along y.
    #[getter]
    fn facts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (file, scan) = (&self.scan, &self.scan.scan);
        let along = |(x_m, y_m): (f64, Option<f64>)| {
            PyTuple::new(py, std::iter::once(x_m).chain(y_m).collect::<Vec<f64>>())
        };
        let facts = PyDict::new(py);
        facts.set_item("sha256", &self.sha256)?;
        facts.set_item("name", &file.name)?;
        facts.set_item("format", file.format.to_string())?;
        facts.set_item("channel", &file.channel)?;
        facts.set_item("channels", PyTuple::new(py, &file.channels)?)?;
        facts.set_item("notes", PyTuple::new(py, &file.notes)?)?;
        facts.set_item("is_periodic", file.is_periodic)?;
        facts.set_item("tip_radius_m", file.tip_radius_m)?;
        facts.set_item("size_m", along(scan.size_m())?)?;
        facts.set_item("spacing_m", along(scan.spacing_m())?)?;
        let positions_m = scan.positions_m().map(|positions_m| PyArray1::from_slice(py, positions_m));
        facts.set_item("positions_m", positions_m)?;
        Ok(facts)
    }

    /// Roughness parameters by the standards, or rms gradient and curvature down to each wavelength: columns, and notes in words.
    fn roughness<'py>(
        &self,
        py: Python<'py>,
        arguments: Arguments<'py>,
    ) -> PyResult<(Bound<'py, PyDict>, Vec<Told>)> {
        let evaluation = Evaluation {
            form: arguments.get("form", choice_or(["mean", "none"]))?.unwrap_or_default(),
            longest_m: arguments.get("filter", length_m)?,
            shortest_m: arguments.get("short_filter", length_m)?,
        };
        let settings = RoughnessSettings {
            evaluation,
            ratio_height_m: arguments.get("ratio_height", quantity)?.map_or(0.0, |SignedLength { m }| m),
            conventions: arguments.get("convention", choice)?.unwrap_or_default(),
        };
        let is_of_scales = arguments.flag("scales")?;
        let found = light(py, || match is_of_scales {
            true => ScalesOfFiles::of_scan(&self.request, &self.scan, &evaluation)
                .map(|found| (found.table(), found.notes())),
            false => RoughnessOfFiles::of_scan(&self.request, &self.scan, &settings)
                .map(|found| (found.table(), found.notes())),
        });
        let (table, notes) = found.map_err(|error| refused(&error, ""))?;
        let place = RemarkPlace { files: vec![self.request.path.clone()], ..RemarkPlace::default() };
        let of_reading = self.scan.notes.iter().map(|text| (text.clone(), "surface.scans.scan"));
        let notes = of_reading.chain(notes.into_iter().map(|text| (text, "missing-points")));
        let note = |(text, code): (_, &str)| in_text(text, code.to_owned(), RemarkLevel::Note, place.clone());
        Ok((columns(py, &table)?, notes.map(note).collect()))
    }

    /// Heights, 0 in gaps, and which points are gaps, where there are any.
    fn heights<'py>(&self, py: Python<'py>) -> PyResult<(Given<'py>, Option<Given<'py>>)> {
        let (measured, gaps) = (&self.scan.scan, self.scan.scan.missing_points());
        let (points, rows) = measured.points();
        let shape: Vec<usize> = rows.into_iter().chain([points]).collect();
        let heights_m: Vec<f64> = measured.heights_m().map(|height_m| height_m.unwrap_or(0.0)).collect();
        let mask = (!gaps.is_empty()).then(|| {
            let is_gap = (0..heights_m.len()).map(|index| gaps.contains(index)).collect();
            PyArray1::from_vec(py, is_gap).reshape(&shape[..])
        });
        let mask = mask.transpose()?.map(Bound::into_any);
        Ok((PyArray1::from_vec(py, heights_m).reshape(&shape[..])?.into_any(), mask))
    }

    /// The row of the program's command `scan` for this scan.
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        columns(py, &light(py, || Channels::from_scan(&self.request, &self.scan).table()))
    }

    /// The heights drawn, a line or a map; none where no point has one.
    fn picture(&self, py: Python<'_>) -> Option<String> {
        light(py, || HeightsPicture::new(&self.scan).map(|picture| picture.document()))
    }
}

impl Heights<'_> {
    /// Makes the one copy of an array: what it holds becomes the scan's.
    fn loaded(self, py: Python<'_>) -> PyResult<Loaded> {
        let Heights { argument, name, heights_m, gaps, size: (of_size, lengths), is_periodic } = self;
        let length = |(at, length)| length_m(&format!("{of_size}[{at}]"), length);
        let lengths_m: Vec<f64> = lengths.iter().enumerate().map(length).collect::<PyResult<_>>()?;
        let [x_m, ..] = lengths_m[..] else { return Err(of_argument(&of_size, "it is empty")) };
        let size = ScanSize { x_m, y_m: lengths_m.get(1).copied() };
        let found: MissingPoints = gaps.map_or_else(MissingPoints::default, |gaps| {
            gaps.as_array().iter().enumerate().filter(|(_, gap)| **gap).map(|(at, _)| at).collect()
        });
        // In C order alone the memory is row after row.
        let (shape, given) = (heights_m.shape(), heights_m.as_array());
        let mut heights_m = given.to_slice().map_or_else(|| given.iter().copied().collect(), <[f64]>::to_vec);
        found.indices().for_each(|index| heights_m[index] = 0.0);
        if let Some(at) = heights_m.iter().position(|height_m: &f64| !height_m.is_finite()) {
            let place = match shape {
                [_, columns] => format!("{}, {}", at / columns, at % columns),
                _ => at.to_string(),
            };
            return Err(input(format!(
                "{argument}[{place}] is {}; heights are finite: mask points without one, numpy.ma.masked_invalid({argument})",
                heights_m[at]
            )));
        }
        let scan = match shape {
            [_, columns] => ScanFile::of_map(name, size, *columns, heights_m, found),
            _ => ScanFile::of_line(name, size, heights_m, found),
        };
        let mut scan = scan.map_err(|error| of_argument(&argument, error))?;
        scan.is_periodic = is_periodic;
        if let (x_m, Some(y_m)) = scan.scan.spacing_m() {
            scan.notes.extend(of_spacing([x_m, y_m]).map(|note| note.words(&Keywords)));
        }
        Ok(light(py, || Loaded::from_heights(scan)))
    }
}

/// The composite spectrum of scans, under a name.
#[pyfunction]
pub fn composite(
    py: Python<'_>,
    name: String,
    parts: Vec<(Part<'_>, Options<'_>)>,
    recipe: Arguments<'_>,
    argument: &str,
) -> PyResult<PySurface> {
    let (recipe, mut all_files) = (recipe_of(&recipe)?, HeldFiles::new());
    let scan = |(part, options)| match part {
        Part::File { name, files } => {
            all_files.extend(files);
            request(name, options).map(ScanInput::File)
        }
        // What is said of a scan here counts before what was said then.
        Part::Scan { scan } => {
            let PyScan { request, scan, sha256 } = scan.get();
            let loaded = Loaded { scans: vec![scan.clone()], sha256: sha256.clone() };
            Ok(ScanInput::InMemory(with_options(request.clone(), options)?, loaded))
        }
        Part::Heights(heights) => {
            let request = request(heights.name.clone(), options)?;
            Ok(ScanInput::InMemory(request, heights.loaded(py)?))
        }
    };
    let scans = parts.into_iter().map(scan).collect::<PyResult<Vec<_>>>()?;
    let made = carry_out(py, None, |watch| {
        Surface::of_composite(CompositeOfFiles::from_scans(scans, &all_files, &recipe, watch)?, name)
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
    name: String,
    files: HeldFiles,
    options: Options<'_>,
    all_channels: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let request = request(name, options)?;
    let Ok(found) =
        light(py, || read_channels::<Infallible>(&[request], &files, all_channels, |_, _| Ok(())));
    match found.unreadable.first() {
        Some(error) => Err(refused(error, "")),
        None => columns(py, &found.table()),
    }
}

/// Builds the request for a scan from its options.
pub fn request(path: String, options: Options<'_>) -> PyResult<ScanRequest> {
    with_options(ScanRequest { path, ..ScanRequest::default() }, options)
}

fn with_options(mut request: ScanRequest, options: Options<'_>) -> PyResult<ScanRequest> {
    for (key, (argument, value)) in options {
        if key == "measurement" {
            request.measurement = Some(text(&argument, &value)?);
            continue;
        }
        let typed = match (value.cast::<PyString>(), key.as_str()) {
            (Ok(text), _) => text.to_string(),
            (Err(_), "size" | "shortest" | "tip_radius") => format!("{} m", length_m(&argument, &value)?),
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
    let tip_radius = arguments.get("tip_radius", |name, value| match value.cast::<PyString>() {
        Ok(text) => text.to_str()?.parse().map_err(|error| of_argument(name, error)),
        Err(_) => length_m(name, value).map(TipRadius::Known),
    })?;
    let usual = Recipe::default();
    Ok(Recipe {
        detrend: arguments.get("detrend", choice_or(["none", "mean"]))?,
        window: arguments.get("window", choice)?,
        average: arguments.get("average", choice)?.unwrap_or(usual.average),
        bins_per_decade: arguments.get("bins_per_decade", count)?.unwrap_or(usual.bins_per_decade),
        tip_radius_m: tip_radius.and_then(TipRadius::known_m),
        ..usual
    })
}

/// Converts an error of scans, with the argument that mends it; `argument` is the list that holds the scans.
pub fn refused(error: &TopographyError, argument: &str) -> PyErr {
    let place = match error.request {
        Some(at) if !argument.is_empty() => format!("{argument}[{at}]: "),
        _ => String::new(),
    };
    let argument_of = |option| match option {
        ScanOption::Unit => Some("unit"),
        ScanOption::HeightUnit => Some("height_unit"),
        ScanOption::Units => Some("unit, and height_unit where they differ"),
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
