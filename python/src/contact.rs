//! Many states of any populations, as a ufunc has it: rows that were broadcast, and columns that are found.

use numpy::{PyArray1, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;
use report::row_notes;
use report::summary::notes_of_states;
use state_tables::{
    ContactStates, Roughness, RowsNote, StateColumns, StateCondition, StateRequest, StatesError, StatesFound,
};
use study::material::Material;
use study::models::{self, Framework};
use study::plan::Tolerance;

use crate::columns::Column;
use crate::curves::model_options;
use crate::errors::{input, of_argument};
use crate::material::{PyMaterial, told, told_in_words};
use crate::work::{carry_out, light};

/// Number of rows that are done before another thread has begun.
const LIGHT_ROWS: usize = 64;

/// Names of the columns, in the order of [`StateColumns`].
const COLUMNS: [&str; 8] = [
    "separation_m",
    "pressure_pa",
    "area_fraction",
    "ln_pressure",
    "ln_area_fraction",
    "stiffness_pa_per_m",
    "error_estimate",
    "out_of_range_load_share",
];

/// A column under its name.
type Named<'py> = (&'static str, Bound<'py, PyArray1<f64>>);

/// States of a model for rows of roughness and condition, all of the same shape. The material of a row is that at its index among
/// the `materials`, or the one that there is.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the arguments of a call from Python, by name")]
pub fn contact_states<'py>(
    py: Python<'py>,
    model: &str,
    roughness: [PyReadonlyArrayDyn<'py, f64>; 3],
    materials: Vec<Py<PyMaterial>>,
    material_index: Option<PyReadonlyArrayDyn<'py, i64>>,
    pressure_pa: Option<PyReadonlyArrayDyn<'py, f64>>,
    separation_m: Option<PyReadonlyArrayDyn<'py, f64>>,
    tolerance: f64,
    strain_gradient: bool,
    hardness: Option<&str>,
    interference_law: Option<&str>,
) -> PyResult<(Vec<Named<'py>>, Vec<String>)> {
    let entry = models::named(Framework::Statistical, model).map_err(|error| of_argument("model", error))?;
    let states = ContactStates {
        entry,
        options: model_options(entry, strain_gradient, hardness, interference_law)?,
        tolerance: Tolerance::new(tolerance).map_err(input)?,
    };
    let rows = roughness[0].len();
    let of_roughness = roughness.each_ref().map(Column::of);
    let (of_condition, is_pressure) = match (&pressure_pa, &separation_m) {
        (Some(pressure_pa), None) => (Column::of(pressure_pa), true),
        (None, Some(separation_m)) => (Column::of(separation_m), false),
        (Some(_), Some(_)) => return Err(input("pressure and separation are both given; give one of them")),
        (None, None) => return Err(input("pressure or separation is needed; give one of them")),
    };
    let materials: Vec<Material> = materials.iter().map(|material| material.get().material).collect();
    let of_material = material_index.as_ref().map(Column::of);
    let material_of = |row: usize| match &of_material {
        None => materials.first(),
        Some(index) => usize::try_from(index.at(row)).ok().and_then(|at| materials.get(at)),
    };
    if rows > 0 && materials.is_empty() {
        return Err(input("material: it is empty; give at least one"));
    }
    let asked = |row: usize| StateRequest {
        material: material_of(row).unwrap_or(&materials[0]),
        roughness: Roughness(of_roughness.each_ref().map(|column| column.at(row))),
        at: match is_pressure {
            true => StateCondition::Pressure(of_condition.at(row)),
            false => StateCondition::Separation(of_condition.at(row)),
        },
    };
    let found: [Bound<'py, PyArray1<f64>>; 8] = std::array::from_fn(|_| PyArray1::zeros(py, rows, false));
    let mut written = found.each_ref().map(|column| column.readwrite());
    let [a, b, c, d, e, f, g, h] = written.each_mut();
    let slice = |column| numpy::PyReadwriteArray1::as_slice_mut(column).map_err(input);
    let columns = StateColumns {
        separation_m: slice(a)?,
        pressure_pa: slice(b)?,
        area_fraction: slice(c)?,
        ln_pressure: slice(d)?,
        ln_area_fraction: slice(e)?,
        stiffness_pa_per_m: slice(f)?,
        error_estimate: slice(g)?,
        out_of_range_load_share: slice(h)?,
    };
    let done = match rows <= LIGHT_ROWS {
        true => light(py, || states.fill_in(columns, asked, &parallel::Unobserved)),
        false => carry_out(py, None, |progress| states.fill_in(columns, asked, progress))?,
    };
    let done = done.map_err(|error| refused(&error, roughness[0].shape()))?;
    drop(written);
    Ok((COLUMNS.into_iter().zip(found).collect(), notes(&done, rows)))
}

/// A bad row, by its place in the arrays.
fn refused(error: &StatesError, shape: &[usize]) -> PyErr {
    let StatesError::Row { row, problem } = error else { return input(error) };
    let mut rest = *row;
    let mut place: Vec<String> = Vec::new();
    for len in shape.iter().rev() {
        place.insert(0, (rest % len).to_string());
        rest /= len;
    }
    match place.is_empty() {
        true => told(problem),
        false => input(format!("element [{}]: {}", place.join(", "), told_in_words(problem))),
    }
}

fn notes(found: &StatesFound, all: usize) -> Vec<String> {
    let (rows, narrow) = (found.assumed_strengths, found.narrow);
    let assumed = (rows > 0).then_some(RowsNote::AssumedStrengths { rows, all });
    let narrow = (narrow.count > 0).then_some(RowsNote::NarrowSpectra { narrow, all });
    let notes = assumed.into_iter().chain(narrow).flat_map(|note| row_notes::lines(&note));
    notes.chain(notes_of_states(&found.counts)).collect()
}
