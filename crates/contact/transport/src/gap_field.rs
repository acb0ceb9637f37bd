//! The gap between two surfaces, point by point.

use elements::half_space::{Grid, HalfSpaceError};
use thiserror::Error;

/// Gap between two surfaces at the points of a grid.
#[derive(Debug, Clone, Copy)]
pub struct GapField<'g> {
    grid: Grid,
    gaps_m: &'g [f64],
}

/// Reason why a gap field is refused.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum GapFieldError {
    /// The field has another size than its grid.
    #[error(transparent)]
    Grid(#[from] HalfSpaceError),
}

impl<'g> GapField<'g> {
    /// Creates the field of the gaps \[m\] at the points of a grid, row by row. Points without a positive, finite gap are closed:
    /// contact, where elements overlap by rounding, and missing points.
    ///
    /// # Errors
    /// [`GapFieldError`] for a field of another size than its grid.
    pub fn new(grid: Grid, gaps_m: &'g [f64]) -> Result<Self, GapFieldError> {
        let expected = grid.points();
        if gaps_m.len() != expected {
            return Err(HalfSpaceError::Size { given: gaps_m.len(), expected }.into());
        }
        Ok(GapField { grid, gaps_m })
    }

    /// The grid.
    #[must_use]
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Gap at a point \[m\]; 0 where it is closed.
    #[must_use]
    pub fn gap_m(&self, point: usize) -> f64 {
        let gap_m = self.gaps_m[point];
        if gap_m.is_finite() { gap_m.max(0.0) } else { 0.0 }
    }

    /// Mean of the open gap over all points \[m\].
    #[must_use]
    pub fn mean_gap_m(&self) -> f64 {
        let points = self.grid.points();
        (0..points).map(|point| self.gap_m(point)).sum::<f64>() / points as f64
    }

    /// Share of the points that are closed.
    #[must_use]
    pub fn closed_share(&self) -> f64 {
        let points = self.grid.points();
        (0..points).filter(|&point| self.gap_m(point) == 0.0).count() as f64 / points as f64
    }
}
