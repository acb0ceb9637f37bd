//! Scenes: what is typed in one, what it reads, and everything that is made of it.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use drawings::model_style::ModelStyle;
use findings::answer::Answer;
use parallel::Progress;
use pyo3::exceptions::{PyFileNotFoundError, PyOSError};
use pyo3::prelude::*;
use pyo3::types::{PyCFunction, PyDict, PyList, PyString, PyTuple};
use questions::{
    OptionName, Phase, ReportSurface, RunError, RunOptions, SamplingInput, Watch, note_code, run_scene,
};
use report::curve_names::short_name;
use report::explain::explain;
use report::products::{Product, SceneProducts};
use report::run_stamp::RunStamp;
use report::scene_note_words;
use report::summary::summary;
use scene::file_names::{JUDGE_TABLES, REPORT_TABLES, UNCERTAINTY_TABLES};
use scene::{Overrides, Scene, SceneError, SceneProblem, Template, with_keys};
use spectrum::ReadOptions;
use staging::StagedFiles;
use staging::reading::bytes_of;
use study::Files;
use study::figure::CurveLook;
use study::surface::{Surface, SurfaceError};
use tables::{Format, Table};
use toml::Value;

use crate::answer::{Told, columns, in_text, refused as questions_refused};
use crate::arguments::{Arguments, Given, named, type_name};
use crate::errors::{input, of_argument};
use crate::material::counterface;
use crate::surface::{PySurface, notes};
use crate::work::{carry_out, light};

/// A scene as the core has it, and the files that it read.
#[pyclass(frozen, name = "Scene", module = "truearea._native")]
pub struct PyScene {
    scene: Scene,
    name: String,
    files: Read,
}

/// Bytes of files by their names in a scene.
type Read = BTreeMap<String, Vec<u8>>;

/// Files below a folder, each read once and kept, so that the scene can be made again where the folder is not.
struct Remembering {
    folder: Option<PathBuf>,
    read: Mutex<Read>,
}

impl Remembering {
    fn kept(
        &self,
        name: &str,
        read: impl FnOnce(&Path) -> io::Result<Option<Vec<u8>>>,
    ) -> io::Result<Option<Vec<u8>>> {
        if let Some(bytes) = held(&self.read).get(name) {
            return Ok(Some(bytes.clone()));
        }
        let Some(folder) = &self.folder else { return Ok(None) };
        let bytes = read(&folder.join(name))?;
        if let Some(bytes) = &bytes {
            held(&self.read).insert(name.to_owned(), bytes.clone());
        }
        Ok(bytes)
    }
}

impl Files for Remembering {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        let bytes = self.kept(name, |path| bytes_of(path).map(Some))?;
        bytes.ok_or_else(|| io::Error::from(io::ErrorKind::NotFound))
    }

    fn read_beside(&self, name: &str, sibling: &str) -> io::Result<Option<Vec<u8>>> {
        let folder = name.rfind('/').map_or("", |end| &name[..=end]);
        self.kept(&format!("{folder}{sibling}"), |path| match path.is_file() {
            true => bytes_of(path).map(Some),
            false => Ok(None),
        })
    }
}

#[pymethods]
impl PyScene {
    /// The scene of a text. Files come from those given, or else from below the folder; a surface in memory counts before the
    /// files of the scene's own.
    #[new]
    fn new(
        py: Python<'_>,
        text: &str,
        name: String,
        folder: Option<PathBuf>,
        files: Read,
        overrides: Arguments<'_>,
        surface: Option<&PySurface>,
    ) -> PyResult<Self> {
        let surface = surface.map(|surface| surface.surface.clone());
        let overrides = Overrides { surface, ..read_overrides(&overrides)? };
        let files = Remembering { folder, read: Mutex::new(files) };
        let scene = light(py, || Scene::parse(text, &files, &overrides));
        let scene = scene.map_err(|error| refused(&error, text, &name))?;
        refuse_idle(&overrides, &scene, &name)?;
        Ok(PyScene { scene, name, files: files.read.into_inner().unwrap_or_else(PoisonError::into_inner) })
    }

    /// Title of the scene.
    #[getter]
    fn title(&self) -> &str {
        &self.scene.title
    }

    /// Notes on the surface, and the keys that have no effect.
    #[getter]
    fn notes(&self) -> Vec<Told> {
        said(&self.scene)
    }

    /// The files that it read.
    #[getter]
    fn files(&self) -> Read {
        self.files.clone()
    }

    /// Number of loads.
    #[getter]
    fn loads(&self) -> usize {
        self.scene.needs.loads.len()
    }

    /// Short name, colour and SVG dash of every curve in figures, by its name.
    fn styles(&self) -> BTreeMap<String, (String, &'static str, String)> {
        let curves = &self.scene.needs.curves;
        let looks = CurveLook::of_curves(curves);
        let styled = curves.iter().zip(looks).map(|(curve, look)| {
            let ModelStyle { colour, dash, .. } = ModelStyle::new(look);
            (curve.name.clone(), (short_name(curve), colour, dash))
        });
        styled.collect()
    }

    /// Explains which steps the scene needs, shares and skips.
    fn explain(&self, py: Python<'_>) -> String {
        light(py, || explain(&self.scene))
    }

    /// Runs the scene and returns all its results: the answer in words, tables with the lines that tell where they come
    /// from, and the bytes of files by name. `observer` is called with the name of the steps at hand, the number done,
    /// and their total where it is known.
    fn run<'py>(
        &self,
        py: Python<'py>,
        report: bool,
        judge: Option<bool>,
        uncertainty: Option<bool>,
        occasion: (Option<String>, Option<String>),
        observer: Option<Py<PyAny>>,
    ) -> PyResult<(String, Bound<'py, PyDict>, Bound<'py, PyDict>)> {
        let asked = RunOptions { report, judge, uncertainty };
        let (date, typed) = occasion;
        let occasion = RunStamp { date, command: typed };
        let state = AtHand::default();
        let observer = observer.map(|observer| told_of(py, observer, state.clone())).transpose()?;
        let made = carry_out(py, observer.as_ref().map(|observer| observer.as_any()), |watch| {
            let watching = Watching { watch, state };
            Made::of(&self.scene, asked, occasion, &watching)
        })?;
        let made = made.map_err(|error| input(format!("{}: {error}", self.name)))?;
        let tables = PyDict::new(py);
        for (name, table, origin) in &made.tables {
            tables.set_item(name, (columns(py, table)?, origin))?;
        }
        let files = PyDict::new(py);
        for (name, bytes) in made.files {
            files.set_item(name, bytes)?;
        }
        Ok((made.answer, tables, files))
    }

    /// The final areas of every curve under every load, and nothing else: `curve`, `nominal_pressure_pa`, `area_fraction`, and
    /// what else the table `report-scales` has.
    fn scales<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let table = carry_out(py, None, |progress| {
            let results = self.scene.plan().compute_observed(progress)?;
            Ok(Answer::from_results(&self.scene, &results).scales_table(&self.scene.needs))
        })?;
        let table =
            table.map_err(|error: study::plan::PlanError| input(format!("{}: {error}", self.name)))?;
        columns(py, &table)
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
    let mut typed = Vec::new();
    for (key, value) in changes {
        let key: String = key.extract()?;
        let value = value_of(&key, &value)?;
        typed.push((key, value));
    }
    let changes = typed.iter().map(|(key, value)| (key.as_str(), value.clone()));
    with_keys(text, changes).map_err(|error| match error {
        scene::ReplaceError::Scene(error) => refused(&error, text, name),
        error => input(error),
    })
}

/// The text of a scene from its sections, in the order that they have. Files become its surface: one spectrum, or scans, each
/// perhaps with what its file leaves open, as on the command line.
#[pyfunction]
pub fn scene_text(sections: &Bound<'_, PyDict>, files: Option<Vec<String>>) -> PyResult<String> {
    let mut parts = Vec::new();
    for (key, value) in sections {
        let key: String = key.extract()?;
        parts.push(match &files {
            Some(files) if key == "surface" => report_surface(files)?.section(),
            _ => {
                let value = value_of(&key, &value)?;
                // One section at a time, since a table of TOML sorts its keys.
                toml::to_string(&toml::Table::from_iter([(key, value)])).map_err(input)?
            }
        });
    }
    Ok(parts.join("\n"))
}

/// One file as a spectrum if it holds one, else all as scans.
fn report_surface(files: &[String]) -> PyResult<ReportSurface> {
    if let [name] = files {
        let here = Remembering { folder: Some(PathBuf::new()), read: Mutex::default() };
        match Surface::load(name, &here, &ReadOptions::default()) {
            Ok(_) => return Ok(ReportSurface::Psd(name.clone())),
            Err(error @ SurfaceError::NoSuchBuiltin { .. }) => return Err(of_argument("surface", error)),
            Err(_) => {}
        }
    }
    let request = |text: &String| text.parse().map_err(|error| of_argument("surface", error));
    files.iter().map(request).collect::<PyResult<_>>().map(ReportSurface::Scans)
}

/// The tables that a run makes of a scene where it makes a report, where it is judged, and where draws are made.
#[pyfunction]
pub fn tables_of_runs() -> [Vec<&'static str>; 3] {
    [REPORT_TABLES.to_vec(), JUDGE_TABLES.to_vec(), UNCERTAINTY_TABLES.to_vec()]
}

/// Writes files into a folder, all of them or none.
#[pyfunction]
pub fn write_files(py: Python<'_>, folder: PathBuf, files: Read) -> PyResult<()> {
    py.detach(|| {
        let failed = |path: &Path, error: &dyn std::fmt::Display| {
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

/// Results of a scene.
struct Made {
    answer: String,
    tables: Vec<(String, Table, Vec<String>)>,
    files: Vec<(String, Vec<u8>)>,
}

impl Made {
    fn of(
        scene: &Scene,
        asked: RunOptions,
        occasion: RunStamp,
        watch: &Watching<'_>,
    ) -> Result<Self, RunError> {
        let outcome = run_scene(scene, asked, watch)?;
        let (evidence, conclusions) = (outcome.evidence(scene), &outcome.conclusions);
        let sensitivities = outcome.sensitivities.as_deref();
        let products = SceneProducts { evidence, conclusions, sensitivities, run_stamp: &occasion };
        let (mut tables, mut files) = (Vec::new(), Vec::new());
        let Ok(()) = products.each(|name, product| {
            let mut bytes = Vec::new();
            product.write(Format::Csv, &mut bytes).expect("memory takes everything");
            files.push((product.file_name(name, Format::Csv), bytes));
            if let Product::Table { table, origin } = product {
                tables.push((name.to_owned(), table.clone(), origin.to_vec()));
            }
            Ok::<(), std::convert::Infallible>(())
        });
        let answer = summary(&evidence, conclusions);
        Ok(Made { answer, tables, files })
    }
}

/// The steps of the phase at hand: their name, how many are done, and of how many, 0 if that is unknown.
type AtHand = Arc<Mutex<Option<(&'static str, usize, usize)>>>;

/// Tells what is being done, and ends the work when it is to end.
struct Watching<'w> {
    watch: &'w dyn Progress,
    state: AtHand,
}

impl Watch for Watching<'_> {
    fn begin(&self, phase: Phase, steps: usize) -> Box<dyn Progress + '_> {
        *held(&self.state) = Some((phase.steps(), 0, steps));
        Box::new(Steps(self))
    }
}

/// The steps of a phase.
struct Steps<'w>(&'w Watching<'w>);

impl Progress for Steps<'_> {
    fn advance(&self, steps: usize) {
        if let Some((_, done, _)) = &mut *held(&self.0.state) {
            *done += steps;
        }
    }

    fn is_cancelled(&self) -> bool {
        self.0.watch.is_cancelled()
    }
}

/// A callable that tells an observer what is being done.
fn told_of<'py>(py: Python<'py>, observer: Py<PyAny>, state: AtHand) -> PyResult<Bound<'py, PyCFunction>> {
    let tell = move |arguments: &Bound<'_, PyTuple>, _: Option<&Bound<'_, PyDict>>| -> PyResult<()> {
        let Some((steps, done, of)) = *held(&state) else { return Ok(()) };
        observer.call1(arguments.py(), (steps, done, (of > 0).then_some(of))).map(drop)
    };
    PyCFunction::new_closure(py, None, None, tell)
}

fn held<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Returns the notes on a scene before anything of it is computed.
fn said(scene: &Scene) -> Vec<Told> {
    let mut said = notes(&scene.surface);
    said.extend(
        scene.notes.iter().map(|note| in_text(scene_note_words::line(note), &note_code(note), note.into())),
    );
    said
}

/// Converts an error of a scene, drawn in its text; a missing file becomes `FileNotFoundError`.
fn refused(error: &SceneError, text: &str, name: &str) -> PyErr {
    let drawn = report::scene_errors::drawn(error, text, name);
    match &error.problem {
        SceneProblem::Surface(surface) if surface.is_missing_file() => PyFileNotFoundError::new_err(drawn),
        _ => input(drawn),
    }
}

fn read_overrides(arguments: &Arguments<'_>) -> PyResult<Overrides> {
    let counterface =
        counterface(arguments)?.map(|body| body.body(OptionName::CounterfacePoissonRatio)).transpose();
    Ok(Overrides {
        normalisation: arguments.named("normalisation")?,
        amplitude: arguments.named("amplitude")?,
        scales_per_decade: arguments.sampling()?.scales_per_decade,
        hardness: arguments.hardness_form()?,
        strength_cap: arguments.quantity("strength_cap")?,
        cutoff: arguments.quantity("cutoff")?,
        counterface: counterface.map_err(questions_refused)?,
        ..Overrides::default()
    })
}

/// Refuses arguments that nothing in the scene has a use for.
fn refuse_idle(overrides: &Overrides, scene: &Scene, name: &str) -> PyResult<()> {
    let cutoff_m = overrides.cutoff.map(|cutoff| cutoff.m);
    let sampling = SamplingInput { cutoff_m, ..SamplingInput::default() };
    sampling.check(&scene.surface).map_err(questions_refused)?;
    match overrides.first_unused(scene) {
        None => Ok(()),
        Some(argument) => Err(input(format!(
            "{argument} has no bearing on {name}: none of its curves and figures depends on it; leave it out"
        ))),
    }
}

/// A value as it is typed in a scene.
fn value_of(key: &str, given: &Given<'_>) -> PyResult<Value> {
    if let Ok(text) = given.cast::<PyString>() {
        return Ok(Value::String(text.to_str()?.to_owned()));
    }
    if let Ok(truth) = given.extract::<bool>() {
        return Ok(Value::Boolean(truth));
    }
    if let Ok(number) = given.extract::<i64>() {
        return Ok(Value::Integer(number));
    }
    if let Ok(number) = given.extract::<f64>() {
        return Ok(Value::Float(number));
    }
    if let Ok(list) = given.cast::<PyList>() {
        return list.iter().map(|value| value_of(key, &value)).collect::<PyResult<_>>().map(Value::Array);
    }
    if let Ok(table) = given.cast::<PyDict>() {
        let keys =
            table.iter().map(|(inner, value)| Ok((inner.extract::<String>()?, value_of(key, &value)?)));
        return keys.collect::<PyResult<_>>().map(Value::Table);
    }
    Err(of_argument(
        key,
        format!(
            "text, a number, true or false, or a list or dictionary of them is needed, and this is {}",
            type_name(given)
        ),
    ))
}
