//! The gap between two surfaces, point by point.

use std::borrow::Cow;

use elements::ContactField;
use elements::half_space::{Grid, HalfSpaceError};
use thiserror::Error;

/// Share of the mean gap below which a gap counts as closed: 1e-15 of the mean conductance, less than rounding leaves of a flow.
const CLOSED_BELOW: f64 = 1e-5;

/// Gap between two surfaces at the points of a grid.
#[derive(Debug, Clone)]
pub struct GapField<'g> {
    grid: Grid,
    gaps_m: Cow<'g, [f64]>,
    mean_gap_m: f64,
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
    /// contact, where surfaces overlap, and missing points. So are gaps below 1e-5 of the mean gap.
    ///
    /// # Errors
    /// [`GapFieldError`] for a field of another size than its grid.
    pub fn new(grid: Grid, gaps_m: impl Into<Cow<'g, [f64]>>) -> Result<Self, GapFieldError> {
        let (gaps_m, expected) = (gaps_m.into(), grid.points());
        if gaps_m.len() != expected {
            return Err(HalfSpaceError::Size { given: gaps_m.len(), expected }.into());
        }
        let open = gaps_m.iter().copied().filter(|gap_m| is_open(*gap_m));
        // A sum of nothing is -0.
        let mean_gap_m = open.fold(0.0, |sum, gap_m| sum + gap_m) / expected as f64;
        Ok(GapField { grid, gaps_m, mean_gap_m })
    }

    /// Creates the field of a pressed surface. Points in contact are closed, also where elements leave a gap within their tolerance.
    ///
    /// # Errors
    /// [`GapFieldError`] for a field of another size than its grid.
    pub fn from_contact(field: &ContactField<'g>) -> Result<Self, GapFieldError> {
        Self::new(field.relief.grid()?, field.closed_gaps_m())
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
        if is_open(gap_m) && gap_m > CLOSED_BELOW * self.mean_gap_m { gap_m } else { 0.0 }
    }

    /// Mean of the open gap over all points \[m\].
    #[must_use]
    pub fn mean_gap_m(&self) -> f64 {
        self.mean_gap_m
    }

    /// Share of the points that are closed.
    #[must_use]
    pub fn closed_share(&self) -> f64 {
        let points = self.grid.points();
        (0..points).filter(|&point| self.gap_m(point) == 0.0).count() as f64 / points as f64
    }

    /// The field of every second point, from the first or second along both sides; the last of an odd number is left out. None for
    /// fields less than four points wide or long.
    pub(crate) fn every_second(&self, offset: usize) -> Option<GapField<'static>> {
        let (rows, columns) = (self.grid.rows() / 2, self.grid.columns() / 2);
        if rows < 2 || columns < 2 {
            return None;
        }
        let share = |half: usize, all: usize| (2 * half) as f64 / all as f64;
        let length_x_m = share(columns, self.grid.columns()) * self.grid.length_x_m();
        let length_y_m = share(rows, self.grid.rows()) * self.grid.length_y_m();
        let grid = Grid::new(rows, columns, length_x_m, length_y_m).ok()?;
        let point =
            |at: usize| (2 * (at / columns) + offset) * self.grid.columns() + 2 * (at % columns) + offset;
        let gaps_m: Vec<f64> = (0..rows * columns).map(|at| self.gap_m(point(at))).collect();
        GapField::new(grid, gaps_m).ok()
    }
}

fn is_open(gap_m: f64) -> bool {
    gap_m.is_finite() && gap_m > 0.0
}
