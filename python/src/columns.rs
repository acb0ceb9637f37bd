//! Numbers of an argument for every row: views of arrays as they lie, without a copy.

use numpy::ndarray::ArrayViewD;
use numpy::{Element, PyReadonlyArrayDyn, PyUntypedArrayMethods};

/// An array of the broadcast shape of a call, row by row in C order.
pub enum Column<'a, T = f64> {
    /// One number for every row.
    Constant(T),
    /// A number after the other.
    Slice(&'a [T]),
    /// A number somewhere in memory.
    Strided(ArrayViewD<'a, T>),
}

impl<'a, T: Element + Copy> Column<'a, T> {
    /// The column of an array.
    pub fn of(array: &'a PyReadonlyArrayDyn<'_, T>) -> Self {
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
    pub fn at(&self, row: usize) -> T {
        match self {
            Column::Constant(value) => *value,
            Column::Slice(values) => values[row],
            Column::Strided(view) => strided(view, row),
        }
    }
}

fn strided<T: Copy>(view: &ArrayViewD<'_, T>, row: usize) -> T {
    let mut index = view.raw_dim();
    let mut rest = row;
    for axis in (0..view.ndim()).rev() {
        let len = view.shape()[axis];
        index[axis] = rest % len;
        rest /= len;
    }
    view[index]
}
