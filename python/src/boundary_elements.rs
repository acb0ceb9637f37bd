//! Surfaces pressed by boundary elements: by a flat, by a ball, or while they attract each other.

use std::sync::{Mutex, PoisonError};

use elements::{Boundary, ContactField, ElementsError, IndenterShape, Relief};
use numpy::ndarray::ArrayView2;
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray3};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use questions::{
    AdhesionQuestion, BranchChoice, ElementsLoad, ElementsQuestion, IndenterQuestion, LoadInput,
    PreparedElements, QuestionError,
};
use scans::HeightMap;
use study::surface::Surface;
use topography::{Recipe, detrended_m};
use units::{Force, WorkOfAdhesion};

use crate::answer::{PyAnswer, columns, refused};
use crate::arguments::{Arguments, Given, choice, length_m, load, load_within, number, quantity};
use crate::errors::of_argument;
use crate::material::PyMaterial;
use crate::surface::PySurface;
use crate::work::{Observer, carry_out, held};

/// An answer, and beside it what is known of the surfaces by name: `fields`, `size_m`, `rms_gradient`, columns of `patches`,
/// and numbers of adhesion.
type Pressed<'py> = (PyAnswer, Bound<'py, PyDict>);

/// Surfaces before they are pressed: maps, or the spectrum of random ones.
enum Bodies<'a> {
    Maps(Vec<Relief>),
    Spectrum(&'a Surface),
}

impl Bodies<'_> {
    /// Prepares the surfaces by one of two methods of a question.
    fn prepared<P>(
        self,
        on_maps: impl FnOnce(Vec<Relief>) -> Result<P, QuestionError>,
        on: impl FnOnce(&Surface) -> Result<P, QuestionError>,
    ) -> PyResult<P> {
        let prepared = match self {
            Bodies::Maps(maps) => on_maps(maps),
            Bodies::Spectrum(surface) => on(surface),
        };
        prepared.map_err(refused)
    }
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
    observer: Option<&Observer<'py>>,
) -> PyResult<Pressed<'py>> {
    let [length_x_m, length_y_m] = [length_m("size[0]", &size[0])?, length_m("size[1]", &size[1])?];
    let recipe = Recipe { detrend: arguments.get("detrend", choice)?, ..Recipe::default() };
    let detrend = recipe.preparation(repeats).detrend;
    let boundary = if arguments.flag("periodic")? { Boundary::Periodic } else { Boundary::Free };
    let view = heights_m.as_array();
    let (_, rows, columns) = view.dim();
    let (x_m, y_m) = (length_x_m / columns as f64, length_y_m / rows as f64);
    let relief = |map: ArrayView2<'_, f64>| {
        let map = HeightMap::new(columns, x_m, y_m, map.iter().copied().collect());
        let heights_m = detrended_m(&map.map_err(|error| of_argument("surface", error))?, detrend);
        Ok(Relief { rows, columns, length_x_m, length_y_m, heights_m, boundary })
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
    observer: Option<&Observer<'py>>,
) -> PyResult<Pressed<'py>> {
    press(py, Bodies::Spectrum(&surface.surface), material, &arguments, observer)
}

/// Asks the question that the arguments make.
fn press<'py>(
    py: Python<'py>,
    bodies: Bodies<'_>,
    material: &PyMaterial,
    arguments: &Arguments<'py>,
    observer: Option<&Observer<'py>>,
) -> PyResult<Pressed<'py>> {
    let (material, random) = (material.input, arguments.random()?);
    let tolerance = arguments.required("tolerance", number)?;
    if let Some(radius_m) = arguments.get("ball_radius", length_m)? {
        let force = arguments.required("force", quantity::<Force>)?.n;
        let shape = IndenterShape::Ball;
        let question = IndenterQuestion { material, shape, radius_m, force, tolerance, random };
        let prepared = bodies
            .prepared(|mut maps| question.on_map(maps.swap_remove(0)), |surface| question.on(surface))?;
        let answer = PyAnswer::carry_out(py, observer, |watch| prepared.answer(watch))?;
        return Ok((answer.behind(prepared.notes), PyDict::new(py)));
    }
    if let Some(WorkOfAdhesion { j_per_m2 }) = arguments.get("work_of_adhesion", quantity)? {
        let signed = |name: &str, given: &Given<'_>| match given.cast::<PyString>() {
            Ok(text) => LoadInput::parse_signed(text.to_str()?).map_err(|error| of_argument(name, error)),
            Err(_) => load_within(name, given, units::Bound::Finite),
        };
        let question = AdhesionQuestion {
            material,
            pressures: arguments.several("pressure", signed)?.unwrap_or_default(),
            work_of_adhesion_j_per_m2: j_per_m2,
            range_m: arguments.required("adhesion_range", length_m)?,
            branch: arguments.get("branch", choice::<BranchChoice>)?.unwrap_or_default().branch(),
            pull_off: arguments.flag("pull_off")?,
            tolerance,
            per_realisation: arguments.flag("per_realisation")?,
            random,
            ..AdhesionQuestion::default()
        };
        let prepared = bodies.prepared(|maps| question.on_maps(maps), |surface| question.on(surface))?;
        let answer =
            PyAnswer::carry_out(py, observer, |watch| prepared.answer(watch))?.behind(prepared.notes);
        let beside = PyDict::new(py);
        beside.set_item("rms_gradient", prepared.surfaces.rms_gradients())?;
        for note in &answer.notes {
            if note.code.name().starts_with("adhesion.") {
                let numbers = note.numbers.iter().filter_map(|(name, _)| Some((name, note.number(name)?)));
                numbers.into_iter().try_for_each(|(name, number)| beside.set_item(name, number))?;
            }
        }
        return Ok((answer, beside));
    }
    let question = ElementsQuestion {
        material,
        loads: loads(arguments)?,
        saturation: arguments.get("saturation", quantity)?,
        tolerance,
        random,
        ..ElementsQuestion::default()
    };
    let prepared = bodies.prepared(|maps| question.on_maps(maps), |surface| question.on(surface))?;
    press_flat(py, &prepared, arguments, observer)
}

/// Pressures, mean gaps or indentations, whichever is given.
fn loads(arguments: &Arguments<'_>) -> PyResult<Vec<ElementsLoad>> {
    let pressure = |name: &str, given: &Given<'_>| match given.cast::<PyString>() {
        Ok(text) => text.to_str()?.parse().map_err(|error| of_argument(name, error)),
        Err(_) => load(name, given).map(ElementsLoad::Pressure),
    };
    let mean_gaps = arguments.several("mean_gap", length_m)?.unwrap_or_default().into_iter();
    let indentations = arguments.several("indentation", length_m)?.unwrap_or_default().into_iter();
    let mut loads = arguments.several("pressure", pressure)?.unwrap_or_default();
    loads.extend(mean_gaps.map(|mean_gap_m| ElementsLoad::MeanGap { mean_gap_m }));
    loads.extend(indentations.map(|indentation_m| ElementsLoad::Indentation { indentation_m }));
    if loads.is_empty() { Err(of_argument("pressure", "give at least one")) } else { Ok(loads) }
}

/// Presses every surface under every load.
fn press_flat<'py>(
    py: Python<'py>,
    prepared: &PreparedElements,
    arguments: &Arguments<'py>,
    observer: Option<&Observer<'py>>,
) -> PyResult<Pressed<'py>> {
    let (surfaces, count) = (&prepared.surfaces, prepared.surfaces.count());
    let [rows, width] = surfaces.points().unwrap_or_default();
    let points = rows * width;
    // Pressures and gaps of surface after surface under load after load, and the heights of the surfaces.
    let shapes = [vec![prepared.loads(), count, rows, width], vec![count, rows, width]];
    let [of_loads, of_surfaces] = shapes.each_ref();
    let room = || PyResult::Ok(Mutex::new([zeros(of_loads)?, zeros(of_loads)?, zeros(of_surfaces)?]));
    let fields = arguments.flag("fields")?.then(room).transpose()?;
    let patches = arguments.flag("patches")?.then(|| Mutex::new(Vec::new()));
    let see = |field: &ContactField<'_>| -> Result<(), ElementsError> {
        if let Some(fields) = &fields {
            let [pressures_pa, gaps_m, heights_m] = &mut *held(fields);
            let at = points * (field.load * count + field.surface);
            pressures_pa[at..at + points].copy_from_slice(field.pressures_pa);
            gaps_m[at..at + points].copy_from_slice(field.gaps_m);
            let at = points * field.surface;
            heights_m[at..at + points].copy_from_slice(&field.relief.heights_m);
        }
        if let Some(patches) = &patches {
            let found = field.patches()?;
            held(patches).push(found);
        }
        Ok(())
    };
    let pressed = carry_out(py, observer, |watch| {
        watch.begin("steps", Some(prepared.steps()));
        prepared.answer(see, watch)
    })?;
    let (loads, notes) = pressed.map_err(|error| refused(error.into()))?;
    let table = match arguments.flag("per_realisation")? {
        true => elements::states_table(&loads),
        false => elements::means_table(&loads),
    };
    let fields = fields.map(|fields| {
        let [pressures_pa, gaps_m, heights_m] = fields.into_inner().unwrap_or_else(PoisonError::into_inner);
        let array = |values, shape: &Vec<usize>| PyArray1::from_vec(py, values).reshape(&shape[..]);
        PyResult::Ok([
            array(pressures_pa, of_loads)?,
            array(gaps_m, of_loads)?,
            array(heights_m, of_surfaces)?,
        ])
    });
    let beside = PyDict::new(py);
    beside.set_item("fields", fields.transpose()?)?;
    beside.set_item("size_m", surfaces.size_m().unwrap_or_default())?;
    beside.set_item("rms_gradient", surfaces.rms_gradients())?;
    if let Some(patches) = patches {
        let patches = patches.into_inner().unwrap_or_else(PoisonError::into_inner);
        beside.set_item("patches", columns(py, &elements::patches_table(patches))?)?;
    }
    Ok((PyAnswer::new(py, &table, [prepared.notes.clone(), notes].concat())?, beside))
}

/// Zeros of a shape.
///
/// # Errors
/// MemoryError where there is no room for them.
fn zeros(shape: &[usize]) -> PyResult<Vec<f64>> {
    let length = shape.iter().try_fold(1, |length: usize, axis| length.checked_mul(*axis));
    let (mut zeros, length) = (Vec::new(), length.unwrap_or(usize::MAX));
    let told = |_| PyMemoryError::new_err(format!("no room for fields of shape {shape:?}"));
    zeros.try_reserve_exact(length).map_err(told)?;
    zeros.resize(length, 0.0);
    Ok(zeros)
}
