//! Outline of a specimen among the missing points of a map.

use crate::boundary::Boundary;
use crate::half_space::{Grid, HalfSpaceError};

/// Points of a map that belong to the specimen.
///
/// Missing points that rows and columns of missing points connect with the edge of the frame lie outside the specimen: they are no
/// part of the nominal area. All others are holes: they are part of it. Neither kind ever touches. A periodic map has no outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    pub(crate) grid: Grid,
    pub(crate) boundary: Boundary,
    is_inside: Vec<bool>,
    points: usize,
}

impl Outline {
    /// Finds the outline among the missing points of a map.
    ///
    /// # Errors
    /// [`HalfSpaceError`] if no point has a height, or if `is_missing` has another size than the grid.
    pub fn new(grid: Grid, boundary: Boundary, is_missing: &[bool]) -> Result<Self, HalfSpaceError> {
        grid.check_size(is_missing.len())?;
        if !is_missing.contains(&false) {
            return Err(HalfSpaceError::NoSpecimen);
        }
        let (rows, columns) = (grid.rows(), grid.columns());
        let mut is_inside = vec![true; grid.points()];
        // Points outside whose neighbours have not been visited.
        let mut front = Vec::new();
        let mut leave = |row: usize, column: usize, front: &mut Vec<(usize, usize)>| {
            let point = row * columns + column;
            if is_missing[point] && std::mem::replace(&mut is_inside[point], false) {
                front.push((row, column));
            }
        };
        if boundary == Boundary::Free {
            for column in 0..columns {
                leave(0, column, &mut front);
                leave(rows - 1, column, &mut front);
            }
            for row in 0..rows {
                leave(row, 0, &mut front);
                leave(row, columns - 1, &mut front);
            }
        }
        while let Some((row, column)) = front.pop() {
            let next = [(row.wrapping_sub(1), column), (row + 1, column)];
            let beside = [(row, column.wrapping_sub(1)), (row, column + 1)];
            for (row, column) in next.into_iter().chain(beside) {
                if row < rows && column < columns {
                    leave(row, column, &mut front);
                }
            }
        }
        let points = is_inside.iter().filter(|is_inside| **is_inside).count();
        Ok(Self { grid, boundary, is_inside, points })
    }

    /// Returns for each point of the frame, row by row, true if it belongs to the specimen.
    #[must_use]
    pub fn is_inside(&self) -> &[bool] {
        &self.is_inside
    }

    /// Number of points that belong to the specimen.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }

    /// Nominal area of the specimen over the area of the frame.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.points as f64 / self.grid.points() as f64
    }

    /// Nominal area of the specimen \[m^2\].
    #[must_use]
    pub fn area_m2(&self) -> f64 {
        self.share() * self.grid.length_x_m() * self.grid.length_y_m()
    }
}
