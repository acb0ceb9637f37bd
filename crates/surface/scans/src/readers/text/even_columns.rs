//! Columns that rise or fall throughout, as positions do.

use super::columns::Columns;
use crate::readers::even_axis::even_spacing;

/// Returns true if the numbers of a column rise or fall from each row to the next.
pub(super) fn is_monotone(columns: &Columns, column: usize) -> bool {
    let known = || columns.measured(column).flatten();
    let pairs = || known().zip(known().skip(1));
    known().nth(1).is_some() && (pairs().all(|(a, b)| a < b) || pairs().all(|(a, b)| a > b))
}

/// Returns true if the numbers of a column rise or fall by equal steps, within the rounding of their digits.
pub(super) fn is_even(columns: &Columns, column: usize) -> bool {
    let mut positions: Vec<f64> = columns.measured(column).flatten().collect();
    if positions.first() > positions.last() {
        positions.reverse();
    }
    even_spacing(&positions, columns.rounding(column)).is_some()
}

/// Returns true if the first two columns are the places of points that fill a grid, one each.
pub(super) fn is_grid(columns: &Columns) -> bool {
    let distinct = |column: usize| {
        let mut values: Vec<f64> = columns.measured(column).flatten().collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values.len()
    };
    let (x, y) = (distinct(0), distinct(1));
    x > 1 && y > 1 && x * y == columns.rows()
}

/// Returns true if all rows of a column are the same.
pub(super) fn is_constant(columns: &Columns, column: usize) -> bool {
    let mut known = columns.measured(column).flatten();
    known.next().is_some_and(|first| known.all(|value| value == first))
}

/// Returns true if the numbers of a column count: whole, from 0 or 1 on, by steps of one.
pub(super) fn is_counting(columns: &Columns, column: usize) -> bool {
    let known = || columns.measured(column).flatten();
    let first = known().next().filter(|first| [0.0, 1.0].contains(first));
    first.is_some_and(|first| known().enumerate().all(|(at, value)| value == first + at as f64))
}
