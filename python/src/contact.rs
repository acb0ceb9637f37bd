//! Many states of any populations, as a ufunc has it: rows that were broadcast, and columns that are found.

use std::borrow::Cow;

use numpy::{Element, PyArray1, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyFloat};
use questions::StatesQuestion;
use questions::rows::{RowRoughness, RowsError, STATE_COLUMNS, StateRequest};
use stat_contact::Condition;
use study::models::{self, Framework};

use crate::answer::{PyAnswer, of_material, refused};
use crate::arguments::{Arguments, none_of, text, tolerance};
use crate::errors::{input, of_argument};
use crate::material::PyMaterial;
use crate::work::{carry_out, light};

/// Number of rows that are done before another thread has begun.
const LIGHT_ROWS: usize = 64;

/// Numbers of an argument: one for all rows, as a float, or an array of their shape.
pub enum Numbers<'py> {
    One(f64),
    Many(PyReadonlyArrayDyn<'py, f64>),
}

impl<'py> FromPyObject<'_, 'py> for Numbers<'py> {
    type Error = PyErr;

    // A derived trait would word an error for every array.
    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match given.cast::<PyFloat>() {
            Ok(number) => Ok(Numbers::One(number.value())),
            Err(_) => Ok(Numbers::Many(given.extract()?)),
        }
    }
}

/// Column of numbers: one for every row, or those of the rows in C order, without a copy where they lie so.
enum Column<'a, T: Clone> {
    Constant(T),
    Rows(Cow<'a, [T]>),
}

impl<'a, T: Element + Copy> Column<'a, T> {
    fn of(array: &'a PyReadonlyArrayDyn<'_, T>) -> Self {
        let view = array.as_array();
        let repeats = view.len() > 1
            && array.strides().iter().zip(array.shape()).all(|(stride, len)| *stride == 0 || *len == 1);
        match (view.first().filter(|_| repeats), view.to_slice()) {
            (Some(number), _) => Column::Constant(*number),
            (None, Some(numbers)) => Column::Rows(Cow::Borrowed(numbers)),
            (None, None) => Column::Rows(view.iter().copied().collect()),
        }
    }

    #[inline]
    fn at(&self, row: usize) -> T {
        match self {
            Column::Constant(number) => *number,
            Column::Rows(numbers) => numbers[row],
        }
    }
}

/// States of a model for rows of roughness and, last, condition, all of the same shape, or the numbers of a single one as the
/// column `state`; the condition is a pressure \[Pa\] or a separation \[m\]. The material of a row is that at its index among the `materials`, or the one that there is.
#[pyfunction]
pub fn contact_states<'py>(
    py: Python<'py>,
    given: [Numbers<'py>; 4],
    condition: &str,
    materials: Vec<Py<PyMaterial>>,
    material_index: Option<PyReadonlyArrayDyn<'py, i64>>,
    arguments: Arguments<'py>,
) -> PyResult<PyAnswer> {
    let model = models::named(Framework::Statistical, &arguments.required("model", text)?);
    let question = StatesQuestion {
        model: Some(model.map_err(|error| of_argument("model", error))?),
        options: arguments.model_options()?,
        tolerance: arguments.get("tolerance", tolerance)?,
        skips_bad_rows: match arguments.required("errors", text)?.as_str() {
            "raise" => false,
            "nan" => true,
            other => return Err(none_of("errors", other, ["raise", "nan"])),
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
    let index = material_index.as_ref().map_or(Column::Constant(0), Column::of);
    let asked = |row: usize| StateRequest {
        material: &materials[index.at(row) as usize].get().material,
        roughness: RowRoughness([first.at(row), second.at(row), third.at(row)]),
        at: match is_pressure {
            true => Condition::Pressure(at.at(row)),
            false => Condition::Separation(at.at(row)),
        },
    };
    let states = match rows <= LIGHT_ROWS {
        true => light(py, || states.compute(rows, asked, &numerics::parallel::Unobserved)),
        false => carry_out(py, None, |watch| states.compute(rows, asked, watch))?,
    };
    let (found, counts) = states.map_err(|error| bad_row(&error, shape))?;
    let columns = if shape.is_empty() {
        // An array for each number would take longer than the state.
        let state = found.iter().filter_map(|column| column.first().copied());
        [("state", PyArray1::from_iter(py, state))].into_py_dict(py)?
    } else {
        let arrays = found.into_iter().map(|column| PyArray1::from_vec(py, column));
        STATE_COLUMNS.into_iter().map(|(name, _)| name).zip(arrays).into_py_dict(py)?
    };
    let materials = materials.iter().map(|material| &material.get().material);
    Ok(PyAnswer::of_columns(columns, question.notes_on(materials, &counts, rows)))
}

/// A bad row, by its place in the arrays.
fn bad_row(error: &RowsError, shape: &[usize]) -> PyErr {
    let RowsError::Row { row, problem } = error else { return input(error) };
    if shape.is_empty() {
        return input(of_material(problem));
    }
    let mut rows = shape.iter().product::<usize>();
    let place = shape.iter().map(|len| {
        rows /= len;
        (row / rows % len).to_string()
    });
    let place = place.collect::<Vec<_>>().join(", ");
    of_argument(&format!("element [{place}]"), of_material(problem))
}
