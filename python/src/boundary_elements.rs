//! Surfaces pressed by boundary elements.

use std::sync::{Mutex, PoisonError};

use numpy::ndarray::ArrayView2;
use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArray3, PyReadwriteArrayDyn};
use pyo3::prelude::*;
use pyo3::types::{PyCFunction, PyString, PyTuple};
use questions::{
    BallQuestion, ElementsLoad, ElementsQuestion, PreparedBall, PreparedElements, QuestionError,
};
use rough_bem::{Boundary, Field, RandomSurfaces, Relief, Surfaces};
use scans::HeightMap;
use topography::{Recipe, detrended_m};
use units::{Force, Length};

use crate::answer::{PyAnswer, refused};
use crate::arguments::{Arguments, Given, load, number, quantity};
use crate::errors::{input, of_argument};
use crate::material::PyMaterial;
use crate::surface::PySurface;
use crate::work::carry_out;

/// A callable that is told of steps: their name, how many are done, and of how many.
type Observer = Option<Py<PyAny>>;

/// Pressures \[Pa\] and gaps \[m\] of surface after surface under load after load, and the heights \[m\] of the surfaces.
type Fields<'py> = (Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArrayDyn<f64>>);

/// An answer, its fields, the lengths of a surface along x and y \[m\], and the rms gradient of each map or of all random surfaces.
type Pressed<'py> = (PyAnswer, Option<Fields<'py>>, ((f64, f64), Vec<f64>));

/// Presses maps of heights \[m\], each row by row along x, by a flat, or one of them by a ball. `repeats` says whether the heights
/// repeat themselves beyond the map, and the argument `periodic` whether they are pressed so.
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
    let mut maps = view.outer_iter().map(relief).collect::<PyResult<Vec<_>>>()?;
    if let Some(ball) = ball_question(material, &arguments)? {
        return press_ball(py, &ball.on_map(maps.swap_remove(0)).map_err(refused)?, observer);
    }
    let question = question(material, &arguments)?;
    press(py, &question.on_maps(maps).map_err(refused)?, &arguments, observer)
}

/// Presses random surfaces that have a spectrum, by a flat or by a ball.
#[pyfunction]
pub fn press_spectrum<'py>(
    py: Python<'py>,
    surface: &PySurface,
    material: &PyMaterial,
    arguments: Arguments<'py>,
    observer: Observer,
) -> PyResult<Pressed<'py>> {
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
        loads: loads(arguments)?,
        saturation: arguments.quantity("saturation")?,
        tolerance: arguments.required("tolerance", number)?,
        ..ElementsQuestion::default()
    };
    question.check().map(|()| question).map_err(refused)
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
fn press_ball<'py>(py: Python<'py>, prepared: &PreparedBall, observer: Observer) -> PyResult<Pressed<'py>> {
    let observer = counting(py, observer, None)?;
    let answer = carry_out(py, observer.as_ref().map(|observer| observer.as_any()), |progress| {
        prepared.answer(progress)
    })?;
    let answer = answer.map_err(refused)?;
    let answer = PyAnswer::new(py, &answer.table, [prepared.notes.clone(), answer.notes].concat())?;
    Ok((answer, None, ((0.0, 0.0), Vec::new())))
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
) -> PyResult<Pressed<'py>> {
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
    let answer = PyAnswer::new(py, &table, [prepared.notes.clone(), notes].concat())?;
    Ok((answer, fields, about(surfaces)))
}

/// Arrays of zeros as large as the fields, which numpy refuses where there is no room for them.
fn empty_fields<'py>(py: Python<'py>, prepared: &PreparedElements) -> PyResult<Fields<'py>> {
    let (rows, columns) = points(&prepared.surfaces);
    let of_map = vec![prepared.surfaces.count(), rows, columns];
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
        Surfaces::Maps(maps) => maps.first().map_or((0, 0), |relief| (relief.rows, relief.columns)),
        Surfaces::Random(random) => (random.synthesis.points_y, random.synthesis.points_x),
        _ => (0, 0),
    }
}

/// Lengths along x and y \[m\], and rms gradients.
fn about(surfaces: &Surfaces) -> ((f64, f64), Vec<f64>) {
    match surfaces {
        Surfaces::Maps(maps) => {
            let size_m = maps.first().map_or((0.0, 0.0), |relief| (relief.length_x_m, relief.length_y_m));
            (size_m, maps.iter().map(Relief::rms_gradient).collect())
        }
        Surfaces::Random(RandomSurfaces { band, synthesis, .. }) => {
            ((synthesis.length_x_m, synthesis.length_y_m), vec![band.mean_square_gradient().sqrt()])
        }
        _ => ((0.0, 0.0), Vec::new()),
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
