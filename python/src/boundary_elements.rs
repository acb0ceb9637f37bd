//! Surfaces pressed by boundary elements.

use std::sync::{Mutex, PoisonError};

use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArray2, PyReadwriteArrayDyn};
use pyo3::prelude::*;
use pyo3::types::{PyCFunction, PyTuple};
use questions::{BallQuestion, ElementsQuestion, PreparedBall, PreparedElements, QuestionError};
use rough_bem::{Boundary, Field, Relief, Surfaces};
use scans::HeightMap;
use topography::{Recipe, detrended_m};
use units::{Force, Length};

use crate::answer::{PyAnswer, refused};
use crate::arguments::{Arguments, Given, number, quantity};
use crate::errors::{input, of_argument};
use crate::material::PyMaterial;
use crate::surface::PySurface;
use crate::work::carry_out;

/// A callable that is told of steps: their name, how many are done, and of how many.
type Observer = Option<Py<PyAny>>;

/// Pressures \[Pa\] and gaps \[m\] of surface after surface under load after load, and the heights \[m\] of the surfaces.
type Fields<'py> = (Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArrayDyn<f64>>);

/// Presses a map of heights \[m\], row by row along x, by a flat or by a ball. `repeats` says whether the heights repeat themselves beyond the map, and
/// the argument `periodic` whether they are pressed so.
#[pyfunction]
pub fn press_heights<'py>(
    py: Python<'py>,
    heights_m: PyReadonlyArray2<'py, f64>,
    size: [Given<'py>; 2],
    repeats: bool,
    material: &PyMaterial,
    arguments: Arguments<'py>,
    observer: Observer,
) -> PyResult<(PyAnswer, Option<Fields<'py>>)> {
    let [x, y] = &size;
    let [length_x, length_y]: [Length; 2] = [quantity("size[0]", x)?, quantity("size[1]", y)?];
    let recipe = Recipe { detrend: arguments.named("detrend")?, ..Recipe::default() };
    let view = heights_m.as_array();
    let (rows, columns) = view.dim();
    let spacings_m = [length_x.m / columns as f64, length_y.m / rows as f64];
    let map = HeightMap::new(columns, spacings_m[0], spacings_m[1], view.iter().copied().collect());
    let map = map.map_err(|error| of_argument("h", error))?;
    let relief = Relief {
        rows,
        columns,
        length_x_m: length_x.m,
        length_y_m: length_y.m,
        heights_m: detrended_m(&map, recipe.preparation(repeats).detrend),
        boundary: if arguments.flag("periodic")? { Boundary::Periodic } else { Boundary::Free },
    };
    if let Some(ball) = ball_question(material, &arguments)? {
        return press_ball(py, &ball.on_map(relief).map_err(refused)?, observer);
    }
    let question = question(material, &arguments)?;
    press(py, &question.on_map(relief).map_err(refused)?, &arguments, observer)
}

/// Presses random surfaces that have a spectrum, by a flat or by a ball.
#[pyfunction]
pub fn press_spectrum<'py>(
    py: Python<'py>,
    surface: &PySurface,
    material: &PyMaterial,
    arguments: Arguments<'py>,
    observer: Observer,
) -> PyResult<(PyAnswer, Option<Fields<'py>>)> {
    let random = arguments.random()?;
    if let Some(ball) = ball_question(material, &arguments)? {
        let ball = BallQuestion { random, ..ball };
        return press_ball(py, &ball.on(&surface.surface).map_err(refused)?, observer);
    }
    let question = ElementsQuestion { random, ..question(material, &arguments)? };
    press(py, &question.on(&surface.surface).map_err(refused)?, &arguments, observer)
}

fn question(material: &PyMaterial, arguments: &Arguments<'_>) -> PyResult<ElementsQuestion> {
    let question = ElementsQuestion {
        material: material.input,
        pressures: arguments.pressures()?,
        saturation: arguments.quantity("saturation")?,
        tolerance: arguments.required("tolerance", number)?,
        ..ElementsQuestion::default()
    };
    question.check().map(|()| question).map_err(refused)
}

/// The question about a ball, if `ball_radius` is given.
fn ball_question(material: &PyMaterial, arguments: &Arguments<'_>) -> PyResult<Option<BallQuestion>> {
    let Some(radius_m) = arguments.length_m("ball_radius")? else { return Ok(None) };
    let question = BallQuestion {
        material: material.input,
        radius_m,
        force_n: arguments.required("force", quantity::<Force>)?.n,
        tolerance: arguments.required("tolerance", number)?,
        ..BallQuestion::default()
    };
    question.check().map(|()| Some(question)).map_err(refused)
}

/// Presses a ball onto every surface; the number of steps is not known beforehand.
fn press_ball<'py>(
    py: Python<'py>,
    prepared: &PreparedBall,
    observer: Observer,
) -> PyResult<(PyAnswer, Option<Fields<'py>>)> {
    let observer = counting(py, observer, None)?;
    let answer = carry_out(py, observer.as_ref().map(|observer| observer.as_any()), |progress| {
        prepared.answer(progress)
    })?;
    let answer = answer.map_err(refused)?;
    Ok((PyAnswer::new(py, &answer.table, [prepared.notes.clone(), answer.notes].concat())?, None))
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
fn press<'py>(
    py: Python<'py>,
    prepared: &PreparedElements,
    arguments: &Arguments<'py>,
    observer: Observer,
) -> PyResult<(PyAnswer, Option<Fields<'py>>)> {
    let surfaces = &prepared.surfaces;
    let fields = arguments.flag("fields")?.then(|| empty_fields(py, prepared)).transpose()?;
    let mut written = fields.as_ref().map(|(a, b, c)| [a, b, c].map(|array| array.readwrite()));
    let maps = written.as_mut().map(|[pressures_pa, gaps_m, heights_m]| {
        PyResult::Ok([maps(pressures_pa, surfaces)?, maps(gaps_m, surfaces)?, maps(heights_m, surfaces)?])
    });
    let maps = maps.transpose()?;
    let count = surfaces.count();
    let see = |field: &Field<'_>| -> Result<(), QuestionError> {
        if let Some([pressures_pa, gaps_m, heights_m]) = &maps {
            let at = field.load * count + field.surface;
            write(&pressures_pa[at], field.pressures_pa);
            write(&gaps_m[at], field.gaps_m);
            write(&heights_m[field.surface], &field.relief.heights_m);
        }
        Ok(())
    };
    let observer = counting(py, observer, Some(prepared.steps()))?;
    let observer = observer.as_ref().map(|observer| observer.as_any());
    let pressed = carry_out(py, observer, |progress| prepared.answer(see, progress))?;
    let (loads, notes) = pressed.map_err(refused)?;
    drop(maps);
    drop(written);
    let table = match arguments.flag("per_realisation")? {
        true => rough_bem::states_table(&loads),
        false => rough_bem::means_table(&loads),
    };
    Ok((PyAnswer::new(py, &table, [prepared.notes.clone(), notes].concat())?, fields))
}

/// Arrays of zeros as large as the fields, which numpy refuses where there is no room for them.
fn empty_fields<'py>(py: Python<'py>, prepared: &PreparedElements) -> PyResult<Fields<'py>> {
    let (rows, columns) = points(&prepared.surfaces);
    let of_map = match &prepared.surfaces {
        Surfaces::Random(random) => vec![random.realisations, rows, columns],
        _ => vec![rows, columns],
    };
    let of_load = [vec![prepared.loads()], of_map.clone()].concat();
    let zeros = |shape: &[usize]| -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let zeros = py.import("numpy")?.call_method1("zeros", (PyTuple::new(py, shape)?,))?;
        Ok(zeros.cast_into()?)
    };
    Ok((zeros(&of_load)?, zeros(&of_load)?, zeros(&of_map)?))
}

/// Points along y and along x.
fn points(surfaces: &Surfaces) -> (usize, usize) {
    match surfaces {
        Surfaces::Map(relief) => (relief.rows, relief.columns),
        Surfaces::Random(random) => (random.synthesis.points_y, random.synthesis.points_x),
        _ => (0, 0),
    }
}

/// The maps in an array, one after the other.
fn maps<'a>(
    array: &'a mut PyReadwriteArrayDyn<'_, f64>,
    surfaces: &Surfaces,
) -> PyResult<Vec<Mutex<&'a mut [f64]>>> {
    let (rows, columns) = points(surfaces);
    let slice = array.as_slice_mut().map_err(input)?;
    Ok(slice.chunks_exact_mut((rows * columns).max(1)).map(Mutex::new).collect())
}

fn write(map: &Mutex<&mut [f64]>, values: &[f64]) {
    map.lock().unwrap_or_else(PoisonError::into_inner).copy_from_slice(values);
}
