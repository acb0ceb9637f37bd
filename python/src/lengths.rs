//! Lengths of arrays that are in some unit.

use numpy::ndarray::ArrayD;
use numpy::{PyArrayDyn, PyReadonlyArrayDyn, ToPyArray};
use pyo3::prelude::*;
use units::LengthUnit;

use crate::errors::of_argument;

/// Lengths in m, of lengths in a unit, each rounded once; a new array in C order.
#[pyfunction]
pub fn in_metres<'py>(
    py: Python<'py>,
    argument: &str,
    unit: &str,
    lengths: PyReadonlyArrayDyn<'py, f64>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let unit: LengthUnit = unit.parse().map_err(|error| of_argument(argument, error))?;
    let in_unit = lengths.as_array();
    let in_m =
        ArrayD::from_shape_vec(in_unit.raw_dim(), in_unit.iter().map(|length| unit.to_m(*length)).collect());
    Ok(in_m.map_err(|error| of_argument(argument, error))?.to_pyarray(py))
}
