//! Points `x y h` on a regular grid, in any order.

use super::Found;
use super::columns::Columns;
use super::header::Header;
use super::style::FORMAT;
use crate::channel::Lateral;
use crate::choice_of_units::Units;
use crate::error::ScanReadError;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::readers::even_axis::{ScanAxis, points_of_grid};

/// A map with its rows in the order of rising y.
pub(super) fn read(
    text: &str,
    columns: &Columns,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Found, ScanReadError> {
    let units = Units::choose(options, header.column_unit(0), header.height_unit(2), notes);
    let height_to_m = units.height_to_m(FORMAT)?;
    let x_to_m = units.length_to_m(FORMAT)?;
    let y_to_m = Units { lateral: options.unit.or(header.column_unit(1)).or(units.lateral), ..units }
        .length_to_m(FORMAT)?;
    columns.refuse_missing_points(text, 0, 2)?;
    columns.refuse_missing_points(text, 1, 2)?;
    let x = axis(text, columns, 0)?;
    let y = axis(text, columns, 1)?;
    let heights = fill(text, columns, &x, &y)?;
    let heights_m = heights.into_iter().map(|height| height.flatten().map(&height_to_m)).collect::<Decoded>();
    let lateral = Lateral::Spacing { x_m: x_to_m(x.spacing), y_m: Some(y_to_m(y.spacing)) };
    Ok(Found { columns: x.count, lateral, heights_m })
}

/// The axis of a column of positions; the error tells which lies farthest off an even one.
fn axis(text: &str, columns: &Columns, column: usize) -> Result<ScanAxis, ScanReadError> {
    let values: Vec<f64> = columns.measured(column).flatten().collect();
    let rounding = columns.rounding(column);
    if let Some(axis) = ScanAxis::fit(values.clone(), rounding) {
        return Ok(axis);
    }
    let nearest = ScanAxis::nearest(values).ok_or(ScanReadError::NoRows)?;
    let off = |value: f64| (value - nearest.position(nearest.index(value))).abs();
    let known = |(row, value): (usize, Option<f64>)| Some((row, value?));
    let (row, position) = (columns.measured(column).enumerate().filter_map(known))
        .reduce(|worst, next| if off(next.1) > off(worst.1) { next } else { worst })
        .unwrap_or((0, nearest.first));
    let (line, axis) = (columns.line_of_row(text, row), if column == 0 { 'x' } else { 'y' });
    let ScanAxis { first, count, .. } = nearest;
    Err(ScanReadError::NotAGrid { line, axis, position, count, first, last: nearest.position(count - 1) })
}

/// The height of every grid point that the file has a line for, which may say that it is missing.
fn fill(
    text: &str,
    columns: &Columns,
    x: &ScanAxis,
    y: &ScanAxis,
) -> Result<Vec<Option<Option<f64>>>, ScanReadError> {
    let points = columns.rows();
    let size = points_of_grid(x, y, points).ok_or(ScanReadError::Scattered {
        points,
        columns: x.count,
        rows: y.count,
    })?;
    let mut heights = vec![None; size];
    // Lines without a position have no height either.
    let positions = || columns.measured(0).zip(columns.measured(1)).map(|(x, y)| Some((x?, y?)));
    let index = |(at_x, at_y): (f64, f64)| y.index(at_y) * x.count + x.index(at_x);
    for (row, (at, height)) in positions().zip(columns.measured(2)).enumerate() {
        let Some(at) = at else { continue };
        let place = &mut heights[index(at)];
        if place.is_some() {
            let first = positions().position(|other| other.map(index) == Some(index(at))).unwrap_or(0);
            let (line, first_line) = (columns.line_of_row(text, row), columns.line_of_row(text, first));
            return Err(ScanReadError::RepeatedPoint { line, first_line, x: at.0, y: at.1 });
        }
        *place = Some(height);
    }
    Ok(heights)
}
