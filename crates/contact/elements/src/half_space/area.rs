//! Areas from the number of points in contact.

use crate::half_space::Grid;

/// Contribution of the staircase around a spot to its area, as a share of its steps: (pi - 1 + ln 2)/24.
///
/// Yastrebov, Anciaux & Molinari (2017), Tribology International 114, 161.
pub(crate) const PERIMETER_SHARE: f64 = (std::f64::consts::PI - 1.0 + std::f64::consts::LN_2) / 24.0;

/// Count of points of one kind, with the number of changes between them and the others along rows and columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Count {
    /// Share of the nominal points.
    pub(crate) share: f64,
    /// Share of the nominal points by which their perimeter makes the count too large or too small.
    pub(crate) perimeter: f64,
}

/// Counts points, as shares of so many `nominal_points`; the edges of the grid close if it is `periodic`.
///
/// On a line the ends of a segment lose or gain nothing on average, so its perimeter counts for nothing.
pub(crate) fn count(grid: &Grid, periodic: bool, nominal_points: usize, is: impl Fn(usize) -> bool) -> Count {
    let (rows, columns) = (grid.rows(), grid.columns());
    let (mut points, mut changes) = (0usize, 0usize);
    for row in 0..rows {
        for column in 0..columns {
            let here = is(row * columns + column);
            points += usize::from(here);
            let right = neighbour(column, columns, periodic).map(|column| row * columns + column);
            let below = neighbour(row, rows, periodic).map(|row| row * columns + column);
            for next in [right, below] {
                changes += usize::from(next.map_or(here, |next| is(next) != here));
            }
            if !periodic {
                changes += usize::from(here && column == 0) + usize::from(here && row == 0);
            }
        }
    }
    let total = nominal_points as f64;
    let perimeter = if grid.is_line() { 0.0 } else { PERIMETER_SHARE * changes as f64 / total };
    Count { share: points as f64 / total, perimeter }
}

/// Next of `count` places in a row; `None` beyond an edge that does not close.
fn neighbour(at: usize, count: usize, periodic: bool) -> Option<usize> {
    if at + 1 < count { Some(at + 1) } else { periodic.then_some(0) }
}

/// Extrapolates the area to infinite resolution, from the corrected areas on a grid and on every second point of it:
/// once the perimeter is taken off, the error is of first order in the spacing.
///
/// The result is limited to \[0, 1\].
#[must_use]
pub fn extrapolated_area(corrected_fine: f64, corrected_coarse: f64) -> f64 {
    (2.0 * corrected_fine - corrected_coarse).clamp(0.0, 1.0)
}

impl Count {
    /// No points of the kind.
    pub(crate) const NONE: Count = Count { share: 0.0, perimeter: 0.0 };
}
