//! Flow through gaps, point by point.

use elements::half_space::Grid;
use numpy::{
    PyArray1, PyArrayMethods, PyReadonlyArray2, PyReadonlyArray3, PyReadonlyArrayDyn, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use questions::flow::{FlowEdges, GapMap, GapMapError};
use report::chart::maps::FieldPicture;

use crate::answer::{PyAnswer, refused};
use crate::arguments::{Arguments, Given, choice, length_m};
use crate::errors::{input, of_argument};
use crate::scans::{HeldFiles, Options, refused as refused_file, request};
use crate::work::{Observer, carry_out, light};

/// A gap: a file among some that were read, with its options; or an array \[m\] with the lengths along x and y, and whether it repeats
/// itself, if that is known.
#[derive(FromPyObject)]
pub enum Gap<'py> {
    File(String, HeldFiles, Options<'py>),
    Array(PyReadonlyArrayDyn<'py, f64>, [Given<'py>; 2], Option<bool>),
}

impl Gap<'_> {
    fn map(self, py: Python<'_>) -> PyResult<GapMap> {
        match self {
            Gap::File(name, files, options) => {
                let request = request(name, options)?;
                light(py, || GapMap::read(&request, &files)).map_err(|error| match error {
                    GapMapError::File(error) => refused_file(&error, ""),
                    error => input(error),
                })
            }
            Gap::Array(gaps_m, size, is_periodic) => {
                let &[rows, columns] = gaps_m.shape() else {
                    return Err(of_argument("gap", "one map of rows and columns is needed"));
                };
                let (x_m, y_m) = (length_m("size[0]", &size[0])?, length_m("size[1]", &size[1])?);
                Ok(GapMap {
                    grid: Grid::new(rows, columns, x_m, y_m).map_err(|error| of_argument("gap", error))?,
                    gaps_m: gaps_m.as_array().iter().copied().collect(),
                    own_edges: is_periodic.unwrap_or_default().then_some(FlowEdges::Periodic),
                    notes: Vec::new(),
                    provenance: String::new(),
                })
            }
        }
    }
}

/// Flow through a gap: an answer, and beside it the gap, its size along x and y, and the flow through each point by name.
#[pyfunction]
pub fn flow_of_gap<'py>(
    py: Python<'py>,
    gap: Gap<'py>,
    arguments: Arguments<'py>,
    observer: Option<&Observer<'py>>,
) -> PyResult<(PyAnswer, Bound<'py, PyDict>)> {
    let edges = arguments.get("edges", choice::<FlowEdges>)?;
    let gap = gap.map(py)?;
    let (flow, answer) = carry_out(py, observer, |watch| gap.flow(edges, watch))?.map_err(refused)?;
    let (rows, columns) = (gap.grid.rows(), gap.grid.columns());
    let beside = PyDict::new(py);
    for (name, flow) in [("flow_along_x", flow.along_x), ("flow_along_y", flow.along_y)] {
        let mut components = flow.flux.into_flattened();
        components.resize(2 * rows * columns, 0.0);
        beside.set_item(name, PyArray1::from_vec(py, components).reshape([rows, columns, 2])?)?;
    }
    beside.set_item("size_m", [gap.grid.length_x_m(), gap.grid.length_y_m()])?;
    beside.set_item("gap_m", PyArray1::from_vec(py, gap.gaps_m).reshape([rows, columns])?)?;
    Ok((PyAnswer::new(py, &answer.table, answer.notes)?, beside))
}

/// The flow along an axis through each point of a gap \[m\] on a rectangle of a size in m, as SVG.
#[pyfunction]
pub fn flow_picture(
    axis: &str,
    flow: PyReadonlyArray3<'_, f64>,
    gap_m: PyReadonlyArray2<'_, f64>,
    size_m: [f64; 2],
) -> String {
    let flux: Vec<f64> = flow.as_array().iter().copied().collect();
    let gaps_m: Vec<f64> = gap_m.as_array().iter().copied().collect();
    let columns = gap_m.shape()[1];
    FieldPicture::of_flow(axis, None, flux.as_chunks().0, &gaps_m, columns, size_m).document()
}
