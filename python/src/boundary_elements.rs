//! Surfaces pressed by boundary elements: by a flat, by a ball, or while they attract each other.

use std::sync::{Mutex, PoisonError};

use numpy::ndarray::ArrayView2;
use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArray3, PyReadwriteArrayDyn};
use parallel::Progress;
use pyo3::prelude::*;
use pyo3::types::{PyCFunction, PyDict, PyString, PyTuple};
use questions::{
    AdhesionQuestion, Answer, BallQuestion, BranchChoice, ElementsLoad, ElementsQuestion, LoadInput, Note,
    PreparedElements, QuestionError,
};
use rough_bem::{Boundary, ElementsError, Field, Relief, Surfaces};
use scans::HeightMap;
use study::surface::Surface;
use topography::{Recipe, detrended_m};
use units::{Force, Length, WorkOfAdhesion};

use crate::answer::{PyAnswer, columns, refused};
use crate::arguments::{Arguments, Given, load, load_within, number, quantity};
use crate::errors::{input, of_argument};
use crate::material::PyMaterial;
use crate::surface::PySurface;
use crate::work::carry_out;

/// A callable that is told of steps: their name, how many are done, and of how many.
type Observer = Option<Py<PyAny>>;

/// Pressures \[Pa\] and gaps \[m\] of surface after surface under load after load, and the heights \[m\] of the surfaces.
type Fields<'py> = [Bound<'py, PyArrayDyn<f64>>; 3];

/// An answer, and beside it what is known of the surfaces by name: `fields`, `size_m`, `rms_gradient`, columns of `patches`,
/// and numbers of adhesion.
type Pressed<'py> = (PyAnswer, Bound<'py, PyDict>);

/// Surfaces before they are pressed: maps, or the spectrum of random ones.
enum Bodies<'a> {
    Maps(Vec<Relief>),
    Spectrum(&'a Surface),
}

/// Presses maps of heights \[m\], each row by row along x. `repeats` says whether the heights repeat themselves beyond the
/// map, and the argument `periodic` whether they are pressed so.
#[pyfunction]
pub fn press_heights<'py>(
    py: Python<'py>,
    heights_m: PyReadonlyArray3<'py, f64>,
    size: [Given<'py>; 2],
    repeats: bool,
    material: &PyMaterial,
    arguments: Arguments<'py>,
    observer: Observer,
) -> PyResult<Pressed<'py>> {
    let [x, y] = &size;
    let [length_x, length_y]: [Length; 2] = [quantity("size[0]", x)?, quantity("size[1]", y)?];
    let recipe = Recipe { detrend: arguments.named("detrend")?, ..Recipe::default() };
    let detrend = recipe.preparation(repeats).detrend;
    let boundary = if arguments.flag("periodic")? { Boundary::Periodic } else { Boundary::Free };
    let view = heights_m.as_array();
    let (_, rows, columns) = view.dim();
    let spacings_m = [length_x.m / columns as f64, length_y.m / rows as f64];
    let relief = |map: ArrayView2<'_, f64>| {
        let map = HeightMap::new(columns, spacings_m[0], spacings_m[1], map.iter().copied().collect());
        let map = map.map_err(|error| of_argument("surface", error))?;
        let heights_m = detrended_m(&map, detrend);
        Ok(Relief { rows, columns, length_x_m: length_x.m, length_y_m: length_y.m, heights_m, boundary })
    };
    let maps = view.outer_iter().map(relief).collect::<PyResult<Vec<_>>>()?;
    press(py, Bodies::Maps(maps), material, &arguments, observer)
}

/// Presses random surfaces that have a spectrum.
#[pyfunction]
pub fn press_spectrum<'py>(
    py: Python<'py>,
    surface: &PySurface,
    material: &PyMaterial,
    arguments: Arguments<'py>,
    observer: Observer,
) -> PyResult<Pressed<'py>> {
    press(py, Bodies::Spectrum(&surface.surface), material, &arguments, observer)
}

/// Asks the question that the arguments make.
fn press<'py>(
    py: Python<'py>,
    bodies: Bodies<'_>,
    material: &PyMaterial,
    arguments: &Arguments<'py>,
    observer: Observer,
) -> PyResult<Pressed<'py>> {
    let (material, random) = (material.input, arguments.random()?);
    let tolerance = arguments.required("tolerance", number)?;
    if let Some(radius_m) = arguments.length_m("ball_radius")? {
        let force_n = arguments.required("force", quantity::<Force>)?.n;
        let question = BallQuestion { material, radius_m, force_n, tolerance, random };
        question.check().map_err(refused)?;
        let prepared = match bodies {
            Bodies::Maps(mut maps) => question.on_map(maps.swap_remove(0)),
            Bodies::Spectrum(surface) => question.on(surface),
        };
        let prepared = prepared.map_err(refused)?;
        return answered(py, &prepared.notes, observer, |progress| prepared.answer(progress));
    }
    if let Some(work) = arguments.quantity::<WorkOfAdhesion>("work_of_adhesion")? {
        let signed = |name: &str, given: &Given<'_>| match given.cast::<PyString>() {
            Ok(text) => LoadInput::parse_signed(text.to_str()?).map_err(|error| of_argument(name, error)),
            Err(_) => load_within(name, given, units::Bound::Finite),
        };
        let question = AdhesionQuestion {
            material,
            pressures: arguments.several("pressure", signed)?.unwrap_or_default(),
            work_of_adhesion_j_per_m2: work.j_per_m2,
            range_m: arguments.required("adhesion_range", quantity::<Length>)?.m,
            branch: arguments.named::<BranchChoice>("branch")?.unwrap_or_default().branch(),
            pull_off: arguments.flag("pull_off")?,
            tolerance,
            per_realisation: arguments.flag("per_realisation")?,
            random,
            ..AdhesionQuestion::default()
        };
        question.check().map_err(refused)?;
        let prepared = match bodies {
            Bodies::Maps(maps) => question.on_maps(maps),
            Bodies::Spectrum(surface) => question.on(surface),
        };
        let prepared = prepared.map_err(refused)?;
        let (answer, beside) = answered(py, &prepared.notes, observer, |progress| prepared.answer(progress))?;
        beside.set_item("rms_gradient", prepared.surfaces.rms_gradients())?;
        return Ok((answer, beside));
    }
    let question = ElementsQuestion {
        material,
        loads: loads(arguments)?,
        saturation: arguments.quantity("saturation")?,
        tolerance,
        random,
        ..ElementsQuestion::default()
    };
    question.check().map_err(refused)?;
    let prepared = match bodies {
        Bodies::Maps(maps) => question.on_maps(maps),
        Bodies::Spectrum(surface) => question.on(surface),
    };
    press_flat(py, &prepared.map_err(refused)?, arguments, observer)
}

/// Pressures, mean gaps or indentations, whichever is given.
fn loads(arguments: &Arguments<'_>) -> PyResult<Vec<ElementsLoad>> {
    let pressure = |name: &str, given: &Given<'_>| match given.cast::<PyString>() {
        Ok(text) => text.to_str()?.parse().map_err(|error| of_argument(name, error)),
        Err(_) => load(name, given).map(ElementsLoad::Pressure),
    };
    let length_m = |name: &str, given: &Given<'_>| quantity::<Length>(name, given).map(|length| length.m);
    let mean_gap = |name: &str, given: &Given<'_>| {
        length_m(name, given).map(|mean_gap_m| ElementsLoad::MeanGap { mean_gap_m })
    };
    let indentation = |name: &str, given: &Given<'_>| {
        length_m(name, given).map(|indentation_m| ElementsLoad::Indentation { indentation_m })
    };
    let given = [
        arguments.several("pressure", pressure)?,
        arguments.several("mean_gap", mean_gap)?,
        arguments.several("indentation", indentation)?,
    ];
    let loads: Vec<ElementsLoad> = given.into_iter().flatten().flatten().collect();
    if loads.is_empty() { Err(of_argument("pressure", "give at least one")) } else { Ok(loads) }
}

/// Finds an answer of which the number of steps is not known beforehand; numbers of adhesion stand beside it.
fn answered<'py>(
    py: Python<'py>,
    notes: &[Note],
    observer: Observer,
    answer: impl FnOnce(&dyn Progress) -> Result<Answer, QuestionError> + Send,
) -> PyResult<Pressed<'py>> {
    let observer = counting(py, observer, None)?;
    let answer = carry_out(py, observer.as_ref().map(|observer| observer.as_any()), answer)?;
    let answer = answer.map_err(refused)?;
    let notes = [notes.to_vec(), answer.notes].concat();
    let beside = PyDict::new(py);
    for note in &notes {
        if let Note::Adhesion(found) = note {
            found.numbers().into_iter().try_for_each(|(name, number)| beside.set_item(name, number))?;
        }
    }
    Ok((PyAnswer::new(py, &answer.table, notes)?, beside))
}

/// Wraps an observer, which is told the name of the steps, how many are done, and of how many.
fn counting<'py>(
    py: Python<'py>,
    observer: Observer,
    steps: Option<usize>,
) -> PyResult<Option<Bound<'py, PyCFunction>>> {
    let told = |observer: Py<PyAny>| {
        PyCFunction::new_closure(py, None, None, move |done: &Bound<'_, PyTuple>, _| -> PyResult<()> {
            observer.call1(done.py(), ("steps", done.get_item(0)?, steps)).map(drop)
        })
    };
    observer.map(told).transpose()
}

/// Presses every surface under every load; the observer is told of the steps.
fn press_flat<'py>(
    py: Python<'py>,
    prepared: &PreparedElements,
    arguments: &Arguments<'py>,
    observer: Observer,
) -> PyResult<Pressed<'py>> {
    let surfaces = &prepared.surfaces;
    let fields = arguments.flag("fields")?.then(|| empty_fields(py, prepared)).transpose()?;
    let mut written = fields.as_ref().map(|fields| fields.each_ref().map(|array| array.readwrite()));
    let maps = written.as_mut().map(|[pressures_pa, gaps_m, heights_m]| {
        PyResult::Ok([maps(pressures_pa, surfaces)?, maps(gaps_m, surfaces)?, maps(heights_m, surfaces)?])
    });
    let maps = maps.transpose()?;
    let count = surfaces.count();
    let patches = arguments.flag("patches")?.then(|| Mutex::new(Vec::new()));
    let see = |field: &Field<'_>| -> Result<(), ElementsError> {
        if let Some([pressures_pa, gaps_m, heights_m]) = &maps {
            let at = field.load * count + field.surface;
            write(&pressures_pa[at], field.pressures_pa);
            write(&gaps_m[at], field.gaps_m);
            write(&heights_m[field.surface], &field.relief.heights_m);
        }
        if let Some(patches) = &patches {
            let found = field.patches()?;
            patches.lock().unwrap_or_else(PoisonError::into_inner).push(found);
        }
        Ok(())
    };
    let observer = counting(py, observer, Some(prepared.steps()))?;
    let observer = observer.as_ref().map(|observer| observer.as_any());
    let pressed = carry_out(py, observer, |progress| prepared.answer(see, progress))?;
    let (loads, notes) = pressed.map_err(|error| refused(error.into()))?;
    drop(maps);
    drop(written);
    let table = match arguments.flag("per_realisation")? {
        true => rough_bem::states_table(&loads),
        false => rough_bem::means_table(&loads),
    };
    let beside = PyDict::new(py);
    beside.set_item("fields", fields)?;
    beside.set_item("size_m", surfaces.size_m().unwrap_or_default())?;
    beside.set_item("rms_gradient", surfaces.rms_gradients())?;
    if let Some(patches) = patches {
        let table = rough_bem::patches_table(patches.into_inner().unwrap_or_else(PoisonError::into_inner));
        beside.set_item("patches", columns(py, &table)?)?;
    }
    Ok((PyAnswer::new(py, &table, [prepared.notes.clone(), notes].concat())?, beside))
}

/// Arrays of zeros as large as the fields, which numpy refuses where there is no room for them.
fn empty_fields<'py>(py: Python<'py>, prepared: &PreparedElements) -> PyResult<Fields<'py>> {
    let [rows, columns] = prepared.surfaces.points().unwrap_or_default();
    let of_map = vec![prepared.surfaces.count(), rows, columns];
    let of_load = [vec![prepared.loads()], of_map.clone()].concat();
    let zeros = |shape: &[usize]| -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let zeros = py.import("numpy")?.call_method1("zeros", (PyTuple::new(py, shape)?,))?;
        Ok(zeros.cast_into()?)
    };
    Ok([zeros(&of_load)?, zeros(&of_load)?, zeros(&of_map)?])
}

/// The maps in an array, one after the other.
fn maps<'a>(
    array: &'a mut PyReadwriteArrayDyn<'_, f64>,
    surfaces: &Surfaces,
) -> PyResult<Vec<Mutex<&'a mut [f64]>>> {
    let points: usize = surfaces.points().unwrap_or_default().iter().product();
    let slice = array.as_slice_mut().map_err(input)?;
    Ok(slice.chunks_exact_mut(points.max(1)).map(Mutex::new).collect())
}

fn write(map: &Mutex<&mut [f64]>, values: &[f64]) {
    map.lock().unwrap_or_else(PoisonError::into_inner).copy_from_slice(values);
}
