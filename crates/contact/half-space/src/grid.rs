//! A rectangle of points.

use crate::HalfSpaceError;
use units::Bound;

/// Points in rows and columns over a rectangle, each standing for an element of the same size; a value of point (row, column)
/// stands at `row * columns + column` of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    rows: usize,
    columns: usize,
    length_x_m: f64,
    length_y_m: f64,
}

impl Grid {
    /// `columns` points along x over `length_x_m`, `rows` points along y over `length_y_m`; any numbers, odd ones too.
    ///
    /// One row or one column is a surface that does not change across: a line under plane strain, as a wave of cylinders.
    ///
    /// # Errors
    /// A count of 0 or above 2^16, and lengths that are no magnitudes.
    pub fn new(
        rows: usize,
        columns: usize,
        length_x_m: f64,
        length_y_m: f64,
    ) -> Result<Self, HalfSpaceError> {
        for (along, points) in [("y (rows)", rows), ("x (columns)", columns)] {
            if !(1..=LARGEST_COUNT).contains(&points) {
                return Err(HalfSpaceError::Points { along, points, largest: LARGEST_COUNT });
            }
        }
        Bound::Magnitude.check("length along x in m", length_x_m)?;
        Bound::Magnitude.check("length along y in m", length_y_m)?;
        Ok(Self { rows, columns, length_x_m, length_y_m })
    }

    /// Points along y.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Points along x.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Length along x in m, from a point to its next image.
    #[must_use]
    pub fn length_x_m(&self) -> f64 {
        self.length_x_m
    }

    /// Length along y in m, from a point to its next image.
    #[must_use]
    pub fn length_y_m(&self) -> f64 {
        self.length_y_m
    }

    /// All points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.rows * self.columns
    }

    /// Whether the surface is a line, without changes across it.
    #[must_use]
    pub fn is_line(&self) -> bool {
        self.rows == 1 || self.columns == 1
    }
}

/// Maps beyond this many points along a side are not held in memory anyway.
const LARGEST_COUNT: usize = 1 << 16;
