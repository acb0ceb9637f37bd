//! Numbers of an argument for every row: views of arrays as they lie, without a copy.

use numpy::ndarray::ArrayViewD;
use numpy::{PyReadonlyArrayDyn, PyUntypedArrayMethods};

/// An array of the broadcast shape of a call, row by row in C order.
pub enum Column<'a> {
    /// The same for every row.
    Constant(f64),
    /// A number after the other.
    Slice(&'a [f64]),
    /// A number somewhere in memory.
    Strided(ArrayViewD<'a, f64>),
}

impl<'a> Column<'a> {
    /// The column of an array; `rows` are as many as it has elements.
    pub fn of(array: &'a PyReadonlyArrayDyn<'_, f64>) -> Self {
        let view = array.as_array();
        if view.len() > 1
            && array.strides().iter().zip(array.shape()).all(|(stride, len)| *stride == 0 || *len == 1)
        {
            return view.first().map_or(Column::Slice(&[]), |value| Column::Constant(*value));
        }
        match view.to_slice() {
            Some(slice) => Column::Slice(slice),
            None => Column::Strided(view),
        }
    }

    /// The number of a row.
    #[inline]
    pub fn at(&self, row: usize) -> f64 {
        match self {
            Column::Constant(value) => *value,
            Column::Slice(values) => values[row],
            Column::Strided(view) => strided(view, row),
        }
    }
}

fn strided(view: &ArrayViewD<'_, f64>, row: usize) -> f64 {
    let mut index = view.raw_dim();
    let mut rest = row;
    for axis in (0..view.ndim()).rev() {
        let len = view.shape()[axis];
        index[axis] = rest % len;
        rest /= len;
    }
    view[index]
}
