//! Heights as they are pressed.

use half_space::{Contact, Grid, HalfSpaceError, Loading, PeriodicElements};
use parallel::Progress;
use serde::{Deserialize, Serialize};
use units::named;

/// What lies beyond the edges of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Boundary {
    /// The same map again, without end.
    Periodic,
    /// A half-space without load.
    Free,
}

named!(Boundary, "boundary", { Periodic => "periodic", Free => "free" });

/// Heights on a grid of rows along x, and what lies beyond its edges.
#[derive(Clone, Debug, PartialEq)]
pub struct Relief {
    /// Points along y.
    pub rows: usize,
    /// Points along x.
    pub columns: usize,
    /// Length along x \[m\], `columns` spacings.
    pub length_x_m: f64,
    /// Length along y \[m\], `rows` spacings.
    pub length_y_m: f64,
    /// Heights \[m\], row by row, the one at (row, column) at row * columns + column; higher points touch first.
    pub heights_m: Vec<f64>,
    /// What lies beyond the edges.
    pub boundary: Boundary,
}

impl Relief {
    /// Every second point of every second row; `None` where a side is odd.
    #[must_use]
    pub fn every_second_point(&self) -> Option<Self> {
        if !(self.rows.is_multiple_of(2) && self.columns.is_multiple_of(2)) {
            return None;
        }
        let rows = self.heights_m.chunks_exact(self.columns).step_by(2);
        let heights_m = rows.flat_map(|row| row.iter().step_by(2).copied()).collect();
        Some(Self { rows: self.rows / 2, columns: self.columns / 2, heights_m, ..*self })
    }

    /// Presses it once.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for heights or loads that cannot be pressed, and where the work is ended from outside.
    pub fn press(&self, loading: &Loading, progress: &dyn Progress) -> Result<Contact, HalfSpaceError> {
        let grid = Grid::new(self.rows, self.columns, self.length_x_m, self.length_y_m)?;
        match self.boundary {
            Boundary::Periodic => PeriodicElements::new(grid, &self.heights_m)?.press(loading, progress),
            Boundary::Free => PeriodicElements::new(grid, &self.heights_m)?.press(loading, progress),
        }
    }
}
