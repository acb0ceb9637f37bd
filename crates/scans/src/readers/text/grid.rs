//! Points `x y h` on a regular grid, in any order.

use super::Found;
use super::columns::Columns;
use super::header::Header;
use super::profile::even_spacing;
use super::style::FORMAT;
use crate::channel::Lateral;
use crate::choice_of_units::Units;
use crate::error::ScanReadError;
use crate::options::ScanOptions;
use crate::raster::Decoded;

/// One axis of a grid.
struct Axis {
    first: f64,
    spacing: f64,
    count: usize,
}

/// A map with its rows in the order of rising y.
pub(super) fn read(
    text: &str,
    columns: &Columns,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Found, ScanReadError> {
    let units = Units::of(options, header.column_unit(0), header.height_unit(2), notes);
    let height_to_m = units.height_to_m(FORMAT)?;
    let x_to_m = units.length_to_m(FORMAT)?;
    let y_to_m = Units { lateral: options.unit.or(header.column_unit(1)).or(units.lateral), ..units }
        .length_to_m(FORMAT)?;
    columns.refuse_gaps(text, 0, 2)?;
    columns.refuse_gaps(text, 1, 2)?;
    let x = Axis::find(text, columns, 0)?;
    let y = Axis::find(text, columns, 1)?;
    let heights = fill(text, columns, &x, &y)?;
    let heights_m = heights.into_iter().map(|height| height.flatten().map(&height_to_m)).collect::<Decoded>();
    let lateral = Lateral::Spacing { x_m: x_to_m(x.spacing), y_m: Some(y_to_m(y.spacing)) };
    Ok(Found { columns: x.count, lateral, heights_m })
}

impl Axis {
    fn find(text: &str, columns: &Columns, column: usize) -> Result<Self, ScanReadError> {
        let rounding = columns.rounding(column);
        let mut values: Vec<f64> = columns.measured(column).flatten().collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        let (Some(&first), Some(&last)) = (values.first(), values.last()) else {
            return Err(ScanReadError::NoRows);
        };
        if values.len() == 1 {
            // One column or row, which the map refuses with its own words.
            return Ok(Self { first, spacing: 1.0, count: 1 });
        }
        if let Some(spacing) = even_spacing(&values, rounding) {
            return Ok(Self { first, spacing, count: values.len() });
        }
        // Instruments print the same position with a last digit that varies. The first of a group stands for it, so
        // that a creeping sequence of close values does not merge into one; groups must lie well apart.
        let mut groups = values.clone();
        groups.dedup_by(|value, group| *value - *group <= 2.0 * rounding);
        if let Some(spacing) = even_spacing(&groups, 3.0 * rounding)
            && spacing > 8.0 * rounding
        {
            return Ok(Self { first, spacing, count: groups.len() });
        }
        let count = values.len();
        let axis = Self { first, spacing: (last - first) / (count - 1) as f64, count };
        let off = |value: f64| (value - axis.position(axis.index(value))).abs();
        let known = |(row, value): (usize, Option<f64>)| Some((row, value?));
        let (row, position) = (columns.measured(column).enumerate().filter_map(known))
            .reduce(|worst, next| if off(next.1) > off(worst.1) { next } else { worst })
            .unwrap_or((0, first));
        let (line, axis) = (columns.line_of_row(text, row), if column == 0 { 'x' } else { 'y' });
        Err(ScanReadError::NotAGrid { line, axis, position, count, first, last })
    }

    fn index(&self, position: f64) -> usize {
        // A saturating conversion; the bound holds for positions between the first and the last.
        (((position - self.first) / self.spacing).round() as usize).min(self.count - 1)
    }

    fn position(&self, index: usize) -> f64 {
        self.first + index as f64 * self.spacing
    }
}

/// How many times as many grid points as points there may be; the others are gaps. More would be no map, and two scattered
/// points could demand a vast grid.
const SPARSEST: usize = 4;

/// The height of every grid point that the file has a line for, which may say that it is a gap.
fn fill(
    text: &str,
    columns: &Columns,
    x: &Axis,
    y: &Axis,
) -> Result<Vec<Option<Option<f64>>>, ScanReadError> {
    let points = columns.rows();
    let size = x.count.checked_mul(y.count).filter(|&size| size / SPARSEST <= points);
    let size = size.ok_or(ScanReadError::Scattered { points, columns: x.count, rows: y.count })?;
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
