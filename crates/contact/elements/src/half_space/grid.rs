//! Rectangular grid of points.

use std::f64::consts::TAU;

use crate::half_space::HalfSpaceError;
use units::Bound;

/// Points in rows and columns over a rectangle, each the centre of an element of the same size. The value of point
/// (row, column) is at `row * columns + column` of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    rows: usize,
    columns: usize,
    length_x_m: f64,
    length_y_m: f64,
}

impl Grid {
    /// Creates a grid of `columns` points along x over `length_x_m` and `rows` points along y over `length_y_m`; odd
    /// numbers are fine.
    ///
    /// One row or one column is a surface that does not change across: a line under plane strain, like a wave of
    /// cylinders.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a count of 0 or above 2^16, and for lengths that are not finite and positive.
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

    /// Number of points along y.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of points along x.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Length along x, from a point to its next image \[m\].
    #[must_use]
    pub fn length_x_m(&self) -> f64 {
        self.length_x_m
    }

    /// Length along y, from a point to its next image \[m\].
    #[must_use]
    pub fn length_y_m(&self) -> f64 {
        self.length_y_m
    }

    /// Number of all points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.rows * self.columns
    }

    /// Checks that a map has a value for each point.
    pub(crate) fn check_size(&self, given: usize) -> Result<(), HalfSpaceError> {
        let expected = self.points();
        if given == expected { Ok(()) } else { Err(HalfSpaceError::Size { given, expected }) }
    }

    /// Checks that there is a finite height \[m\] for each point.
    pub(crate) fn check_heights(&self, heights_m: &[f64]) -> Result<(), HalfSpaceError> {
        self.check_size(heights_m.len())?;
        for &height_m in heights_m {
            Bound::Signed.check("height in m", height_m)?;
        }
        Ok(())
    }

    /// Wave number that makes pressures and displacements dimensionless: one wave along the longer side.
    pub(crate) fn unit_wave_number_per_m(&self) -> f64 {
        TAU / self.length_x_m.max(self.length_y_m)
    }

    /// True if the surface is a line, without changes across it.
    #[must_use]
    pub fn is_line(&self) -> bool {
        self.rows == 1 || self.columns == 1
    }
}

/// Largest number of points along a side; larger maps do not fit into memory.
const LARGEST_COUNT: usize = 1 << 16;
