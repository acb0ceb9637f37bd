//! Many states of any populations, as a ufunc has it: rows that were broadcast, and columns that are found.

use numpy::{PyArray1, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat};
use questions::StatesQuestion;
use stat_contact::Condition;
use state_tables::{Roughness, STATE_COLUMNS, StateRequest, StatesError};
use study::models::{self, Framework};

use crate::answer::{PyAnswer, of_material, refused};
use crate::arguments::{Arguments, text};
use crate::columns::Column;
use crate::errors::{input, of_argument};
use crate::material::PyMaterial;
use crate::work::{carry_out, light};

/// Number of rows that are done before another thread has begun.
const LIGHT_ROWS: usize = 64;

/// Numbers for the rows: one for all, as a float, or an array of their shape.
pub enum Numbers<'py> {
    One(f64),
    Many(PyReadonlyArrayDyn<'py, f64>),
}

impl<'py> FromPyObject<'_, 'py> for Numbers<'py> {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match given.cast::<PyFloat>() {
            Ok(number) => Ok(Numbers::One(number.value())),
            Err(_) => Ok(Numbers::Many(given.extract()?)),
        }
    }
}

/// States of a model for rows of roughness and, last, condition, all of the same shape, or the numbers of a single one as the
/// column `state`; the condition is a pressure \[Pa\] or a
/// separation \[m\]. The material of a row is that at its index among the `materials`, or the one that there is.
#[pyfunction]
pub fn contact_states<'py>(
    py: Python<'py>,
    given: [Numbers<'py>; 4],
    condition: &str,
    materials: Vec<Py<PyMaterial>>,
    material_index: Option<PyReadonlyArrayDyn<'py, i64>>,
    arguments: Arguments<'py>,
) -> PyResult<PyAnswer> {
    let model = arguments.required("model", text)?;
    let question = StatesQuestion {
        model: Some(
            models::named(Framework::Statistical, &model).map_err(|error| of_argument("model", error))?,
        ),
        options: arguments.model_options()?,
        tolerance: arguments.number("tolerance", None)?,
        skips_bad_rows: match arguments.required("errors", text)?.as_str() {
            "raise" => false,
            "nan" => true,
            other => return Err(of_argument("errors", format!("'{other}' is none of raise, nan"))),
        },
    };
    let states = question.states().map_err(refused)?;
    let shape = match &given[0] {
        Numbers::One(_) => &[][..],
        Numbers::Many(array) => array.shape(),
    };
    let (rows, is_pressure) = (shape.iter().product::<usize>(), condition == "pressure");
    let [first, second, third, at] = given.each_ref().map(|numbers| match numbers {
        Numbers::One(number) => Column::Constant(*number),
        Numbers::Many(array) => Column::of(array),
    });
    if rows > 0 && materials.is_empty() {
        return Err(of_argument("material", "it is empty; give at least one"));
    }
    let of_material = material_index.as_ref().map(Column::of);
    let material_of = |row: usize| match &of_material {
        None => 0,
        Some(index) => index.at(row) as usize,
    };
    let asked = |row: usize| StateRequest {
        material: &materials[material_of(row)].get().material,
        roughness: Roughness([first.at(row), second.at(row), third.at(row)]),
        at: match is_pressure {
            true => Condition::Pressure(at.at(row)),
            false => Condition::Separation(at.at(row)),
        },
    };
    let states = match rows <= LIGHT_ROWS {
        true => light(py, || states.compute(rows, asked, &parallel::Unobserved)),
        false => carry_out(py, None, |progress| states.compute(rows, asked, progress))?,
    };
    let (found, counts) = states.map_err(|error| bad_row(&error, shape))?;
    let columns = PyDict::new(py);
    if shape.is_empty() {
        // An array for each number would take longer than the state.
        let state = found.iter().filter_map(|column| column.first().copied());
        columns.set_item("state", PyArray1::from_iter(py, state))?;
    } else {
        for (name, column) in STATE_COLUMNS.into_iter().zip(found) {
            columns.set_item(name, PyArray1::from_vec(py, column))?;
        }
    }
    let materials = materials.iter().map(|material| &material.get().material);
    Ok(PyAnswer::of_columns(columns, question.notes_on(materials, &counts, rows)))
}

/// A bad row, by its place in the arrays.
fn bad_row(error: &StatesError, shape: &[usize]) -> PyErr {
    let StatesError::Row { row, problem } = error else { return input(error) };
    let mut rest = *row;
    let mut place: Vec<String> = Vec::new();
    for len in shape.iter().rev() {
        place.insert(0, (rest % len).to_string());
        rest /= len;
    }
    match place.is_empty() {
        true => input(of_material(problem)),
        false => of_argument(&format!("element [{}]", place.join(", ")), of_material(problem)),
    }
}
