//! Tables as dictionaries of arrays.

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tables::{Cell, Cells, Table};

/// The columns of a table by their names: numbers as arrays of doubles, NaN where a cell is empty, as data frames have it;
/// anything else as a list of text.
pub fn columns<'py>(py: Python<'py>, table: &Table) -> PyResult<Bound<'py, PyDict>> {
    let columns = PyDict::new(py);
    for (name, cells) in table.columns() {
        match cells {
            Cells::Numbers(numbers) => {
                let numbers = numbers.iter().map(|number| number.unwrap_or(f64::NAN));
                columns.set_item(name, PyArray1::from_iter(py, numbers))?;
            }
            Cells::Words(words) => columns.set_item(name, words)?,
            Cells::Typed(cells) => {
                columns.set_item(name, cells.iter().map(Cell::text).collect::<Vec<_>>())?;
            }
        }
    }
    Ok(columns)
}
