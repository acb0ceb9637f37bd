//! Scenes: what is typed in one, what it reads, and everything that is made of it.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::fmt::Display;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use findings::answer::SceneAnswer;
use pyo3::exceptions::{PyFileNotFoundError, PyOSError};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyBytes, PyDict, PyMapping};
use questions::{ReportSurface, RunError, RunOptions, run_scene};
use report::chart::palette::ModelStyle;
use report::conclusion_words::{SummaryEnd, short_summary};
use report::curve_names::short_name;
use report::details::details;
use report::dry_run::dry_run;
use report::products::{Product, SceneProducts};
use report::run_stamp::RunStamp;
use scene::{
    Overrides, ReplaceError, Scene, SceneError, SceneProblem, SceneText, Template, si_unit, with_keys,
    with_si_unit,
};
use study::Files;
use study::figure::CurveLook;
use study::plan::PlanError;
use tables::Format;
use tables::staging::StagedFiles;
use tables::staging::reading::bytes_of;
use toml::Value;
use units::printable::message;

use crate::answer::{columns, words};
use crate::arguments::{Arguments, Given, named, number, truth, without_unit, wrong_type};
use crate::errors::{input, of_argument};
use crate::surface::PySurface;
use crate::work::{Observer, carry_out, held, light};

/// A scene as the core has it, and the files that it read.
#[pyclass(frozen, name = "Scene", module = "truearea._native")]
pub struct PyScene {
    scene: Scene,
    name: String,
    files: Read,
}

/// Bytes of files by their names in a scene.
type Read = BTreeMap<String, Vec<u8>>;

/// Columns of tables by their names, with the lines that tell where they come from.
type Tables<'py> = Bound<'py, PyDict>;

/// Files below a folder, each read once and kept, so that the scene can be made again where the folder is not.
struct Remembering {
    folder: PathBuf,
    read: Mutex<Read>,
}

impl Remembering {
    /// Reads a file unless it is kept; none if its path is not wanted.
    fn kept(&self, name: &str, is_wanted: fn(&Path) -> bool) -> io::Result<Option<Vec<u8>>> {
        let mut read = held(&self.read);
        let path = self.folder.join(name);
        if !read.contains_key(name) && is_wanted(&path) {
            read.insert(name.to_owned(), bytes_of(&path)?);
        }
        Ok(read.get(name).cloned())
    }
}

impl Files for Remembering {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        self.kept(name, |_| true)?.ok_or_else(|| io::Error::from(io::ErrorKind::NotFound))
    }

    fn read_beside(&self, name: &str, sibling: &str) -> io::Result<Option<Vec<u8>>> {
        let folder = name.rfind('/').map_or("", |end| &name[..=end]);
        self.kept(&format!("{folder}{sibling}"), Path::is_file)
    }
}

#[pymethods]
impl PyScene {
    /// The scene of a text. Files come from those given, or else from below the folder; the two faces in memory count before the
    /// files of the scene's own.
    #[new]
    fn new(
        py: Python<'_>,
        text: &str,
        name: String,
        folder: PathBuf,
        files: Read,
        faces: [Option<PyRef<'_, PySurface>>; 2],
    ) -> PyResult<Self> {
        let [surface, counterface_surface] = faces.map(|face| face.map(|face| face.surface.clone()));
        let overrides = Overrides { surface, counterface_surface, ..Overrides::default() };
        let files = Remembering { folder, read: Mutex::new(files) };
        let scene = light(py, || Scene::parse(text, &files, &overrides));
        let scene = scene.map_err(|error| refused(&error, text, &name))?;
        Ok(PyScene { scene, name, files: files.read.into_inner().unwrap_or_else(PoisonError::into_inner) })
    }

    /// Facts by their names: title, number of loads, notes on the surface and on keys without effect, and short name, colour and
    /// SVG dash of every curve.
    #[getter]
    fn facts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let Scene { title, needs, surface, notes: of_scene, .. } = &self.scene;
        let styled = needs.curves.iter().zip(CurveLook::of_curves(&needs.curves)).map(|(curve, look)| {
            let ModelStyle { colour, dash, .. } = ModelStyle::new(look);
            (&curve.name, (short_name(curve), colour, dash))
        });
        let facts = PyDict::new(py);
        facts.set_item("title", title)?;
        facts.set_item("loads", needs.loads.len())?;
        facts.set_item("notes", words(&[&surface.notes[..], of_scene].concat()))?;
        facts.set_item("styles", styled.into_py_dict(py)?)?;
        Ok(facts)
    }

    /// The files that it read.
    #[getter]
    fn files(&self) -> Read {
        self.files.clone()
    }

    /// Returns the steps that a run of the scene would take.
    fn explain(&self, py: Python<'_>) -> String {
        light(py, || dry_run(&self.scene))
    }

    /// Runs the scene and returns all its results: the answer in words, tables with the lines that tell where they come
    /// from, and the bytes of files by name. The stamp is the date and what was typed.
    fn run<'py>(
        &self,
        py: Python<'py>,
        arguments: Arguments<'py>,
        stamp: (Option<String>, Option<String>),
        observer: Option<&Observer<'py>>,
    ) -> PyResult<(String, Tables<'py>, Bound<'py, PyDict>)> {
        let run_stamp = &RunStamp { date: stamp.0, command: stamp.1 };
        let (judge, uncertainty) = (arguments.get("judge", truth)?, arguments.get("uncertainty", truth)?);
        let options = RunOptions { report: arguments.flag("report")?, judge, uncertainty };
        let made = carry_out(py, observer, |watch| {
            let outcome = run_scene(&self.scene, options, watch)?;
            let (evidence, conclusions) = (outcome.evidence(&self.scene), &outcome.conclusions);
            let sensitivities = outcome.sensitivities.as_deref();
            let products = SceneProducts { evidence, conclusions, sensitivities, run_stamp };
            let (mut tables, mut files) = (Vec::new(), Vec::new());
            let Ok(()) = products.each(Format::Csv, |name, product| {
                let mut bytes = Vec::new();
                product.write(Format::Csv, &mut bytes).expect("memory takes everything");
                files.push((product.file_name(name, Format::Csv), bytes));
                if let Product::Table { table, origin } = product {
                    tables.push((name.to_owned(), table.clone(), origin.to_vec()));
                }
                Ok::<(), Infallible>(())
            });
            let end = SummaryEnd { report: None, warnings: 0, notes: 0, verbose_option: "" };
            let short = short_summary(conclusions, &self.scene, &end);
            Ok((format!("{short}\n{}", details(&evidence, conclusions)), tables, files))
        })?;
        let (answer, tables, files) = made.map_err(|error: RunError| self.failed(error))?;
        let converted = |(name, table, origin)| Ok((name, (columns(py, &table)?, origin)));
        let tables: Vec<(String, _)> = tables.into_iter().map(converted).collect::<PyResult<_>>()?;
        Ok((answer, tables.into_py_dict(py)?, files.into_py_dict(py)?))
    }

    /// The final areas of every curve under every load, and nothing else: `curve`, `nominal_pressure_pa`, `area_fraction`, and
    /// what else the table `report-scales` has.
    fn scales<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let table = carry_out(py, None, |watch| {
            let results = self.scene.plan().compute_observed(watch)?;
            Ok(SceneAnswer::from_results(&self.scene, &results).scales_table(&self.scene.needs))
        })?;
        columns(py, &table.map_err(|error: PlanError| self.failed(error))?)
    }
}

impl PyScene {
    /// Converts an error of the scene's run.
    fn failed(&self, error: impl Display) -> PyErr {
        input(format!("{}: {error}", self.name))
    }
}

/// The text of a scene that comes with the program.
#[pyfunction]
pub fn scene_template(name: &str) -> PyResult<&'static str> {
    named::<Template>("name", name).map(Template::text)
}

/// The text of a scene with keys set anew.
#[pyfunction]
pub fn scene_with_keys(text: &str, name: &str, changes: &Bound<'_, PyDict>) -> PyResult<String> {
    let typed = changes.iter().map(|(key, value)| {
        let key: String = key.extract()?;
        value_of(&key, &value).map(|value| (key, value))
    });
    let typed: Vec<(String, Value)> = typed.collect::<PyResult<_>>()?;
    let changes = typed.iter().map(|(key, value)| (key.as_str(), value.clone()));
    with_keys(text, changes).map_err(|error| match error {
        ReplaceError::Scene(error) => refused(&error, text, name),
        error => input(error),
    })
}

/// The text of a scene from those of its sections that are given, in their order. Files become the surface of the section they are
/// given for: one spectrum, or scans, each perhaps with what its file leaves open, as on the command line.
#[pyfunction]
pub fn scene_text(
    sections: &Bound<'_, PyDict>,
    files: BTreeMap<String, Option<Vec<String>>>,
) -> PyResult<String> {
    let mut text = SceneText::default();
    for (key, value) in sections.iter().filter(|(_, value)| !value.is_none()) {
        let key: String = key.extract()?;
        let set = match files.get(&key).and_then(Option::as_ref) {
            Some(files) => {
                let here = Remembering { folder: PathBuf::new(), read: Mutex::default() };
                let argument = key.replace('.', "_");
                let request = |text: &String| text.parse().map_err(|error| of_argument(&argument, error));
                let requests = files.iter().map(request).collect::<PyResult<_>>()?;
                let surface = ReportSurface::of_files(requests, &here);
                text.set(&key, &surface.map_err(|error| of_argument(&argument, error))?)
            }
            None => text.set(&key, &value_of(&key, &value)?),
        };
        set.map_err(input)?;
    }
    Ok(text.to_string())
}

/// Writes files into a folder, all of them or none.
#[pyfunction]
pub fn write_files(py: Python<'_>, folder: PathBuf, files: Read) -> PyResult<()> {
    py.detach(|| {
        let failed = |path: &Path, error: &dyn Display| {
            PyOSError::new_err(format!("writing {}: {error}", path.display()))
        };
        std::fs::create_dir_all(&folder).map_err(|error| failed(&folder, &error))?;
        let mut staged = StagedFiles::default();
        for (name, bytes) in &files {
            let path = folder.join(name);
            let written: io::Result<()> = staged.stage(&path, |out| out.write_all(bytes));
            written.map_err(|error| failed(&path, &error))?;
        }
        staged.publish().map(drop).map_err(|error| PyOSError::new_err(error.to_string()))
    })
}

/// Converts an error of a scene, drawn in its text; a missing file becomes `FileNotFoundError`.
fn refused(error: &SceneError, text: &str, name: &str) -> PyErr {
    let drawn = report::scene_errors::drawn(error, text, name);
    match &error.problem {
        SceneProblem::Surface(surface) if surface.is_missing_file() => {
            PyFileNotFoundError::new_err(message(&drawn))
        }
        _ => input(drawn),
    }
}

/// A value as the key at a place takes it.
pub fn value_of(place: &str, given: &Given<'_>) -> PyResult<Value> {
    typed(place, si_unit(place).unwrap_or_default(), given).map(|value| with_si_unit(place, value))
}

/// Text, numbers and truths, and lists and tables of them; quantities become numbers in a unit.
fn typed(place: &str, unit: &str, given: &Given<'_>) -> PyResult<Value> {
    const NEEDED: &str = "text, a number, true or false, or a list or dictionary of them is needed";
    if let Ok(table) = given.cast::<PyMapping>() {
        let keys = table.items()?.extract::<Vec<(String, Given<'_>)>>()?.into_iter();
        let keys = keys.map(|(key, value)| {
            let value = value_of(&format!("{place}.{key}"), &value)?;
            Ok((key, value))
        });
        return keys.collect::<PyResult<_>>().map(Value::Table);
    }
    let bare = without_unit(place, unit, given)?;
    if let Ok(text) = bare.extract() {
        return Ok(Value::String(text));
    }
    if let Ok(truth) = bare.extract() {
        return Ok(Value::Boolean(truth));
    }
    if let Ok(whole) = bare.extract() {
        return Ok(Value::Integer(whole));
    }
    if bare.len().is_ok() && bare.hasattr("__getitem__")? && !bare.is_instance_of::<PyBytes>() {
        let each = bare.try_iter()?.enumerate();
        let each = each.map(|(at, one)| typed(&format!("{place}[{at}]"), unit, &one?));
        return each.collect::<PyResult<_>>().map(Value::Array);
    }
    number(place, &bare).map(Value::Float).map_err(|_| wrong_type(place, NEEDED, given))
}
